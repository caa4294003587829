// SPDX-License-Identifier: MIT
// New labels for the parts into which chains of edges divide regions: flooding over triangles, across all edges but those.
//
// Invariants
// - What the chains do not separate keeps its label: the part of a region is looked at by itself if it was apart before.
// - Each part of what falls apart gets a label of its own, counted up from first_label in the order in which the chains'
//   edges meet the parts. Fails with FLG_ERROR_LIMIT above FLG_REGION_MAX, before any label is changed.
#pragma once

#include <deque>

#include "surfaces/mesh_edit.h"

namespace flg {

// A part with a new label, and the label it had.
struct RegionPart {
    uint32_t label;
    uint32_t old_label;
};

class RegionDivider {
public:
    // `edges`: the chains' edges, as one corner each or both. The edit is the one of the cut that made them. Appends to
    // `parts`, by rising label. All must outlive the run. Memory while it runs: 8 bytes a triangle.
    RegionDivider(Mesh& mesh, const std::pmr::deque<Corner>& edges, uint32_t first_label, MeshEdit& edit,
                  std::pmr::deque<RegionPart>& parts, Memory* memory);

    // Spends `count` units of about 0.1 us; true when done. A triangle takes up to three, an edge up to two.
    bool run(uint32_t count);

private:
    enum class Pass { clear, mark, flood, join, number, relabel, done };
    struct Component {
        uint32_t joined;  // one it was joined with before, the one of the lowest number in the end
        uint32_t size;    // once joined: of how many components
        uint32_t label, old_label;
    };

    uint32_t size_of(Pass pass) const;
    bool flood(uint32_t& count);
    void visit(uint32_t triangle);
    void mark(Corner edge);
    void join(Corner edge);
    uint32_t root_of(uint32_t component);
    void number(uint32_t component);
    void relabel(uint32_t triangle);
    uint32_t component_of(uint32_t triangle) const { return cells_[triangle] / 8 - 1; }

    Mesh& mesh_;
    const std::pmr::deque<Corner>& edges_;
    uint32_t next_label_;
    MeshEdit& edit_;
    std::pmr::deque<RegionPart>& parts_;
    Buffer<uint32_t> cells_;    // bits 0 to 2: the edge is of a chain; above: 1 + component, 0 before it is flooded
    Buffer<uint32_t> waiting_;  // triangles whose neighbours are to be looked at; the last one next
    uint32_t waiting_count_ = 0;
    std::pmr::deque<Component> components_;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
