// SPDX-License-Identifier: MIT
// Names of the brushes of .tilt sketches.
#pragma once

#include <string_view>

namespace flg::io {

// The name that the painting program gives to a brush, or "" if its GUID (lower case, no braces) is not known.
std::string_view tilt_brush_name(std::string_view guid);

}  // namespace flg::io
