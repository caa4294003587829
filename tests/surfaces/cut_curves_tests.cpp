// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_curves.h"

#include <set>

#include "core/failure.h"
#include "runtime/run_now.h"
#include "surfaces/cut_curves_cases.h"
#include "surfaces/tracing/isolines.h"

namespace flg::test {
namespace {

TEST(CurveCutter, ALineHalvesTheSquare) {
    CurveCase cut(plane(20, 0.2));
    cut.add_line({{0, 0.301, 0}, {1, 0.532, 0}});
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    ASSERT_EQ(cut.parts.size(), 2u);
    EXPECT_EQ(cut.parts[0].old_label, 0u);
    EXPECT_NEAR(std::min(area_of(cut.mesh, 1), area_of(cut.mesh, 2)), 0.4165, 5e-4);
    EXPECT_NEAR(area_of(cut.mesh, 1) + area_of(cut.mesh, 2), 1, 1e-6);
    // The chain is the line.
    for (uint32_t vertex : cut.out.vertices) {
        const Vec3 p = cut.mesh.position(vertex);
        EXPECT_NEAR(p.y(), 0.301 + 0.231 * p.x(), 2 * cut_tolerance / 20);
    }
}

TEST(CurveCutter, LinesThatCrossMakeFourParts) {
    CurveCase cut(plane(7, 0.2));
    cut.add_line({{0, 0.301, 0}, {1, 0.532, 0}});
    cut.add_line({{0.432, 0, 0}, {0.617, 1, 0}});
    cut.run(5);
    expect_valid(cut.mesh);
    expect_chains(cut);
    ASSERT_EQ(cut.parts.size(), 4u);
    EXPECT_EQ(area_of(cut.mesh, 0), 0);
    // The crossing, of y = 0.301 + 0.231 x and x = 0.432 + 0.185 y, is a vertex of both chains.
    const double x = (0.432 + 0.185 * 0.301) / (1 - 0.185 * 0.231);
    const std::set<uint32_t> first(cut.out.vertices.begin(), cut.out.vertices.begin() + cut.out.offsets[1]);
    uint32_t shared = no_index;
    for (uint32_t i = cut.out.offsets[1]; i < cut.out.offsets[2]; ++i) {
        if (first.contains(cut.out.vertices[i])) shared = cut.out.vertices[i];
    }
    ASSERT_NE(shared, no_index);
    EXPECT_NEAR(cut.mesh.position(shared).x(), x, cut_tolerance / 7);
    EXPECT_NEAR(cut.mesh.position(shared).y(), 0.301 + 0.231 * x, cut_tolerance / 7);
}

TEST(CurveCutter, ALoopCutsOutItsInside) {
    CurveCase cut(plane(9, 0.2));
    cut.add_line({{0.21, 0.22, 0}, {0.83, 0.31, 0}, {0.47, 0.78, 0}}, true);
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    ASSERT_EQ(cut.parts.size(), 2u);
    const double inside = 0.5 * turn({0.21, 0.22, 0}, {0.83, 0.31, 0}, {0.47, 0.78, 0});
    EXPECT_NEAR(std::min(area_of(cut.mesh, 1), area_of(cut.mesh, 2)), inside, 2e-3);
}

TEST(CurveCutter, ACurveThatSeparatesNothingLeavesTheLabels) {
    CurveCase cut(plane(6, 0.2));
    cut.add_line({{0.21, 0.22, 0}, {0.83, 0.31, 0}, {0.47, 0.78, 0}});
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    EXPECT_TRUE(cut.parts.empty());
    EXPECT_NEAR(area_of(cut.mesh, 0), 1, 1e-6);
    const Vec3 start = cut.mesh.position(cut.out.vertices.front()), end = cut.mesh.position(cut.out.vertices.back());
    EXPECT_NEAR((start - Vec3(0.21, 0.22, 0)).norm(), 0, 2 * cut_tolerance / 6);
    EXPECT_NEAR((end - Vec3(0.47, 0.78, 0)).norm(), 0, 2 * cut_tolerance / 6);
}

// Along the edges y = 0.5, from vertex to vertex, and across a diagonal through its middle.
TEST(CurveCutter, RunsAlongEdgesAndThroughVertices) {
    CurveCase cut(plane(4));
    const uint32_t vertices = cut.mesh.vertex_count();
    std::vector<SurfacePoint> points;
    for (uint32_t x = 0; x < 4; ++x) points.push_back({2 * (2 * 4 + x), 0, 0});
    points.push_back({2 * (2 * 4 + 3), 1, 0});
    add_curve(cut.curves, points);
    cut.run();
    expect_valid(cut.mesh);
    expect_chains(cut);
    EXPECT_EQ(cut.mesh.vertex_count(), vertices);
    EXPECT_EQ(cut.out.vertices.size(), 5u);
    EXPECT_EQ(cut.parts.size(), 2u);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 1), 0.5);
    EXPECT_DOUBLE_EQ(area_of(cut.mesh, 2), 0.5);
}

