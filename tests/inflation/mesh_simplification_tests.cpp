// SPDX-License-Identifier: MIT
#include "inflation/mesh_simplification.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "inflation/closed_mesh.h"
#include "inflation/models.h"

namespace flg::test {
namespace {

ClosedMesh checked(const MergedMesh& mesh) {
    return check_closed(mesh.positions, {mesh.triangles.data(), mesh.triangles.size()});
}

SimplifiedMesh simplified(const MergedMesh& mesh, const BoneWeights& weights, uint32_t vertices,
                          bool haltingly = false) {
    return made([&](Pace& pace) { return simplify_mesh(pace, mesh, weights, vertices); }, haltingly);
}

TEST(MeshSimplification, ABallStaysOne) {
    Model model;
    model.add({ellipse(0, 0, 1, 1, 400)}, placement({0, 0, 0}));
    const MergedMesh mesh = merged(model, {.vertices = 5000});
    double before = 0;
    for (const uint32_t vertices : {4000u, 1000u, 200u, 20u}) {
        const SimplifiedMesh fewer = simplified(mesh, {}, vertices);
        const ClosedMesh ball = checked(fewer.mesh);
        EXPECT_EQ(ball.fault, "");
        EXPECT_EQ(ball.euler, 2);
        EXPECT_EQ(fewer.mesh.positions.size(), vertices);
        double off = 0;
        for (const Vec3& p : fewer.mesh.positions) off = std::max(off, std::fabs(p.norm() - 1));
        // The sides of even triangles bulge by that; quadrics put vertices outside by as much.
        EXPECT_LT(off, 6.0 / vertices);
        EXPECT_GT(off, before / 100);
        EXPECT_NEAR(ball.volume, 4 * std::numbers::pi / 3, 30.0 / vertices);
        before = off;
    }
}

TEST(MeshSimplification, KeepsShapeBordersAndWeights) {
    const Model model = animal();
    const MergedMesh mesh = merged(model, {.vertices = 10000});
    const BoneWeights weights = weights_of(mesh, model);
    const PartUnion parts = run_now(test_memory(), [&](Pace& pace) { return PartUnion::make(pace, model.parts, -1); });
    const ClosedMesh whole = checked(mesh);
    const std::set<uint32_t> all(mesh.triangle_parts.begin(), mesh.triangle_parts.end());
    for (const uint32_t vertices : {5000u, 2000u, 700u}) {
        const SimplifiedMesh fewer = simplified(mesh, weights, vertices);
        const ClosedMesh closed = checked(fewer.mesh);
        EXPECT_EQ(closed.fault, "");
        EXPECT_EQ(closed.euler, 2);
        EXPECT_EQ(fewer.mesh.positions.size(), vertices);
        EXPECT_NEAR(closed.volume / whole.volume, 1, 30.0 / vertices);
        EXPECT_EQ(std::set<uint32_t>(fewer.mesh.triangle_parts.begin(), fewer.mesh.triangle_parts.end()), all);
        double off = 0;
        for (const Vec3& p : fewer.mesh.positions) off = std::max(off, std::fabs(parts.sample(p).value));
        EXPECT_LT(off, 0.6 * fewer.mesh.spacing);
        // Of each vertex, the weights of the nearest vertex of the whole mesh.
        double worst = 0, sum_off = 0;
        for (size_t v = 0; v < fewer.mesh.positions.size(); ++v) {
            size_t nearest = 0;
            for (size_t w = 0; w < mesh.positions.size(); ++w)
                if ((mesh.positions[w] - fewer.mesh.positions[v]).squaredNorm() <
                    (mesh.positions[nearest] - fewer.mesh.positions[v]).squaredNorm())
                    nearest = w;
            std::map<uint32_t, double> change;
            double sum = 0;
            for (uint32_t k = 0; k < 4; ++k) {
                const double weight = static_cast<double>(fewer.weights.weights[v][k]);
                EXPECT_GE(weight, 0);
                sum += weight;
                change[fewer.weights.joints[v][k]] += weight;
                change[weights.joints[nearest][k]] -= static_cast<double>(weights.weights[nearest][k]);
            }
            EXPECT_NEAR(sum, 1, 1e-5);
            double most = 0;
            for (const auto& [joint, by] : change) most = std::max(most, std::fabs(by));
            worst = std::max(worst, most);
            sum_off += most / vertices;
        }
        EXPECT_LT(sum_off, 0.05);
        EXPECT_LT(worst, 0.5);
    }
}

// Borders lie where they lay: of the vertices that had them, some are left, and each border is one chain.
TEST(MeshSimplification, BordersStayWhereTheyAre) {
    Model model;
    model.add({ellipse(0, 0, 1, 1, 400)}, placement({-0.6, 0, 0}));
    model.repeat(0, placement({0.6, 0, 0}));
    const SimplifiedMesh fewer = simplified(merged(model, {.vertices = 5000, .blend = 0}), {}, 500);
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> part_of_side;
    const MergedMesh& mesh = fewer.mesh;
    for (size_t t = 0; t < mesh.triangles.size(); ++t)
        for (uint32_t k = 0; k < 3; ++k)
            part_of_side[{mesh.triangles[t][k], mesh.triangles[t][(k + 1) % 3]}] = mesh.triangle_parts[t];
    double length = 0;
    for (const auto& [side, part] : part_of_side) {
        if (part >= part_of_side[{side.second, side.first}]) continue;
        const Vec3 &a = mesh.positions[side.first], &b = mesh.positions[side.second];
        EXPECT_NEAR(a.x(), 0, 0.002);
        EXPECT_NEAR(std::hypot(a.y(), a.z()), 0.8, 0.01);
        length += (b - a).norm();
    }
    EXPECT_NEAR(length, 2 * std::numbers::pi * 0.8, 0.1);
}

TEST(MeshSimplification, StopsWhereNothingMayGo) {
    Model model;
    model.add({ellipse(0, 0, 1, 1, 400)}, placement({0, 0, 0}));
    const SimplifiedMesh least = simplified(merged(model, {.vertices = 300}), {}, 1);
    EXPECT_EQ(checked(least.mesh).fault, "");
    EXPECT_LT(least.mesh.positions.size(), 12u);
    EXPECT_GE(least.mesh.positions.size(), 4u);
}

TEST(MeshSimplification, SameBitsWithPauses) {
    const Model model = animal();
    const MergedMesh mesh = merged(model, {.vertices = 3000});
    const BoneWeights weights = weights_of(mesh, model);
    const SimplifiedMesh a = simplified(mesh, weights, 1000), b = simplified(mesh, weights, 1000, true);
    EXPECT_TRUE(
        std::equal(a.mesh.positions.begin(), a.mesh.positions.end(), b.mesh.positions.begin(), b.mesh.positions.end()));
    EXPECT_TRUE(
        std::equal(a.mesh.triangles.begin(), a.mesh.triangles.end(), b.mesh.triangles.begin(), b.mesh.triangles.end()));
    EXPECT_TRUE(std::equal(a.weights.weights.begin(), a.weights.weights.end(), b.weights.weights.begin(),
                           b.weights.weights.end()));
}

}  // namespace
}  // namespace flg::test
