// SPDX-License-Identifier: MIT
// Inputs for measurements of single stages, behind the C ABI.
#pragma once

#include <string_view>
#include <vector>

#include "core/vec.h"

namespace flg::bench {

// A built-in style with `count` points even in arc length, and its length.
struct EvenStyle {
    std::vector<Vec3> points;
    double length;
};
EvenStyle even_style(std::string_view name, uint32_t count);

}  // namespace flg::bench
