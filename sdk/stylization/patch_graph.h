// SPDX-License-Identifier: MIT
// The patch graph (Minarcik, Fiser, Sykora, sec. 4.4): which point of the style may follow which, at what cost.
//
// Nodes are the points of the style curves. From i to j = c + 1 leads an edge of cost rho(i, c); consecutive edges (i,
// i + 1) cost the temperature instead, which is not part of the graph. With several patch sizes M takes rho's place.
// Departures from the paper, which keeps all edges:
// - From each node only the `successors_kept` cheapest jumps are kept, of those that are local minima of their row in
//   c. (The others are neighbours of a kept one, worse than it by their row; without this rule the points next to i
//   would take all places.) From the last patch of each style curve all jumps are kept: since consecutive edges lead to
//   it from everywhere before, every destination is reachable from every node that has a patch or comes before one.
// - Jumps behind the last patch of a curve (c = N-1-p) are left out: from there nothing leads on.
#pragma once

#include "stylization/patch_matrix.h"

namespace flg {

// The number of points of a style, and so of nodes, at most.
constexpr uint32_t style_points_max = 16384;

struct PatchGraph {
    uint32_t node_count = 0;
    uint32_t curve_count = 0;
    uint32_t patch = 0;                   // the largest, if there are several
    uint32_t start_cap = 0, end_cap = 0;  // the first and the last nodes, so many, are caps: no jump leads there
    // The jumps into node j, by rising source: in_source[k] and in_cost[k] (metres), in_begin[j] <= k < in_begin[j +
    // 1].
    Buffer<uint32_t> in_begin;
    Buffer<uint16_t> in_source;
    Buffer<float> in_cost;
    // Nodes that paths may be asked to: those with a patch that a jump can reach, p + 1 to N - 1 - p of each curve.
    Buffer<uint16_t> destinations;
    // Of node i's style curve: one behind its last node. A consecutive edge leads from i to i + 1 if that isn't the
    // end.
    Buffer<uint32_t> curve_end;
    // Metres. Weighted attributes can be of any size; paths of so many such jumps still have a finite length.
    static constexpr double cost_max = 1e33;
    // What temperature 1 means, metres: this share of the median, over the nodes, of their cheapest jump. At 1 runs are
    // about a dozen points long, at 0 hundreds, at 10 a jump nearly always beats copying.
    static constexpr float temperature_share = 0.1f;
    float temperature_unit = 0;

    uint32_t caps() const { return start_cap + end_cap; }
    // The first point of the first style curve that has destinations, but for its caps: from those of shorter curves
    // nothing leads on.
    uint32_t start() const { return destinations[0] - patch - 1; }
    // One behind that curve's last point that is not a cap's.
    uint32_t motif_end() const { return std::min(curve_end[start()], node_count - end_cap); }
    uint32_t jump_count() const { return static_cast<uint32_t>(in_source.size()); }
    // With the consecutive ones.
    uint32_t edge_count() const { return jump_count() + node_count - curve_count; }
};

constexpr uint32_t successors_kept = 16;

// At most style_points_max nodes. What the scene points to outlives the task.
Task<PatchGraph> patch_graph(Pace& pace, StyleScene scene);

// The lower one of the two in the middle, of values none of which may be negative.
Task<float> median(Pace& pace, std::span<const float> values);

}  // namespace flg
