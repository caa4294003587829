// SPDX-License-Identifier: MIT
// Values as JSON.
#pragma once

#include <string>
#include <string_view>

namespace flg::io {

bool is_utf8(std::string_view text);

// In quotes, with what JSON escapes escaped; of UTF-8.
std::string json_text(std::string_view text);

// A float's shortest text as a double: readers get exactly the float.
std::string json_number(float value);

}  // namespace flg::io
