// SPDX-License-Identifier: MIT
// The borders that are seen, as curves on the surface: chains of edges between regions that look different.
//
// Invariants
// - Each such edge is in one curve. A curve begins and ends where three or more chains or a border of the surface meet;
//   those that meet none are closed.
// - Open curves first, by the edge they begin with, then closed ones.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/surface_curves.h"
#include "tangles/region_tree.h"

namespace flg {

// Labels of the mesh are the tree's leaves. The curves' values are lengths in metres. Cost: 50 ns a triangle. Memory:
// a byte a vertex, a bit an edge.
Task<SurfaceCurves> look_borders(Pace& pace, const Mesh& mesh, const RegionTree& tree);

}  // namespace flg
