// SPDX-License-Identifier: MIT
// Values as JSON.
#pragma once

#include <string>
#include <string_view>

#include "core/origin.h"

namespace flg::io {

bool is_utf8(std::string_view text);

// In quotes, with what JSON escapes escaped; of UTF-8.
std::string json_text(std::string_view text);

// A float's shortest text as a double: readers get exactly the float.
std::string json_number(double value);
inline std::string json_number(float value) {
    return json_number(double{value});
}

// `[x,y,z]`.
std::string json_triple(double x, double y, double z);

// `,"translation":[x,y,z]`, a glTF node's; empty for none.
std::string json_translation(const Origin& origin);

}  // namespace flg::io
