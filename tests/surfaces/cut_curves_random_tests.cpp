// SPDX-License-Identifier: MIT
// Curves of all kinds at once: what must hold whatever they are.
#include <gtest/gtest.h>

#include "surfaces/cut_curves_cases.h"

namespace flg::test {
namespace {

TEST(CurveCutter, ManySegmentsInOneTriangle) {
    CurveCase cut(Soup{{{0, 0, 0}, {1, 0, 0}, {0.2f, 0.9f, 0}}, {{0, 1, 2}}});
    for (uint32_t i = 0; i < 40; ++i) {
        const auto point = [&](uint32_t end) {
            const float t = static_cast<float>(random_unit(7, i, end));
            const float s = static_cast<float>(random_unit(8, i, end));
            return random_below(9, i, end, 3) == 0 ? SurfacePoint{0, t * s, t * (1 - s)}
                                                   : point_on_edge(random_below(6, i, end, 3), t);
        };
        add_curve(cut.curves, {point(0), point(1), point(2)}, i % 4 == 0);
    }
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    EXPECT_NEAR(area_of(cut.mesh), 0.45, 1e-6);
    EXPECT_EQ(euler_number(cut.mesh), 1);
    EXPECT_GT(cut.parts.size(), 100u);
    for (uint32_t t = 0; t < cut.mesh.triangle_count(); ++t) EXPECT_GT(area_vector(cut.mesh, t).z(), -1e-9);
}

// A slice holds so many units, whatever a unit has to look at.
TEST(CurveCutter, ACrowdedTriangleTakesMoreSlices) {
    CurveCase cut(Soup{{{0, 0, 0}, {1, 0, 0}, {0.2f, 0.9f, 0}}, {{0, 1, 2}}});
    for (uint32_t i = 0; i < 100; ++i) {
        const auto t = static_cast<float>(random_unit(7, i, 0)), s = static_cast<float>(random_unit(8, i, 0));
        const uint32_t edge = random_below(6, i, 0, 3);
        add_curve(cut.curves, {point_on_edge(edge, t), point_on_edge((edge + 1) % 3, s)}, false);
    }
    uint32_t slices = 0;
    run_haltingly(
        test_memory(),
        [&](Pace& pace) { return embed_curves(pace, cut.mesh, cut.columns, cut.curves, cut.edit, cut.out); },
        [&](const auto& slice) {
            slice();
            ++slices;
        });
    expect_valid(cut.mesh);
    EXPECT_GT(cut.mesh.triangle_count(), 1000u);
    EXPECT_GT(slices, 2000u) << "one for every few steps that look at hundreds of triangles";
}

TEST(CurveCutter, ManyCutsKeepTheMeshWhole) {
    const Soup soups[] = {sphere(2), torus(12, 8), plane(8, 0.3)};
    const int euler[] = {2, 0, 1};
    for (uint32_t i = 0; i < 3; ++i) {
        CurveCase cut(soups[i]);
        const double area = area_of(cut.mesh);
        std::deque<MeshEdit> edits;
        std::vector<std::vector<uint32_t>> states = {bits_of(cut.mesh, cut.columns)};
        for (uint32_t n = 0; n < 40; ++n) {
            SCOPED_TRACE(testing::Message() << "mesh " << i << ", cut " << n);
            cut.curves = SurfaceCurves(test_memory());
            cut.out = EmbeddedCurves(test_memory());
            for (uint32_t k = 0; k < 5; ++k) add_curve(cut.curves, random_walk(cut.mesh, i, 5 * n + k, 12));
            cut.edit = MeshEdit(test_memory());
            cut.run(n == 0 ? 1 : cut.parts.empty() ? 1 : cut.parts.back().label + 1, true);
            edits.push_back(std::move(cut.edit));
            if (n % 10 == 0) {
                expect_valid(cut.mesh);
                expect_chains(cut);
                if (HasFailure()) return;
            }
            states.push_back(bits_of(cut.mesh, cut.columns));
        }
        EXPECT_EQ(euler_number(cut.mesh), euler[i]);
        EXPECT_NEAR(area_of(cut.mesh), area, 1e-6 * area);
        for (size_t n = edits.size(); n-- > 0;) {
            replay(cut.mesh, cut.columns, edits[n], MeshEditReplay::Direction::undo);
            EXPECT_EQ(bits_of(cut.mesh, cut.columns), states[n]) << "undo " << n;
        }
        for (size_t n = 0; n < edits.size(); ++n) {
            replay(cut.mesh, cut.columns, edits[n], MeshEditReplay::Direction::redo);
        }
        EXPECT_EQ(bits_of(cut.mesh, cut.columns), states.back());
    }
}

TEST(CurveCutter, DoesNotDependOnSlices) {
    std::vector<uint32_t> expected;
    for (bool haltingly : {false, true}) {
        CurveCase cut(sphere(3));
        for (uint32_t k = 0; k < 20; ++k) add_curve(cut.curves, random_walk(cut.mesh, 3, k, 30));
        cut.run(1, haltingly);
        std::vector<uint32_t> bits = bits_of(cut.mesh, cut.columns);
        bits.insert(bits.end(), cut.out.vertices.begin(), cut.out.vertices.end());
        if (expected.empty()) expected = bits;
        EXPECT_EQ(bits, expected) << "haltingly " << haltingly;
    }
}

TEST(CurveCutter, HoldsUpOnDegenerateTriangles) {
    Soup soup = plane(8);
    for (uint32_t v = 0; v < soup.positions.size(); ++v) {
        if (v % 3 != 0) soup.positions[v] = soup.positions[v / 2];
    }
    CurveCase cut(soup);
    for (uint32_t k = 0; k < 20; ++k) add_curve(cut.curves, random_walk(cut.mesh, 5, k, 30));
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    EXPECT_EQ(euler_number(cut.mesh), 1);
}

TEST(CurveCutter, CarriesColumnsLinearly) {
    CurveCase cut(plane(6, 0.2));
    for (uint32_t k = 0; k < 20; ++k) add_curve(cut.curves, random_walk(cut.mesh, 4, k, 30));
    cut.run();
    for (uint32_t v = 0; v < cut.mesh.vertex_count(); ++v) {
        const Vec3 p = cut.mesh.position(v);
        EXPECT_NEAR(cut.columns[0].values[v], p.x() - 2 * p.y(), 1e-6);
    }
}

}  // namespace
}  // namespace flg::test
