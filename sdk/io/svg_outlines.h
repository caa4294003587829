// SPDX-License-Identifier: MIT
// From the shapes of SVG to outlines: polylines in the drawing's plane, curves flattened to within a thousandth of their own
// size.
#pragma once

#include <array>
#include <vector>

#include "io/svg_tags.h"

namespace flg::io {

struct SvgPoint {
    double x = 0, y = 0;
};

// x' = a x + c y + e, y' = b x + d y + f.
struct SvgTransform {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    SvgPoint operator()(const SvgPoint& p) const { return {a * p.x + c * p.y + e, b * p.x + d * p.y + f}; }
    // First the other one, then this one.
    SvgTransform operator*(const SvgTransform& other) const;
};

// `translate(1 2) rotate(30)`; "" is none. Fails on what is none of matrix, translate, scale, rotate, skewX and skewY.
SvgTransform read_transform(std::string_view text, uint64_t line);

struct SvgOutline {
    std::vector<SvgPoint> points;
    bool closed = false;
};

// The outlines of a path, polygon, polyline, line, rect, circle or ellipse, not yet transformed; none of other elements.
// Fails with FLG_ERROR_LIMIT beyond 2^24 points.
std::vector<SvgOutline> read_outlines(const SvgTag& tag);

}  // namespace flg::io
