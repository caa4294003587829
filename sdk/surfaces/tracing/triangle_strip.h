// SPDX-License-Identifier: MIT
// A strip of triangles from one point of a mesh to another, each across an edge from the one before: the shortest way
// over the triangles' centroids, by A* (Hart, Nilsson, Raphael: A Formal Basis for the Heuristic Determination of
// Minimum Cost Paths, 1968). The straight line to the end is never longer than a way that is left.
//
// Invariants
// - Complete: there is a strip wherever triangles of the regions join both points across edges.
// - The same strip in whatever memory: ties go to the triangle with the lower index.
#pragma once

#include <vector>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/mesh/surface_place.h"

namespace flg {

// Ends with a triangle that holds `to` and begins with one that holds `from`; empty if no way leads there. About 150 ns
// a triangle looked at: those for which the way over them is not much longer than the shortest.
Task<std::pmr::vector<uint32_t>> find_strip(Pace& pace, const Mesh& mesh, const RegionSet& regions, SurfacePlace from,
                                            SurfacePlace to);

}  // namespace flg
