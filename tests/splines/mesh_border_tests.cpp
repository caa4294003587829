// SPDX-License-Identifier: MIT
#include "splines/manifolds/mesh_border.h"

#include <numbers>

#include "core/random.h"
#include "splines/sample_checks.h"
#include "splines/spline_checks.h"

namespace flg::test {
namespace {

// The unit square in so many cells, without those whose middle `is_out`.
template <class IsOut>
Soup square_without(uint32_t cells, IsOut&& is_out) {
    Soup soup;
    std::vector<uint32_t> number((cells + 1) * (cells + 1), no_index);
    const auto vertex = [&](uint32_t i, uint32_t j) {
        uint32_t& at = number[j * (cells + 1) + i];
        if (at == no_index) {
            at = static_cast<uint32_t>(soup.positions.size());
            soup.positions.push_back(to_position(Vec3(double(i) / cells, double(j) / cells, 0)));
        }
        return at;
    };
    for (uint32_t j = 0; j < cells; ++j) {
        for (uint32_t i = 0; i < cells; ++i) {
            if (is_out((i + 0.5) / cells, (j + 0.5) / cells)) continue;
            const uint32_t a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
            soup.triangles.push_back({a, b, c});
            soup.triangles.push_back({a, c, d});
        }
    }
    return soup;
}

// Without a disc, in stairs.
Soup square_with_hole() {
    return square_without(40, [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.22; });
}

MeshBorder border_of(const Mesh& mesh, bool haltingly = false) {
    return *run_now(
        test_memory(), [&](Pace& pace) { return mesh_border(pace, mesh, 0); }, haltingly);
}

BorderView look(const MeshBorder& border, const Vec3& x) {
    BorderView view{};
    EXPECT_TRUE(border.look(x, nullptr, view)) << x.transpose();
    return view;
}

// An L: the square without its upper right quarter. A corner that points in, and five that point out.
TEST(MeshBorder, KnowsHowFarInsidePointsAre) {
    const Mesh mesh = make_mesh(square_without(10, [](double x, double y) { return x > 0.5 && y > 0.5; }));
    const MeshBorder border = border_of(mesh);
    ASSERT_EQ(border.edges().size(), 40u);
    const auto expect = [&](const Vec3& x, double inside, const Vec3& inwards) {
        const BorderView view = look(border, x);
        EXPECT_NEAR(view.inside, inside, 1e-7) << x.transpose();
        EXPECT_LT((view.inwards - inwards).norm(), 1e-6) << x.transpose();
    };
    expect(Vec3(0.23, 0.02, 0.01), 0.02, Vec3(0, 1, 0));
    expect(Vec3(0.23, -0.02, 0.01), -0.02, Vec3(0, 1, 0));
    expect(Vec3(-0.03, -0.04, 0), -0.05, Vec3(0.6, 0.8, 0));
    expect(Vec3(0.5 - 0.03, 0.5 - 0.04, 0), 0.05, Vec3(-0.6, -0.8, 0));
    expect(Vec3(0.52, 0.57, 0), -0.02, Vec3(-1, 0, 0));
    EXPECT_NEAR(look(border, Vec3(-0.03, -0.04, 0)).curvature, 20, 1e-4);
    EXPECT_NEAR(look(border, Vec3(0.5 - 0.03, 0.5 - 0.04, 0)).curvature, -20, 1e-4);
    EXPECT_TRUE(look(border, Vec3(0.5, 0.5, 0.01)).points_in);
    EXPECT_TRUE(look(border, Vec3(0.5, 0.5, 0)).at_vertex);
    EXPECT_FALSE(look(border, Vec3(1, 0, 0)).points_in);
    BorderView view{};
    EXPECT_FALSE(border.look(Vec3(10, 10, 0), nullptr, view));
    const Vec3 down(0, 0, -1);
    EXPECT_FALSE(border.look(Vec3(0.23, 0.02, 0.01), &down, view)) << "the mesh faces up";
}

TEST(MeshBorder, IsTheSameInAnySlices) {
    const Mesh mesh = make_mesh(square_with_hole());
    const MeshBorder whole = border_of(mesh), sliced = border_of(mesh, true);
    ASSERT_EQ(whole.edges().size(), sliced.edges().size());
    for (size_t i = 0; i < whole.edges().size(); ++i) {
        EXPECT_EQ(whole.edges()[i].from, sliced.edges()[i].from);
        EXPECT_EQ(whole.edges()[i].after, sliced.edges()[i].after);
        EXPECT_EQ(whole.edges()[whole.edges()[i].after].before, i);
    }
}

TEST(MeshBorder, ClosedMeshesHaveNone) {
    const Mesh mesh = make_mesh(sphere(2));
    EXPECT_FALSE(run_now(test_memory(), [&](Pace& pace) { return mesh_border(pace, mesh, 0); }));
}

// Random points close around the hole: straight chains through them are put out of it, and come to rest.
TEST(MeshBorder, CurvesComeToRestWithinIt) {
    const Mesh mesh = make_mesh(square_with_hole());
    const SampledSurface surface = sample(mesh);
    const MeshBorder border = border_of(mesh);
    uint32_t pressed = 0;
    for (const double within : {0.0, 0.012, -0.25 / 40}) {
        for (uint64_t stroke = 0; stroke < 30; ++stroke) {
            std::vector<Vec3> points;
            for (uint32_t k = 0; k < 5; ++k) {
                const double angle = 2 * std::numbers::pi * random_unit(stroke, 0, 0) + 1.6 * k,
                             radius = 0.26 + 0.15 * random_unit(stroke, 1, k);
                points.push_back(Vec3(0.5 + radius * std::cos(angle), 0.5 + radius * std::sin(angle), 0));
            }
            SplineProblem problem = chain_problem(surface.surface, points, 24);
            problem.border = &border;
            problem.within = within;
            problem.holds_nodes = true;
            problem.tolerance = 1e-4;
            problem.bending = stroke % 3 == 2 ? 0 : 1;
            problem.tension = stroke % 3 == 1 ? 10 : stroke % 3 == 2 ? 1 : 0;
            const SolvedSpline solved = solve_spline(problem);
            EXPECT_EQ(solved.report.ending, SplineEnding::converged)
                << stroke << " within " << within << ", residual " << solved.report.residual << " after "
                << solved.report.rounds;
            EXPECT_EQ(solved.report.held, 0u);
            pressed += solved.report.pressed;
            for (const Vec3& x : solved.points) {
                BorderView view{};
                if (!border.look(x, nullptr, view)) continue;
                EXPECT_GE(view.inside, within - 1e-8) << stroke;
            }
        }
    }
    EXPECT_GT(pressed, 100u);
}

}  // namespace
}  // namespace flg::test
