// SPDX-License-Identifier: MIT
// Outlines as they are met with, made here: letters of a plain and of a rounded alphabet, coastlines, silhouettes of
// meshes. Counter-clockwise, simple.
#pragma once

#include <vector>

#include "skeletons/point2.h"

namespace flg::bench {

using Ring = std::vector<Point2>;

// A class by the number of its points: below 15, 15 to 99, 100 to 999, and 1,000 and more.
struct OutlineClass {
    const char* name;
    std::vector<Ring> rings;
};

std::vector<OutlineClass> outline_classes();

}  // namespace flg::bench
