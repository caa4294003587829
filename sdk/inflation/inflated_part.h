// SPDX-License-Identifier: MIT
// A drawn part with a body: the triangulation of its contour and a height over each vertex.
#pragma once

#include <span>

#include "inflation/mesh_laplacian.h"
#include "skeletons/contour.h"

namespace flg {

struct InflationOptions {
    // How thick a part gets, as a factor: 1 makes a ball of a disc, and of a long strip a tube sqrt(2) times as deep as it is wide;
    // 0.7071 makes that tube round. Above 0.
    double thickness = 1;
    // Length of edges, in units of the contour; 0: from the part's area and how narrow it is, for 500 to 3,000 vertices.
    double spacing = 0;
};

// Values of the part on a grid, beyond its border too: the square of the height at thickness 1 inside, below zero outside, where
// it falls as a ball's would: -(k d + d^2) at a distance d from where the border is as steep as k.
struct PartRaster {
    double at(uint32_t x, uint32_t y) const { return values[size_t{y} * width + x]; }

    Point2 origin{};     // of value (0, 0), in units of the contour
    double spacing = 0;  // between values
    uint32_t width = 0, height = 0;
    Buffer<double> values;
};

struct InflatedPart {
    explicit InflatedPart(Memory* memory) : contour(memory) {}

    Contour contour;
    double thickness = 1;
    double spacing = 0;     // of the triangulation, units of the contour
    double area = 0;        // of the contour
    double highest = 0;     // largest height, with the thickness
    Buffer<Point2> points;  // in the part's plane
    Buffer<uint8_t> on_border;
    Buffer<double> squares;              // of heights at thickness 1; 0 on the border
    Buffer<TriangleVertices> triangles;  // counter-clockwise
    PartRaster raster;
};

}  // namespace flg
