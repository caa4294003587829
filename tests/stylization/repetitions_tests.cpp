// SPDX-License-Identifier: MIT
// Joints of styles that repeat, that repeat unevenly, that do not; caps beside repetitions.
#include "stylization/repetitions.h"

#include <gtest/gtest.h>

#include "stylization/style_inputs.h"

namespace flg::test {
namespace {

std::vector<uint32_t> joints_of(const std::vector<Vec3>& vectors) {
    const Displacement d = displacement_of(vectors);
    const PatchGraph graph = graph_of(d, 5);
    const Buffer<uint32_t> joints = run_now(
        memory(), [&](Pace& pace) { return find_joints(pace, graph, d); }, true);
    return {joints.begin(), joints.end()};
}

// Loops by phase: the phase of each node is in turns.
std::vector<Vec3> loops(const std::vector<double>& phases) {
    std::vector<Vec3> out;
    for (size_t i = 0; i < phases.size(); ++i) {
        const double a = 2 * M_PI * phases[i];
        out.emplace_back(std::sin(a) + 0.3 * std::sin(3 * a), std::cos(a), 0.02 * random_unit(3, i, 0));
    }
    return out;
}

void expect_whole_turns(const std::vector<uint32_t>& joints, const std::vector<double>& phases, size_t turns) {
    ASSERT_EQ(joints.size(), turns + 1);
    for (size_t k = 1; k < joints.size(); ++k) {
        EXPECT_NEAR(phases[joints[k]] - phases[joints[k - 1]], 1, 0.08) << k;
    }
}

TEST(Repetitions, JointsAreAPeriodApart) {
    std::vector<double> phases;
    for (int i = 0; i <= 320; ++i) phases.push_back(i / 40.0);
    const std::vector<uint32_t> joints = joints_of(loops(phases));
    EXPECT_EQ(joints.front(), 0u);
    EXPECT_GE(joints.back(), 318u);
    expect_whole_turns(joints, phases, 8);
}

// As a hand draws them: some loops take a third longer than others.
TEST(Repetitions, PeriodsMayDiffer) {
    std::vector<double> phases = {0};
    while (phases.back() < 10) {
        const double slower = 1 + 0.15 * std::sin(2.1 * std::floor(phases.back()));
        phases.push_back(phases.back() + 1 / (50 * slower));
    }
    expect_whole_turns(joints_of(loops(phases)), phases, 10);
}

TEST(Repetitions, WhatRepeatsNothingIsOne) {
    // From one random place to the next.
    std::vector<Vec3> vectors;
    for (uint32_t i = 0; i < 300; ++i) {
        const double t = i % 10 / 10.0;
        Vec3 at;
        for (int k = 0; k < 3; ++k) {
            at[k] = (1 - t) * random_unit(7, i / 10, k) + t * random_unit(7, i / 10 + 1, k);
        }
        vectors.push_back(at);
    }
    EXPECT_EQ(joints_of(vectors), (std::vector<uint32_t>{0, 299}));
}

TEST(Repetitions, CapsAreWhatIsOfAnotherKind) {
    std::vector<double> phases;
    for (int i = 0; i <= 400; ++i) phases.push_back(i / 40.0);
    const auto caps_of = [](const std::vector<Vec3>& vectors) {
        const Displacement d = displacement_of(vectors);
        return run_now(
            memory(), [&](Pace& pace) { return caps_beside_repetitions(pace, d); }, true);
    };
    std::vector<Vec3> vectors = loops(phases);
    EXPECT_EQ(caps_of(vectors).start + caps_of(vectors).end, 0u);
    // A head as long as a loop, and a longer tail.
    for (uint32_t i = 0; i < 40; ++i) vectors[i] = Vec3(0.05 * i - 2, -2 + 0.1 * i, 1);
    for (uint32_t i = 330; i <= 400; ++i) vectors[i] = Vec3(2 - 0.05 * (i - 330), 0.03 * (i - 330), -1);
    const StyleCaps caps = caps_of(vectors);
    EXPECT_NEAR(caps.start, 40, 11);
    EXPECT_NEAR(caps.end, 71, 11);
}

}  // namespace
}  // namespace flg::test
