// SPDX-License-Identifier: MIT
#include "surfaces/sampling/spaced_points.h"

#include <gtest/gtest.h>

#include "runtime/run_now.h"
#include "surfaces/test_meshes.h"

namespace flg::test {
namespace {

std::vector<uint32_t> choose(const Mesh& mesh, float spacing, uint32_t most, float away = 1e30f,
                             bool haltingly = false) {
    Buffer<SpacedCandidate> candidates(mesh.vertex_count(), test_memory());
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) candidates[v] = {v, v == 0 ? 0 : away};
    const auto points = run_now(
        test_memory(), [&](Pace& pace) { return choose_spaced_points(pace, mesh, candidates, spacing, most, 1); },
        haltingly);
    return {points.begin(), points.end()};
}

// Each is the vertex that is furthest from those before it, by brute force.
TEST(SpacedPoints, AreTheFurthestInSpace) {
    const Mesh mesh = make_mesh(torus(40, 20));
    const std::vector<uint32_t> points = choose(mesh, 0.3f, 1000);
    ASSERT_GT(points.size(), 10u);
    const auto distance = [&](uint32_t vertex, size_t count) {
        double nearest = 1e30;
        for (size_t i = 0; i < count; ++i) {
            nearest = std::min(nearest, (mesh.position(vertex) - mesh.position(points[i])).norm());
        }
        return nearest;
    };
    for (size_t i = 1; i <= points.size(); ++i) {
        double furthest = 0;
        for (uint32_t v = 1; v < mesh.vertex_count(); ++v) furthest = std::max(furthest, distance(v, i));
        if (i == points.size()) {
            EXPECT_LT(furthest, 0.3 + 1e-6) << "no more fit";
        } else {
            EXPECT_NEAR(distance(points[i], i), furthest, 1e-6);
        }
    }
    EXPECT_EQ(choose(mesh, 0.3f, 1000, 1e30f, true), points) << "with pauses";
}

TEST(SpacedPoints, KeepAwayAndStopAtTheMost) {
    const Mesh mesh = make_mesh(torus(40, 20));
    EXPECT_EQ(choose(mesh, 0.01f, 7).size(), 7u);
    EXPECT_EQ(choose(mesh, 1e-9f, 1u << 20).size(), max_spaced_points);
    EXPECT_TRUE(choose(mesh, 0.3f, 1000, 0.2f).empty()) << "everything is nearer to what points keep away from";
    EXPECT_TRUE(choose(mesh, 0.3f, 0).empty());
}

}  // namespace
}  // namespace flg::test
