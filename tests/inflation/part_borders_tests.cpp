// SPDX-License-Identifier: MIT
#include "inflation/part_borders.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

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

// Steepest weight along an edge.
double slope_of(const MergedMesh& mesh, const BoneWeights& weights) {
    const auto weight = [&](uint32_t v, uint32_t joint) {
        double sum = 0;
        for (uint32_t k = 0; k < 4; ++k)
            if (weights.joints[v][k] == joint) sum += static_cast<double>(weights.weights[v][k]);
        return sum;
    };
    double steepest = 0;
    for (const TriangleVertices& t : mesh.triangles)
        for (uint32_t side = 0; side < 3; ++side) {
            const uint32_t a = t[side], b = t[(side + 1) % 3];
            const double length = (mesh.positions[a] - mesh.positions[b]).norm();
            for (const uint32_t joint : weights.joints[a])
                steepest = std::max(steepest, std::fabs(weight(a, joint) - weight(b, joint)) / length);
        }
    return steepest;
}

// The point of a surface that is nearest to one, among eleven by eleven of each triangle that is near.
Vec3 nearest_on(const std::vector<Vec3>& positions, const std::vector<TriangleVertices>& triangles, const Vec3& to,
                double near) {
    Vec3 best = positions[0];
    for (const TriangleVertices& t : triangles) {
        const Vec3 &a = positions[t[0]], &b = positions[t[1]], &c = positions[t[2]];
        if ((a - to).norm() > near) continue;
        for (int i = 0; i <= 10; ++i)
            for (int k = 0; i + k <= 10; ++k) {
                const Vec3 at = a + 0.1 * i * (b - a) + 0.1 * k * (c - a);
                if ((at - to).squaredNorm() < (best - to).squaredNorm()) best = at;
            }
    }
    return best;
}

// Vertices have the weights of the surface where they are, those too that were moved onto a border.
TEST(PartBorders, WeightsStayWhereTheyAre) {
    const Model model = animal();
    EvenMesh even = made([&](Pace& pace) { return merge_evenly(pace, model.parts, {.vertices = 3000}); }, false);
    const std::vector<Vec3> positions(even.mesh.positions.begin(), even.mesh.positions.end());
    const std::vector<TriangleVertices> triangles(even.mesh.triangles.begin(), even.mesh.triangles.end());
    for (uint32_t axis = 0; axis < 3; ++axis) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (const Vec3& p : positions) {
            low = std::min(low, p[axis]);
            high = std::max(high, p[axis]);
        }
        // Two joints, by one coordinate.
        ManyWeights weights{Buffer<ManyJoints>(positions.size(), test_memory()),
                            Buffer<double>(positions.size(), test_memory())};
        for (size_t v = 0; v < positions.size(); ++v) {
            const double share = (positions[v][axis] - low) / (high - low);
            const bool is_most = share >= 0.5;
            weights.of_vertex[v] = {
                {static_cast<float>(is_most ? share : 1 - share), static_cast<float>(is_most ? 1 - share : share)},
                {uint16_t{is_most}, uint16_t{!is_most}}};
            weights.spread[v] = share;
        }
        EvenMesh again = made([&](Pace& pace) { return merge_evenly(pace, model.parts, {.vertices = 3000}); }, false);
        const MergedMesh mesh = made([&](Pace& pace) { return cut_merged(pace, again, &weights); }, false);
        size_t changed = 0, far = 0;
        for (size_t v = 0; v < mesh.positions.size(); ++v) {
            if (v < positions.size() && mesh.positions[v] == positions[v]) continue;
            ++changed;
            double at = low;
            for (uint32_t k = 0; k < 2; ++k)
                if (weights.of_vertex[v].joints[k] == 1)
                    at += static_cast<double>(weights.of_vertex[v].weights[k]) * (high - low);
            EXPECT_NEAR(low + weights.spread[v] * (high - low), at, 1e-5 * (high - low));
            const Vec3 nearest = nearest_on(positions, triangles, mesh.positions[v], 3 * mesh.spacing);
            far += std::fabs(at - nearest[axis]) > 0.15 * mesh.spacing;
        }
        EXPECT_GT(changed, 200u);
        EXPECT_LE(far, changed / 50) << axis;
    }
}

// So short edges beside a border have no steeper weights than others.
TEST(PartBorders, WeightsAreNoSteeperBesideThem) {
    const Model model = animal();
    for (const uint32_t count : {3000u, 10000u}) {
        EvenMesh even = made([&](Pace& pace) { return merge_evenly(pace, model.parts, {.vertices = count}); }, false);
        const double before = slope_of(even.mesh, weights_of(even.mesh, model));
        ManyWeights weights = many_weights_of(even.mesh, model);
        const MergedMesh mesh = made([&](Pace& pace) { return cut_merged(pace, even, &weights); }, false);
        EXPECT_LT(slope_of(mesh, four_of(mesh, weights, model)), 1.5 * before) << count;
    }
}

// Weights are sorted and sum to 1, but for those of a thirteenth joint; where nothing moved they are as they were.
TEST(PartBorders, CarryWeights) {
    const Model model = animal();
    EvenMesh even = made([&](Pace& pace) { return merge_evenly(pace, model.parts, {.vertices = 3000}); }, false);
    const ManyWeights before = many_weights_of(even.mesh, model);
    ManyWeights weights = many_weights_of(even.mesh, model);
    const std::vector<Vec3> positions(even.mesh.positions.begin(), even.mesh.positions.end());
    const MergedMesh mesh = made([&](Pace& pace) { return cut_merged(pace, even, &weights); }, false);
    size_t moved = 0;
    ASSERT_GT(mesh.positions.size(), before.of_vertex.size() + 50);
    ASSERT_EQ(weights.of_vertex.size(), mesh.positions.size());
    ASSERT_EQ(weights.spread.size(), mesh.positions.size());
    for (const VertexWeights& four : four_of(mesh, weights, model).weights) {
        EXPECT_NEAR(std::accumulate(four.begin(), four.end(), 0.0), 1, 1e-6);
        EXPECT_TRUE(std::is_sorted(four.rbegin(), four.rend()));
    }
    for (const ManyJoints& many : weights.of_vertex) {
        EXPECT_NEAR(std::accumulate(many.weights.begin(), many.weights.end(), 0.0), 1, 1e-3);
        EXPECT_TRUE(std::is_sorted(many.weights.rbegin(), many.weights.rend()));
        for (uint32_t k = 1; k < ManyJoints::limit; ++k)
            for (uint32_t other = 0; other < k; ++other)
                EXPECT_TRUE(many.weights[k] == 0 || many.joints[k] != many.joints[other]);
    }
    for (size_t v = 0; v < before.of_vertex.size(); ++v) {
        if (mesh.positions[v] != positions[v]) {
            ++moved;
            continue;
        }
        EXPECT_EQ(before.of_vertex[v].weights, weights.of_vertex[v].weights) << v;
        EXPECT_EQ(before.of_vertex[v].joints, weights.of_vertex[v].joints) << v;
        EXPECT_EQ(before.spread[v], weights.spread[v]) << v;
    }
    EXPECT_GT(moved, 20u);
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
