// SPDX-License-Identifier: MIT
// New labels for the parts into which chains of edges divide regions: flooding over triangles, across all edges but
// those.
//
// Invariants
// - What the chains do not separate keeps its label: the part of a region is looked at by itself if it was apart
//   before.
// - Each part of what falls apart gets a label of its own, counted up from first_label in the order in which the
//   chains' edges meet the parts. Fails with FLG_ERROR_LIMIT above FLG_REGION_MAX, before any label is changed.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh_edit.h"

namespace flg {

// A part with a new label, and the label it had.
struct RegionPart {
    uint32_t label;
    uint32_t old_label;
};

// `edges`: the chains' edges, as one corner each or both. The edit is the one of the cut that made them. Appends to
// `parts`, by rising label. 0.1 us a triangle or an edge, two or three times. Memory while it runs: 8 bytes a triangle.
Task<void> divide_regions(Pace& pace, Mesh& mesh, const std::pmr::deque<Corner>& edges, uint32_t first_label,
                          MeshEdit& edit, std::pmr::deque<RegionPart>& parts);

}  // namespace flg
