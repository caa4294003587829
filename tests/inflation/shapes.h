// SPDX-License-Identifier: MIT
// Contours for the tests, and parts made of them.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "inflation/inflate_part.h"
#include "inflation/part_mesh.h"
#include "inflation/part_raster.h"
#include "runtime/run_now.h"

namespace flg::test {

using Ring = std::vector<Point2>;
using Rings = std::vector<Ring>;

inline Memory* test_memory() {
    return std::pmr::new_delete_resource();
}

inline Contour contour_of(const Rings& rings) {
    std::vector<Point2> points;
    std::vector<uint32_t> offsets = {0};
    for (const Ring& ring : rings) {
        points.insert(points.end(), ring.begin(), ring.end());
        offsets.push_back(static_cast<uint32_t>(points.size()));
    }
    return clean_contour(points, offsets, test_memory());
}

inline Ring ellipse(double x, double y, double a, double b, uint32_t n = 200) {
    Ring ring;
    for (uint32_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        ring.push_back({x + a * std::cos(angle), y + b * std::sin(angle)});
    }
    return ring;
}

// Around the segment from (x0, y0) to (x1, y1), with radii at its ends.
inline Ring capsule(double x0, double y0, double r0, double x1, double y1, double r1, uint32_t n = 40) {
    Ring ring;
    const double along = std::atan2(y1 - y0, x1 - x0);
    const double lean = std::acos((r0 - r1) / std::hypot(x1 - x0, y1 - y0));
    for (uint32_t i = 0; i <= n; ++i) {
        const double angle = along + lean - 2 * lean * i / n;
        ring.push_back({x1 + r1 * std::cos(angle), y1 + r1 * std::sin(angle)});
    }
    for (uint32_t i = 0; i <= n; ++i) {
        const double angle = along - lean - (2 * std::numbers::pi - 2 * lean) * i / n;
        ring.push_back({x0 + r0 * std::cos(angle), y0 + r0 * std::sin(angle)});
    }
    return ring;
}

// What the task that make(pace) returns makes; it pauses at each opportunity if `haltingly`.
template <class Make>
auto made(const Make& make, bool haltingly) {
    return run_now(test_memory(), make, haltingly);
}

inline InflatedPart mesh_of(const Rings& rings, const InflationOptions& options = {}, bool haltingly = false) {
    InflatedPart part(test_memory());
    part.contour = contour_of(rings);
    made([&](Pace& pace) { return part_mesh(pace, options, part); }, haltingly);
    return part;
}

inline InflatedPart heights_of(const Rings& rings, const InflationOptions& options = {}, bool haltingly = false) {
    InflatedPart part = mesh_of(rings, options, haltingly);
    made([&](Pace& pace) { return height_field(pace, part); }, haltingly);
    return part;
}

inline InflatedPart part_of(const Rings& rings, const InflationOptions& options = {}, bool haltingly = false) {
    InflatedPart part = heights_of(rings, options, haltingly);
    made([&](Pace& pace) { return part_raster(pace, part); }, haltingly);
    return part;
}

inline PartSurface surface_of(const InflatedPart& part, bool haltingly = false) {
    return made([&](Pace& pace) { return two_sided_mesh(pace, part); }, haltingly);
}

}  // namespace flg::test
