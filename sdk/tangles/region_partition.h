// SPDX-License-Identifier: MIT
// What an operator made of the regions it was applied to: connected components of triangles, by flooding over all edges
// but those of the cut curves and those where labels differ; and the parts of the whole that the curves alone make.
// Appendix A of Nazzaro, Puppo, Pellacini: geoTangle (2021): the parts are the operator's partition of an inner node, the
// components its intersection with the leaves.
//
// Invariants
// - Each component is connected and lies in one leaf and one part; those of each leaf are a partition of it.
// - Components are in the order of their first triangles, parts in the order of their first components.
#pragma once

#include <deque>

#include "surfaces/mesh.h"
#include "surfaces/region_cursor.h"

namespace flg {

struct RegionComponent {
    uint32_t label;           // of its triangles
    uint32_t part;            // counted from 0
    uint32_t first_triangle;  // the lowest
};

class RegionPartitionKernel {
public:
    // `leaves`: the labels of what was divided. `edges`: of the curves, as one corner each or both. All outlive the kernel.
    // Memory: 8 bytes a triangle, not all of it touched.
    RegionPartitionKernel(const Mesh& mesh, const RegionSet& leaves, const std::pmr::deque<Corner>& edges,
                          Memory* memory);

    // Spends `count` units of about 0.1 us; true when done. 64 triangles outside of the leaves take two, a triangle
    // within them one, an edge one.
    bool run(uint32_t count);

    // After run() returned true.
    const std::pmr::deque<RegionComponent>& components() const { return components_; }
    uint32_t part_count() const { return part_count_; }
    RegionCursor triangles() const { return {mesh_, leaves_}; }
    bool is_within(uint32_t triangle) const { return leaves_.contains(mesh_.regions[triangle]); }
    // Of one within the leaves.
    uint32_t component_of(uint32_t triangle) const { return cells_[triangle] / 8 - 1; }

private:
    enum class Pass { clear, mark, flood, join, number, done };

    bool step();
    void visit(uint32_t triangle);
    void flood(uint32_t triangle);
    void mark(Corner edge);
    void join(Corner edge);
    uint32_t root_of(uint32_t component);
    void number(uint32_t component);

    const Mesh& mesh_;
    const RegionSet& leaves_;
    const std::pmr::deque<Corner>& edges_;
    // Of triangles within the leaves: bits 0 to 2: the edge is of a curve; above: 1 + component. Others are not kept.
    Buffer<uint32_t> cells_;
    Buffer<uint32_t> waiting_;  // triangles whose neighbours are to be looked at; the last one next
    uint32_t waiting_count_ = 0;
    std::pmr::deque<Corner> borders_;  // edges between leaves, but those of curves
    std::pmr::deque<RegionComponent> components_;
    std::pmr::deque<uint32_t> joined_;  // by component: one it is joined with, of a lower number, or itself
    uint32_t part_count_ = 0;
    RegionCursor cursor_;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
