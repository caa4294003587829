// SPDX-License-Identifier: MIT
// Shortest paths in the patch graph to one destination from all nodes (Minarcik, Fiser, Sykora, sec. 4.5): Dijkstra's
// algorithm from the destination backwards. The paper looks for one path at a time; the tree serves every later one.
//
// Costs are floats. The cost of a path is added up from its end: cost(i, j) + distance(j). Rounding keeps that order
// monotonous, so the distances are the same whatever way they are found. Nodes are settled by rising (distance, index);
// a node's hop is the first settled one that gives its distance, but the consecutive one if that gives it as well.
// Departure: distances are floats, kept only while the tree is made.
#pragma once

#include "stylization/patch_graph.h"

namespace flg {

// Of path trees: nodes that no path to the destination begins at.
constexpr uint16_t no_hop = 0xffff;

// Makes one tree after the other. Stays a kernel: synthesis resumes it between samples, and once its scratch is there
// it allocates nothing. A unit is a settled node with the edges into it, about 40 ns.
//
// The nodes that wait are no heap: a node's distance falls several times before it is settled, and has to cost little
// then. They are groups with their least distances, and the next node is found by looking through the groups, then
// through one. That is as many steps for any graph of the size, and none of them is a branch to be guessed.
class PathTreeKernel {
public:
    // Scratch memory for graphs of this size is taken by begin().
    explicit PathTreeKernel(Memory* memory) : memory_(memory) {}

    // Costs one pass over the nodes' distances. `next_hop` has graph.node_count entries; what it points to, and the
    // graph, must outlive the run. `temperature` in metres, >= 0.
    void begin(const PatchGraph& graph, float temperature, uint32_t destination, uint16_t* next_hop);
    // Spends units; true when next_hop is complete: the node after i on the shortest path, the destination's its own.
    bool run(uint32_t& units);
    // After that, until the next begin(): infinite where there is no path.
    const float* distances() const { return distance_.data(); }

private:
    Memory* memory_;
    const PatchGraph* graph_ = nullptr;
    uint16_t* next_hop_ = nullptr;
    float temperature_ = 0;
    Buffer<float> distance_;
    // The bits of floats that aren't negative, which are ordered as they are; infinite where nobody waits.
    Buffer<int32_t> waiting_;  // by node
    Buffer<int32_t> least_;    // by group
    uint32_t group_count_ = 0;
};

}  // namespace flg
