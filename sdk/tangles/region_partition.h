// SPDX-License-Identifier: MIT
// What an operator made of the regions it was applied to: connected components of triangles, by flooding over all edges
// but those of the cut curves and those where labels differ; and the parts of the whole that the curves alone make.
// Appendix A of Nazzaro, Puppo, Pellacini: geoTangle (2021): the parts are the operator's partition of an inner node,
// the components its intersection with the leaves.
//
// Invariants
// - Each component is connected and lies in one leaf and one part; those of each leaf are a partition of it.
// - Components are in the order of their first triangles, parts in the order of their first components.
#pragma once

#include <deque>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

struct RegionComponent {
    uint32_t label;           // of its triangles
    uint32_t part;            // counted from 0
    uint32_t first_triangle;  // the lowest
};

struct RegionPartition {
    RegionPartition(const Mesh& of_mesh, const RegionSet& of_leaves, Memory* memory)
        : mesh(of_mesh), leaves(of_leaves), cells(of_mesh.triangle_count(), memory), components(memory) {}

    bool is_within(uint32_t triangle) const { return leaves.contains(mesh.regions[triangle]); }
    // Of one within the leaves.
    uint32_t component_of(uint32_t triangle) const { return cells[triangle] / 8 - 1; }

    const Mesh& mesh;
    const RegionSet& leaves;
    // Of triangles within the leaves: bits 0 to 2: the edge is of a curve; above: 1 + component. Others are not
    // written.
    Buffer<uint32_t> cells;
    std::pmr::deque<RegionComponent> components;
    uint32_t part_count = 0;
};

// `leaves`: the labels of what was divided; they and the mesh outlive the partition. `edges`: of the curves, as one
// corner each or both. `parts`: whether a part goes on from leaf to leaf where no curve is. Cost: about 0.1 us a
// triangle within the leaves, 1 ns a triangle outside. Memory: 8 bytes a triangle, not all of it touched; half of that
// is given back.
enum class Parts { across_leaves, within_leaves };
Task<RegionPartition> partition_regions(Pace& pace, const Mesh& mesh, const RegionSet& leaves,
                                        const std::pmr::deque<Corner>& edges, Parts parts = Parts::across_leaves);

}  // namespace flg
