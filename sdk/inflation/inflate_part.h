// SPDX-License-Identifier: MIT
// A drawn part with a body: the triangulation of its contour, a height over each vertex, and a raster of both.
//
// Heights of a part: -lap g = 4 inside, g = 0 on the border, height = thickness * sqrt(g) (Dvoroznak et al.: Monster
// Mash, 2020, sec. 4.1, with its constant c = 4 and the thickness apart from it). By linear finite elements and a
// Cholesky factorization. With 4 a disc of radius r gets g = r^2 - x^2 - y^2, which is half a ball; an ellipse gets an
// ellipsoid. The surface is round at the border wherever g leaves it with a slope.
//
// The surface of a part: its triangulation twice, lifted to both sides of its plane, with the border in common. Closed,
// and a manifold because the triangulation has no chords; outside is where triangles turn counter-clockwise. A part
// with h holes has genus h.
#pragma once

#include <span>

#include "core/vec.h"
#include "inflation/mesh_laplacian.h"
#include "skeletons/contour.h"

namespace flg {

struct InflationOptions {
    // How thick a part gets, as a factor: 1 makes a ball of a disc, and of a long strip a tube sqrt(2) times as deep as
    // it is wide; 0.7071 makes that tube round. Above 0.
    double thickness = 1;
    // Length of edges, in units of the contour; 0: from the part's area and how narrow it is, for 500 to 3,000
    // vertices.
    double spacing = 0;
};

// Values of the part on a grid, beyond its border too: the square of the height at thickness 1 inside, below zero
// outside, where it falls as a ball's would: -(k d + d^2) at a distance d from where the border is as steep as k.
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

// Reads points, on_border and triangles of the part; fills squares and highest. The part outlives the task.
Task<void> height_field(Pace& pace, InflatedPart& part);

struct PartSurface {
    // In the part's plane, z = height: first the vertices of the part, then those inside once more.
    Buffer<Vec3> positions;
    Buffer<TriangleVertices> triangles;
};

// Of a part with heights, which outlives the task.
Task<PartSurface> two_sided_mesh(Pace& pace, const InflatedPart& part);

// Fills `part`, whose contour is given and which outlives the task. Throws, with a sentence, for contours that cross
// themselves. Takes about 3 ms for a part of 700 vertices.
Task<void> inflate_part(Pace& pace, InflationOptions options, InflatedPart& part);

}  // namespace flg
