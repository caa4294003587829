// SPDX-License-Identifier: MIT
// The patch graph (Minarcik, Fiser, Sykora, sec. 4.4): which point of the style may follow which, at what cost.
//
// Nodes are the points of the style curves. From i to j = c + 1 leads an edge of cost rho(i, c); consecutive edges
// (i, i + 1) cost the temperature instead, which is not part of the graph. With several patch sizes M takes rho's place.
// Departures from the paper, which keeps all edges:
// - From each node only the `successors_kept` cheapest jumps are kept, of those that are local minima of their row in c.
//   (The others are neighbours of a kept one, worse than it by their row; without this rule the points next to i would
//   take all places.) From the last patch of each style curve all jumps are kept: since consecutive edges lead to it from
//   everywhere before, every destination is reachable from every node that has a patch or comes before one.
// - Jumps behind the last patch of a curve (c = N-1-p) are left out: from there nothing leads on.
#pragma once

#include <array>

#include "stylization/median.h"
#include "stylization/patch_costs.h"

namespace flg {

// The number of points of a style, and so of nodes, at most.
constexpr uint32_t style_points_max = 16384;

struct PatchGraph {
    uint32_t node_count = 0;
    uint32_t curve_count = 0;
    uint32_t patch = 0;  // the largest, if there are several
    // The jumps into node j, by rising source: in_source[k] and in_cost[k] (metres), in_begin[j] <= k < in_begin[j + 1].
    Buffer<uint32_t> in_begin;
    Buffer<uint16_t> in_source;
    Buffer<float> in_cost;
    // Nodes that paths may be asked to: those with a patch that a jump can reach, p + 1 to N - 1 - p of each curve.
    Buffer<uint16_t> destinations;
    // Of node i's style curve: one behind its last node. A consecutive edge leads from i to i + 1 if that isn't the end.
    Buffer<uint32_t> curve_end;
    // Metres. Weighted attributes can be of any size; paths of so many such jumps still have a finite length.
    static constexpr double cost_max = 1e33;
    // What temperature 1 means, metres: this share of the median, over the nodes, of their cheapest jump. At 1 runs are
    // about a dozen points long, at 0 hundreds, at 10 a jump nearly always beats copying.
    static constexpr float temperature_share = 0.1f;
    float temperature_unit = 0;

    // The first point of the first style curve that has destinations: from those of shorter curves nothing leads on.
    uint32_t start() const { return destinations[0] - patch - 1; }
    uint32_t jump_count() const { return static_cast<uint32_t>(in_source.size()); }
    // With the consecutive ones.
    uint32_t edge_count() const { return jump_count() + node_count - curve_count; }
};

// A unit is up to 256 entries of the patch matrix, edges or nodes: about 0.4 us. At most style_points_max nodes.
class PatchGraphKernel {
public:
    static constexpr uint32_t successors_kept = 16;

    // The displacement outlives the kernel.
    PatchGraphKernel(const StyleScene& scene, Memory* memory);
    bool run(uint32_t n);
    // 0 to 1.
    float progress() const;
    // After run() returned true.
    PatchGraph take() { return std::move(graph_); }

private:
    enum class Stage : uint8_t { nodes, rows, select, offsets, scatter, unit, done };
    struct Jump {
        double cost_sq;
        uint32_t target;
    };

    void nodes_block();
    void begin_select();
    void select_block();
    void consider(uint32_t c, double cost_sq);
    void add_jump(uint32_t target, double cost_sq);
    void end_row();
    void offsets_block();
    void scatter_block();
    // Moves on to the next style curve with targets, from `curve` on.
    void to_targets_of(uint32_t curve);

    StyleScene scene_;
    Memory* memory_;
    PatchCosts rows_;
    PatchGraph graph_;
    Stage stage_ = Stage::nodes;
    uint32_t at_ = 0;     // where the stage's next block begins
    uint32_t curve_ = 0;  // and in which style curve
    // The row's cheapest jumps, cheapest first; unused for rows that are kept whole.
    std::array<Jump, successors_kept> best_;
    uint32_t best_count_ = 0;
    bool keep_all_ = false;
    double least_sq_ = 0;
    // Jumps in the order of their sources: those of node i begin at out_begin_[i].
    Buffer<uint32_t> out_begin_;
    Buffer<uint16_t> out_target_;
    Buffer<float> out_cost_;
    uint32_t jump_count_ = 0;
    uint32_t sources_done_ = 0;
    uint32_t destination_count_ = 0;
    Buffer<uint32_t> next_place_;  // scatter: where the next jump into a node goes
    Buffer<float> cheapest_;       // cost of each row's cheapest jump
    uint32_t cheapest_count_ = 0;
    Median median_;
};

}  // namespace flg
