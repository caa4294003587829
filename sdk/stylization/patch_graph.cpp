// SPDX-License-Identifier: MIT
#include "stylization/patch_graph.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "runtime/each.h"

namespace flg {

namespace {

float cost_of(double cost_sq) {
    return static_cast<float>(std::min(std::sqrt(std::max(cost_sq, 0.0)), PatchGraph::cost_max));
}

// Jumps in the order of their sources.
class Jumps {
public:
    Jumps(const StyleScene& scene, Memory* memory)
        : scene_(scene),
          begins_(size_t{scene.node_count()} + 1, memory),
          targets_(size_t{scene.node_count()} * (successors_kept + scene.curve_count()), memory),
          costs_(targets_.size(), memory),
          cheapest_(scene.node_count(), memory) {}

    void begin_row(uint32_t source, uint32_t curve) {
        end_sources(source + 1);
        keep_all_ = source + 1 == scene_.end_patch(curve);
        best_count_ = 0;
        min_sq_ = INFINITY;
    }
    // Looks at a part of the row; counts of jumps by target go into `in_count`.
    void select(const PatchMatrix& matrix, const PatchMatrix::Columns& columns, uint32_t* in_count) {
        const double* row = matrix.row();
        const uint32_t source = matrix.index();
        const uint32_t end = std::min(columns.end, scene_.end_patch(columns.curve) - 1);
        if (keep_all_) {
            for (uint32_t c = columns.begin; c < end; ++c) {
                if (c != source) add(c + 1, row[c], in_count);
            }
            return;
        }
        double worst = best_count_ == successors_kept ? best_[best_count_ - 1].cost_sq : INFINITY;
        for (uint32_t c = columns.begin; c < end; ++c) {
            const double v = row[c];
            if (v < worst && v < row[static_cast<ptrdiff_t>(c) - 1] && v <= row[c + 1] && c != source) {
                consider(c, v);
                if (best_count_ == successors_kept) worst = best_[best_count_ - 1].cost_sq;
            }
        }
    }
    void end_row(uint32_t* in_count) {
        for (uint32_t k = 0; k < best_count_; ++k) add(best_[k].target, best_[k].cost_sq, in_count);
        if (min_sq_ < INFINITY) cheapest_[cheapest_count_++] = cost_of(min_sq_);
    }
    // No jumps lead from nodes before `source` but those that there are.
    void end_sources(uint32_t source) {
        for (; sources_ < source; ++sources_) begins_[sources_] = count_;
    }

    uint32_t size() const { return count_; }
    uint32_t end_of(uint32_t source) const { return begins_[source + 1]; }
    uint32_t target(uint32_t jump) const { return targets_[jump]; }
    float cost(uint32_t jump) const { return costs_[jump]; }
    // Of each row the cheapest jump's cost.
    std::span<const float> cheapest() const { return {cheapest_.data(), cheapest_count_}; }

private:
    struct Jump {
        double cost_sq;
        uint32_t target;
    };

    // Puts a jump into its place among the best; of equal ones the first stays first.
    void consider(uint32_t c, double cost_sq) {
        uint32_t place = best_count_ < successors_kept ? best_count_++ : successors_kept - 1;
        for (; place > 0 && best_[place - 1].cost_sq > cost_sq; --place) best_[place] = best_[place - 1];
        best_[place] = {cost_sq, c + 1};
    }
    void add(uint32_t target, double cost_sq, uint32_t* in_count) {
        targets_[count_] = static_cast<uint16_t>(target);
        costs_[count_] = cost_of(cost_sq);
        ++count_;
        ++in_count[target];
        min_sq_ = std::min(min_sq_, cost_sq);
    }

