// SPDX-License-Identifier: MIT
// Contours of files: NAME.poly.txt, `x y` a line, rings apart by empty lines, what follows a # ignored; and
// RealSkel's SketchPolyline*.txt, how many points there are and then `x y z` a line, where the first point comes
// again at the end; and .svg, whose outlines are the rings, y upwards, the largest first. Rings that are not closed
// there are all the same.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace flg::cli {

struct ContourArrays {
    std::vector<double> points;  // 2 a point
    std::vector<uint32_t> offsets = {0};
    double depth = 0;  // z of a sketch, the same at all points
};

// Throws InputError, with the line, for what is none.
ContourArrays read_contour_file(const std::string& path);

struct Outlines {
    std::vector<ContourArrays> contours;  // in the file's order
    std::vector<std::string> warnings;    // sentences: what was left out
};

// Of a .svg its outlines, each with those directly within it as holes; other files are one. Left out are lines of two
// points, and dots of the pen: what is smaller than 1/100 of the drawing. Throws as that does.
Outlines read_outlines(const std::string& path);

}  // namespace flg::cli
