// SPDX-License-Identifier: MIT
// The isolines of a field at many levels in one pass, ordered into loops and chains: the contour lines of sec. 4.2
// (Line tracing) of Nazzaro, Puppo, Pellacini: geoTangle (2021).
//
// Invariants
// - A value at or above the level counts as above it, in every triangle alike. So a triangle has at most one segment a
//   level, segments join across edges without exception, and saddles and plateaus need no case of their own: an isoline
//   passes a plateau of exactly its value on the lower side.
// - Higher values lie on the left, seen from outside.
// - A chain ends where the mesh, the regions or the finite values end; all other isolines are closed.
// - At a point the field, interpolated on its edge, differs from the level by at most 2^-24 of the edge's difference.
//   Points are on the edges they cross, or on vertices of exactly the level's value (or as near as that).
// - Segments without length (at a vertex of the level's value) are left out, and so are curves that keep fewer points
//   than a curve must have: those around a single vertex or edge.
#pragma once

#include <span>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

constexpr uint32_t max_isoline_levels = 65534;

// `values`: one a vertex, linear in each triangle; triangles with one that is not finite hold no isoline. `levels`:
// finite, rising, at most max_isoline_levels. Appends to `out`, values being the levels; first the chains, then the
// loops, each kind by the triangle it begins in. About 5 ns a vertex or a triangle, 100 ns a segment.
// Memory while it runs: 2 bytes a vertex, 16 bytes for 64 triangles, 28 bytes a segment.
Task<void> add_isolines(Pace& pace, const Mesh& mesh, std::span<const float> values, std::span<const float> levels,
                        const RegionSet& regions, SurfaceCurves& out);

}  // namespace flg