// Isolines traced and then embedded divide the surface as the cut along them does.
TEST(CurveCutter, AgreesWithTheCutAlongIsolines) {
    for (const Soup& soup : {sphere(4), torus(40, 24)}) {
        CurveCase traced(soup);
        Mesh sliced = make_mesh(soup);
        const auto height = [](const Vec3& p) { return p.z() + 0.2 * std::sin(3 * p.x()) * p.y(); };
        const std::vector<float> levels = {-0.21f, 0.13f};
        const MeshColumn column = make_column(traced.mesh, height);
        const RegionSet all(test_memory());
        const std::span<const float> values(column.values.data(), column.values.size());
        run_now(test_memory(),
                [&](Pace& pace) { return add_isolines(pace, traced.mesh, values, levels, all, traced.curves); });
        traced.run(10);
        expect_valid(traced.mesh);
        expect_chains(traced);
        MeshColumns columns{test_memory()};
        columns.push_back(make_column(sliced, height));
        MeshEdit edit(test_memory());
        cut_isolines(sliced, columns, 0, levels, edit);

        // Each part lies in one interval.
        const MeshColumn after = make_column(traced.mesh, height);
        std::array<double, 3> areas{};
        for (const RegionPart& part : traced.parts) {
            float low = 1, high = -1;
            for (uint32_t t = 0; t < traced.mesh.triangle_count(); ++t) {
                if (traced.mesh.regions[t] != part.label) continue;
                for (uint32_t vertex : traced.mesh.triangles[t]) {
                    low = std::min(low, after.values[vertex]);
                    high = std::max(high, after.values[vertex]);
                }
            }
            const auto middle = 0.5f * (low + high);
            areas[static_cast<size_t>((middle > levels[0]) + (middle > levels[1]))] += area_of(traced.mesh, part.label);
        }
        for (uint32_t i = 0; i < 3; ++i) EXPECT_NEAR(areas[i], area_of(sliced, i), 0.01) << "interval " << i;
    }
}

TEST(CurveCutter, RefusesWhatIsNotOnTheMesh) {
    const auto fails = [](const std::vector<SurfacePoint>& points) {
        CurveCase cut(plane(4));
        const std::vector<uint32_t> before = bits_of(cut.mesh, cut.columns);
        add_curve(cut.curves, points);
        EXPECT_THROW(cut.run(), Failure);
        EXPECT_EQ(bits_of(cut.mesh, cut.columns), before);
    };
    fails({{0, 0.2f, 0.2f}, {32, 0.2f, 0.2f}});
    fails({{0, 0.2f, 0.2f}, {0, 0.7f, 0.7f}});
    fails({{0, 0.2f, 0.2f}, {0, -0.1f, 0.7f}});
    fails({{0, std::nanf(""), 0.2f}, {0, 0.1f, 0.7f}});
    fails({{0, 0.2f, 0.2f}, {9, 0.3f, 0.3f}});
}

}  // namespace
}  // namespace flg::test
