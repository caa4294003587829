// SPDX-License-Identifier: MIT
// Scenes with attributes and several patch sizes, in the words of the kernels and of the literal version.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "stylization/style_inputs.h"

namespace flg::test {

struct Scene {
    std::vector<uint32_t> boundaries;
    std::vector<FlgPatchSize> sizes;
    std::vector<Vec3> vectors = wiggles(static_cast<int>(boundaries.back()));
    std::vector<literal::Channel> channels = {};

    // Values anywhere on the line, and around the circle more than once.
    Scene& with_channel(double weight, double period) {
        literal::Channel channel{{}, weight, period};
        for (size_t i = 0; i < vectors.size(); ++i) {
            const double u = static_cast<double>(i);
            channel.values.push_back(0.08 * u + std::sin(0.21 * u + static_cast<double>(channels.size())) +
                                     0.01 * random_unit(7, i, channels.size()));
        }
        channels.push_back(channel);
        return *this;
    }
    std::vector<int> as_int() const { return {boundaries.begin(), boundaries.end()}; }
    uint32_t largest_patch() const {
        uint32_t largest = 0;
        for (const FlgPatchSize& size : sizes) largest = std::max(largest, size.patch);
        return largest;
    }
    std::vector<double> literal_costs_sq() const {
        std::vector<literal::PatchSize> literal_sizes;
        for (const FlgPatchSize& size : sizes) {
            literal_sizes.push_back({static_cast<int>(size.patch), static_cast<double>(size.weight)});
        }
        return literal::patch_costs_sq(vectors, as_int(), literal_sizes, channels);
    }
};

inline std::vector<PatchChannel> channels_of(const Scene& scene) {
    std::vector<PatchChannel> channels;
    for (const literal::Channel& channel : scene.channels) {
        const double period = channel.weight * channel.period;
        PatchChannel& out =
            channels.emplace_back(PatchChannel{Buffer<double>(channel.values.size(), memory()), period});
        for (size_t i = 0; i < channel.values.size(); ++i) {
            const double value = channel.weight * channel.values[i];
            out.values[i] = period > 0 ? value - period * std::floor(value / period) : value;
        }
    }
    return channels;
}

inline PatchGraph graph_of(const Scene& scene, bool haltingly = false) {
    const Displacement displacement = displacement_of(scene.vectors);
    const std::vector<PatchChannel> channels = channels_of(scene);
    const StyleScene all{&displacement, scene.boundaries, scene.largest_patch(), scene.sizes, channels};
    return run_now(
        memory(), [&](Pace& pace) { return patch_graph(pace, all); }, haltingly);
}

inline bool same_bits(const PatchGraph& a, const PatchGraph& b) {
    return std::equal(a.in_begin.begin(), a.in_begin.end(), b.in_begin.begin(), b.in_begin.end()) &&
           std::equal(a.in_source.begin(), a.in_source.end(), b.in_source.begin(), b.in_source.end()) &&
           std::equal(a.in_cost.begin(), a.in_cost.end(), b.in_cost.begin(), b.in_cost.end()) &&
           a.temperature_unit == b.temperature_unit;
}

// Every row of the matrix against the literal version's, and the jumps.
inline void expect_literal(const Scene& scene) {
    const std::vector<double> expected = scene.literal_costs_sq();
    double largest = 0;
    for (double v : expected) {
        if (v < INFINITY) largest = std::max(largest, v);
    }
    const Displacement displacement = displacement_of(scene.vectors);
    const std::vector<PatchChannel> channels = channels_of(scene);
    PatchMatrix costs({&displacement, scene.boundaries, scene.largest_patch(), scene.sizes, channels}, memory());
    run_haltingly(memory(), [&](Pace& pace) { return begin_matrix(pace, costs); });
    const size_t n = scene.vectors.size();
    size_t rows = 0;
    while (costs.next_row()) {
        while (!costs.make_part()) {}
        ++rows;
        for (size_t c = 0; c < n; ++c) {
            const double v = expected[costs.index() * n + c];
            if (v < INFINITY) {
                // Roots of what rounding leaves of zero.
                ASSERT_NEAR(std::sqrt(std::max(costs.row()[c], 0.0)), std::sqrt(v), 1e-6 * std::sqrt(largest))
                    << costs.index() << " " << c;
            } else {
                ASSERT_EQ(costs.row()[c], v) << costs.index() << " " << c;
            }
        }
    }
    size_t expected_rows = 0;
    for (size_t i = 0; i < n; ++i) expected_rows += expected[i * n + i] < INFINITY ? 1 : 0;
    EXPECT_EQ(rows, expected_rows);

    literal::Graph expected_jumps = literal::sparse_jumps(
        expected, scene.as_int(), static_cast<int>(scene.largest_patch()), static_cast<int>(successors_kept));
    literal::Graph jumps = jumps_of(graph_of(scene));
    for (size_t i = 0; i < n; ++i) {
        auto& row = expected_jumps[i];
        std::sort(row.begin(), row.end(), [](auto& a, auto& b) { return a.target < b.target; });
        ASSERT_EQ(jumps[i].size(), row.size()) << "node " << i;
        for (size_t k = 0; k < row.size(); ++k) {
            EXPECT_EQ(jumps[i][k].target, row[k].target) << "node " << i;
            EXPECT_NEAR(jumps[i][k].cost, row[k].cost, 1e-5) << "node " << i;
        }
    }
}

}  // namespace flg::test
