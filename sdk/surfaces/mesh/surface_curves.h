// SPDX-License-Identifier: MIT
// Curves on a mesh as tracing makes them and cutting embeds them: straight within each triangle.
//
// Invariants
// - Curve c has the points offsets[c] to offsets[c + 1] - 1; at least two of them (closed ones three). The last point
//   of a closed curve is joined to the first, which is not repeated.
// - The stretch from a point to the next lies in the triangle that the point names, borders included; the last point of
//   an open curve names the triangle of the stretch before it.
// - Points on an edge or a vertex are so exactly: the other weights are 0.
#pragma once

#include <deque>

#include "surfaces/mesh/surface_point.h"

namespace flg {

struct SurfaceCurves {
    explicit SurfaceCurves(Memory* memory) : points(memory), offsets(memory), closed(memory), values(memory) {
        offsets.push_back(0);
    }

    uint32_t curve_count() const { return static_cast<uint32_t>(closed.size()); }

    // Deques grow without moving what is there, however long the curves.
    std::pmr::deque<SurfacePoint> points;
    std::pmr::deque<uint32_t> offsets;
    std::pmr::deque<bool> closed;
    std::pmr::deque<float> values;  // of an isoline: its value; else of the curve's end, as its maker says
};

}  // namespace flg
