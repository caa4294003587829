// SPDX-License-Identifier: MIT
// Steps that jobs share which solve distances on a surface.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/field.h"
#include "surfaces/geodesic_blocks_region.h"

namespace flg {

// What a surface's solvers work on. Fails with FLG_ERROR_OUT_OF_MEMORY if memory ran out when it was built, or
// followed a cut.
const GeodesicBlocks& blocks_of(const Surface& surface);
const GeodesicGraph& graph_of(const Surface& surface);

// Fills in `region` unless the regions are all; returns what solvers take: it, or null.
Task<const GeodesicRegion*> bound_region(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks,
                                         const RegionSet& regions, GeodesicRegion& region);

// Copies a solver's field out.
template <class Solver>
Task<void> take_field(Pace& pace, const Solver& solver, uint32_t vertex_count, bool labelled, DistanceField& field) {
    DistanceFieldKernel copy(solver, vertex_count, labelled, field, pace.memory());
    while (!copy.run(copy.chunk)) co_await pace;
}

Task<Buffer<uint32_t>> flatten(Pace& pace, const std::pmr::deque<uint32_t>& indices);

}  // namespace flg
