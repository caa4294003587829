// SPDX-License-Identifier: MIT
// A value a vertex, as text: one a line, `inf` where there is none.
#pragma once

#include <string>
#include <vector>

namespace flg::cli {

// Throws InputError.
std::vector<float> read_field_file(const std::string& name);

}  // namespace flg::cli