    const StyleScene& scene_;
    Buffer<uint32_t> begins_;  // by source
    Buffer<uint16_t> targets_;
    Buffer<float> costs_;
    uint32_t count_ = 0, sources_ = 0;
    // The row's cheapest jumps, cheapest first; unused for rows that are kept whole.
    std::array<Jump, successors_kept> best_;
    uint32_t best_count_ = 0;
    bool keep_all_ = false;
    double min_sq_ = 0;
    Buffer<float> cheapest_;
    uint32_t cheapest_count_ = 0;
};

// Everything but the jumps; in_begin is zero.
Task<PatchGraph> without_jumps(Pace& pace, const StyleScene& scene) {
    PatchGraph graph;
    graph.node_count = scene.node_count();
    graph.curve_count = scene.curve_count();
    graph.patch = scene.patch;
    graph.start_cap = scene.start_cap;
    graph.end_cap = scene.end_cap;
    uint32_t destinations = 0;
    for (uint32_t curve = 0; curve < scene.curve_count(); ++curve) {
        const uint32_t patches = scene.end_patch(curve) - scene.first_patch(curve);
        if (patches > 0) destinations += patches - 1;
    }
    graph.in_begin = Buffer<uint32_t>(size_t{graph.node_count} + 1, pace.memory());
    graph.curve_end = Buffer<uint32_t>(graph.node_count, pace.memory());
    graph.destinations = Buffer<uint16_t>(destinations, pace.memory());
    uint32_t curve = 0, destination = 0;
    co_await each(pace, graph.node_count, Cost::some_ns, [&](uint32_t i) {
        while (i >= scene.boundaries[curve + 1]) ++curve;
        graph.in_begin[i] = 0;
        graph.curve_end[i] = scene.boundaries[curve + 1];
        if (i > scene.first_patch(curve) && i < scene.end_patch(curve))
            graph.destinations[destination++] = static_cast<uint16_t>(i);
    });
    co_return graph;
}

// Sorts the jumps by target. (Each is counted already: group_by would count them once more, and hold as many numbers.)
Task<void> turn_around(Pace& pace, const Jumps& jumps, PatchGraph& graph) {
    Buffer<uint32_t> next(graph.node_count, pace.memory());
    graph.in_source = Buffer<uint16_t>(jumps.size(), pace.memory());
    graph.in_cost = Buffer<float>(jumps.size(), pace.memory());
    uint32_t sum = 0;
    co_await each(pace, graph.node_count, Cost::some_ns, [&](uint32_t i) {
        next[i] = sum;
        sum += graph.in_begin[i];
        graph.in_begin[i] = next[i];
    });
    graph.in_begin[graph.node_count] = sum;
    uint32_t source = 0;
    co_await each(pace, jumps.size(), Cost::tens_of_ns, [&](uint32_t jump) {
        while (jump >= jumps.end_of(source)) ++source;
        const uint32_t place = next[jumps.target(jump)]++;
        graph.in_source[place] = static_cast<uint16_t>(source);
        graph.in_cost[place] = jumps.cost(jump);
    });
}

}  // namespace

Task<PatchGraph> patch_graph(Pace& pace, StyleScene scene) {
    PatchGraph graph = co_await without_jumps(pace, scene);
    Jumps jumps(scene, pace.memory());
    PatchMatrix matrix(scene, pace.memory());
    co_await begin_matrix(pace, matrix);
    Slice slice(Cost::hundreds_of_ns);
    while (matrix.next_row()) {
        while (!matrix.make_part())
            if (slice.is_over()) co_await pace;
        jumps.begin_row(matrix.index(), matrix.curve());
        for (const PatchMatrix::Columns& columns : matrix.columns()) {
            jumps.select(matrix, columns, graph.in_begin.data());
            if (slice.is_over()) co_await pace;
        }
        jumps.end_row(graph.in_begin.data());
    }
    jumps.end_sources(graph.node_count + 1);
    co_await turn_around(pace, jumps, graph);
    // Of a single destination no patch has another to jump to.
    if (!jumps.cheapest().empty()) {
        const float middle = co_await median(pace, jumps.cheapest());
        graph.temperature_unit = PatchGraph::temperature_share * middle;
    }
    co_return graph;
}

// Radix selection on the bits of floats, which are ordered as they are.
Task<float> median(Pace& pace, std::span<const float> values) {
    constexpr uint32_t digit_bits = 8, digits = 4;
    std::array<uint32_t, 1u << digit_bits> histogram;
    uint32_t rank = (static_cast<uint32_t>(values.size()) - 1) / 2;
    uint32_t prefix = 0;  // the digits found so far
    for (uint32_t digit = 0; digit < digits; ++digit) {
        const uint32_t shift = digit_bits * (digits - 1 - digit);
        histogram.fill(0);
        const auto count = [values, shift, prefix, counts = histogram.data()](uint32_t i) {
            // Adding zero makes -0 a 0.
            const uint64_t bits = std::bit_cast<uint32_t>(values[i] + 0.0f);
            if (bits >> (shift + digit_bits) == prefix) ++counts[(bits >> shift) & ((1u << digit_bits) - 1)];
        };
        co_await each(pace, values.size(), Cost::some_ns, count);
        uint32_t found = 0;
        while (rank >= histogram[found]) rank -= histogram[found++];
        prefix = prefix << digit_bits | found;
    }
    co_return std::bit_cast<float>(prefix);
}

}  // namespace flg
