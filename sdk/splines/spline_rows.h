// SPDX-License-Identifier: MIT
// Places along a spline of R^3, evenly by its length: what is laid along a curve begins from these.
//
// Between two nodes the curve is a cubic Hermite piece with the derivatives that differences over three nodes give: off
// the cubic spline through the nodes by the fourth power of their distance.
#pragma once

#include <vector>

#include "splines/spline.h"

namespace flg {

struct SplineRow {
    Vec3 place, way;  // unit length
    Vec3 normal;      // of the surface, unit length; 0 of curves that are on none
    double length;    // metres, from the beginning
    double time;      // parameter
};

struct SplineRows {
    explicit SplineRows(Memory* memory) : rows(memory) {}
    std::pmr::vector<SplineRow> rows;  // of a closed curve also its end, the first one again
    double length = 0;
};

inline constexpr uint32_t max_spline_rows = 1u << 20;

// spacing: metres, rounded so that it fits the length a whole number of times; 0: rows are nodes. Throws a Failure for
// more than max_spline_rows; a closed curve has 3 and its end at least. About 200 ns a node and a row.
Task<SplineRows> rows_along(Pace& pace, const Spline& spline, double spacing);

}  // namespace flg
