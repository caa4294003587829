// SPDX-License-Identifier: MIT
#include "inflation/part_borders.h"

#include <gtest/gtest.h>

#include <map>

#include "inflation/closed_mesh.h"
#include "inflation/models.h"

namespace flg::test {
namespace {

ClosedMesh checked(const MergedMesh& mesh) {
    return check_closed(mesh.positions, {mesh.triangles.data(), mesh.triangles.size()});
}

// Edges between triangles of different parts, with these parts.
using Borders = std::map<std::pair<uint32_t, uint32_t>, std::pair<uint32_t, uint32_t>>;

Borders borders_of(const MergedMesh& mesh) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> part_of_side;
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (uint32_t k = 0; k < 3; ++k)
            part_of_side[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] = mesh.triangle_parts[t];
    Borders borders;
    for (const auto& [side, part] : part_of_side)
        if (const uint32_t other = part_of_side[{side.second, side.first}]; part < other) borders[side] = {part, other};
    return borders;
}

std::vector<uint32_t> ends_at(const Borders& borders, size_t vertices) {
    std::vector<uint32_t> ends(vertices);
    for (const auto& [side, parts] : borders) {
        ++ends[side.first];
        ++ends[side.second];
    }
    return ends;
}

TEST(PartBorders, FollowWhereBothPartsAreAlike) {
    const Model model = animal();
    const PartUnion parts = run_now(test_memory(), [&](Pace& pace) { return PartUnion::make(pace, model.parts, -1); });
    for (const uint32_t vertices : {2000u, 10000u}) {
        const MergedMesh mesh = merged(model, {.vertices = vertices});
        const ClosedMesh closed = checked(mesh);
        EXPECT_EQ(closed.fault, "");
        EXPECT_EQ(closed.euler, 2);
        EXPECT_GT(closed.min_angle, 1);
        const Borders borders = borders_of(mesh);
        EXPECT_GT(borders.size(), 100u);
        const std::vector<uint32_t> ends = ends_at(borders, mesh.positions.size());
        uint32_t open = 0;
        for (const uint32_t count : ends) open += count == 1;
        EXPECT_EQ(open, 0u) << "a border ends";
        uint32_t far = 0;
        for (const auto& [side, pair] : borders) {
            for (const uint32_t v : {side.first, side.second}) {
                if (ends[v] != 2) continue;  // where three parts meet
                const Vec3& p = mesh.positions[v];
                far +=
                    std::fabs(parts.difference(p, pair.first, pair.second).value) > border_tolerance * mesh.spacing ||
                    std::fabs(parts.sample(p).value) > border_tolerance * mesh.spacing;
            }
        }
        EXPECT_LE(far, borders.size() / 5) << "of " << 2 * borders.size();
    }
}

// New vertices have the weights of their place between others; those that were there keep theirs.
TEST(PartBorders, CarryWeights) {
    const Model model = animal();
    EvenMesh even = made([&](Pace& pace) { return merge_evenly(pace, model.parts, {.vertices = 3000}); }, false);
    const BoneWeights before = weights_of(even.mesh, model);
    BoneWeights weights = weights_of(even.mesh, model);
    const MergedMesh mesh = made([&](Pace& pace) { return cut_merged(pace, even, &weights); }, false);
    ASSERT_GT(mesh.positions.size(), before.weights.size() + 50);
    ASSERT_EQ(weights.weights.size(), mesh.positions.size());
    for (size_t v = 0; v < mesh.positions.size(); ++v) {
        double sum = 0;
        for (const float weight : weights.weights[v]) sum += static_cast<double>(weight);
        EXPECT_NEAR(sum, 1, 1e-6);
        EXPECT_GE(weights.weights[v][0], weights.weights[v][1]);
    }
    EXPECT_TRUE(std::equal(before.weights.begin(), before.weights.end(), weights.weights.begin()));
    EXPECT_TRUE(std::equal(before.joints.begin(), before.joints.end(), weights.joints.begin()));
}

// In the plane between two balls: so the border is a circle, and its length that of one.
TEST(PartBorders, OfTwoBallsIsACircle) {
    Model model;
    model.add({ellipse(0, 0, 1, 1, 400)}, placement({-0.6, 0, 0}));
    model.repeat(0, placement({0.6, 0, 0}));
    const MergedMesh mesh = merged(model, {.vertices = 5000, .blend = 0});
    const Borders borders = borders_of(mesh);
    double length = 0;
    for (const auto& [side, pair] : borders) {
        const Vec3 &a = mesh.positions[side.first], &b = mesh.positions[side.second];
        EXPECT_NEAR(a.x(), 0, border_tolerance * mesh.spacing);
        EXPECT_NEAR(std::hypot(a.y(), a.z()), 0.8, 0.002);
        length += (b - a).norm();
    }
    EXPECT_NEAR(length, 2 * std::numbers::pi * 0.8, 0.01);
}

}  // namespace
}  // namespace flg::test
