// SPDX-License-Identifier: MIT
// A style, and one call that applies it to a curve.
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "curves/curve_inputs.h"
#include "stylization/style_inputs.h"
#include "stylization/synthesis.h"

namespace flg::test {

struct TestStyle {
    std::vector<Vec3> vectors;
    PreparedStyle prepared{memory()};

    explicit TestStyle(std::vector<Vec3> v, uint32_t patch = 10) : vectors(std::move(v)) {
        prepared.displacement = displacement_of(vectors);
        prepared.graph = graph_of(prepared.displacement, patch);
    }
    void add(FlgAttribute attribute, uint32_t components, const std::vector<float>& values,
             FlgMetric metric = FLG_METRIC_EUCLIDEAN) {
        Buffer<float> copy(values.size(), memory());
        std::copy(values.begin(), values.end(), copy.begin());
        prepared.attributes.push_back({attribute, components, metric, 0, std::move(copy), {}});
        for (uint32_t i = 0; i < vectors.size(); ++i) prepared.attributes.back().extend_ranges(i);
    }
    PathTrees trees(double tau) const {
        return PathTrees(prepared.graph, static_cast<float>(tau * prepared.graph.temperature_unit), memory());
    }
};

struct StylizeOptions {
    double magnitude = 1;
    double scale = 1;
    bool from_start = true;
    uint64_t seed = 1;
    uint64_t key = 0;
    bool pin_ends = false;
    std::array<double, 9> basis{1, 0, 0, 0, 1, 0, 0, 0, 1};
    double start_time = 0;
    uint32_t slice = 1u << 30;
};

struct StylizedCurve {
    Resampled curve;
    std::vector<float> indices, displacements, times;
    std::vector<std::vector<float>> attributes;

    size_t size() const { return indices.size(); }
    Vec3 displacement(size_t i) const { return load_vec3(&displacements[3 * i]); }
    double mean_run() const {
        double runs = 1;
        for (size_t i = 1; i < indices.size(); ++i) runs += indices[i] != indices[i - 1] + 1;
        return static_cast<double>(indices.size()) / runs;
    }
};

inline AppliedStyle applied(const PreparedStyle& style, double scale, const std::array<double, 9>& basis,
                            bool haltingly = false) {
    return run_now(
        memory(), [&](Pace& pace) { return fit_style(pace, style, scale, basis, scale); }, haltingly);
}

inline StylizedCurve stylize(const TestStyle& style, PathTrees& trees, const SamplingPlan& plan,
                             const StylizeOptions& options = {}, std::span<const ColumnPair> carried = {}) {
    StylizedCurve result;
    const size_t count = plan.sample_count();
    for (auto* column :
         {&result.curve.positions, &result.curve.tangents, &result.curve.normals, &result.displacements}) {
        column->resize(3 * count);
    }
    result.indices.resize(count);
    std::vector<float*> attributes;
    bool timed = false;
    for (const StyleAttribute& attribute : style.prepared.attributes) {
        result.attributes.emplace_back(count * attribute.components);
        timed = timed || attribute.attribute == FLG_ATTRIBUTE_SPEED;
    }
    for (auto& values : result.attributes) attributes.push_back(values.data());
    if (timed) result.times.resize(count);
    const AppliedStyle fitted = applied(style.prepared, options.scale, options.basis, options.slice);
    SynthesisKernel kernel({&fitted, &trees, options.magnitude, options.pin_ends, options.seed}, memory());
    kernel.begin(
        {.plan = plan,
         .key = options.key,
         .from_start = options.from_start,
         .start_time = options.start_time,
         .out = {.frames = {result.curve.positions.data(), result.curve.tangents.data(), result.curve.normals.data()},
                 .style_index = result.indices.data(),
                 .displacement = result.displacements.data(),
                 .time = timed ? result.times.data() : nullptr,
                 .attributes = attributes},
         .carried = carried});
    while (!kernel.run(options.slice)) {}
    EXPECT_EQ(kernel.written(), count);
    return result;
}

inline StylizedCurve stylize(const TestStyle& style, double tau, const SamplingPlan& plan,
                             const StylizeOptions& options = {}) {
    PathTrees trees = style.trees(tau);
    return stylize(style, trees, plan, options);
}

}  // namespace flg::test
