// SPDX-License-Identifier: MIT
#include "surfaces/tracing/surface_bezier.h"

#include <gtest/gtest.h>

#include "reference/literal_surface_bezier.h"
#include "surfaces/test_meshes.h"
#include "surfaces/tracing/straight_walk.h"

namespace flg::test {
namespace {

SurfacePoint inside(uint32_t triangle, float u = 0.3f, float v = 0.3f) {
    return {triangle, u, v};
}

SurfacePoint at_vertex(const Mesh& mesh, uint32_t vertex) {
    const Corner corner = mesh.corner_of_vertex[vertex];
    return {triangle_of(corner), corner % 3 == 1 ? 1.0f : 0.0f, corner % 3 == 2 ? 1.0f : 0.0f};
}

struct Made {
    SurfaceBezier curve{test_memory()};
    BezierResult result;
};

Made make(const Mesh& mesh, const std::vector<SurfacePoint>& given, bool closed = false, uint32_t halvings = 5,
          const SurfaceBezier* before = nullptr, bool haltingly = false) {
    Made made;
    made.curve.closed = closed;
    made.curve.halvings = halvings;
    made.curve.given.assign(given.begin(), given.end());
    made.result = run_now(
        test_memory(), [&](Pace& pace) { return make_surface_bezier(pace, mesh, before, made.curve); }, haltingly);
    return made;
}

std::vector<Vec3> places(const Mesh& mesh, const SurfaceBezier& curve) {
    std::vector<Vec3> out;
    for (const SurfacePoint& point : curve.nodes) out.push_back(position_of(mesh, point));
    return out;
}

// In degrees, from chord to chord, of nodes i - 1, i, i + 1.
double largest_turn(const std::vector<Vec3>& nodes) {
    double largest = 0;
    for (size_t i = 1; i + 1 < nodes.size(); ++i) {
        const Vec3 a = nodes[i] - nodes[i - 1], b = nodes[i + 1] - nodes[i];
        if (a.norm() < 1e-9 || b.norm() < 1e-9) continue;
        largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi);
    }
    return largest;
}

std::vector<SurfacePoint> random_stroke(const Mesh& mesh, uint64_t seed, uint32_t count) {
    std::vector<SurfacePoint> out;
    for (uint32_t i = 0; i < count; ++i) {
        if (seed % 2 == 0) {
            out.push_back(at_vertex(mesh, random_below(seed, i, 0, mesh.vertex_count())));
        } else {
            out.push_back(inside(random_below(seed, i, 0, mesh.triangle_count())));
        }
    }
    return out;
}

// In the plane: Catmull and Rom's handles with chordal knots, natural ends, and Bernstein's polynomials.
std::vector<Vec3> planar(const std::vector<Vec3>& p, uint32_t halvings) {
    std::vector<Vec3> out;
    const auto tangent = [&](size_t i) {
        const double d0 = (p[i] - p[i - 1]).norm(), d1 = (p[i + 1] - p[i]).norm();
        return Vec3((d0 * (p[i + 1] - p[i]) / d1 + d1 * (p[i] - p[i - 1]) / d0) / (d0 + d1));
    };
    for (size_t s = 0; s + 1 < p.size(); ++s) {
        const double d = (p[s + 1] - p[s]).norm();
        Vec3 h0 = p[s], h1 = p[s + 1];
        if (s > 0) h0 = p[s] + tangent(s) * d / 3;
        if (s + 2 < p.size()) h1 = p[s + 1] - tangent(s + 1) * d / 3;
        if (s == 0) h0 = 0.5 * (p[s] + h1);
        if (s + 2 == p.size()) h1 = 0.5 * (h0 + p[s + 1]);
        const uint32_t intervals = 1u << halvings;
        for (uint32_t i = s == 0 ? 0 : 1; i <= intervals; ++i) {
            const double t = double(i) / intervals, w = 1 - t;
            out.push_back(w * w * w * p[s] + 3 * w * w * t * h0 + 3 * w * t * t * h1 + t * t * t * p[s + 1]);
        }
    }
    return out;
}

TEST(SurfaceBezier, InThePlaneIsTheOrdinaryCurve) {
    const Mesh mesh = make_mesh(plane(24, 0.3));
    const std::vector<SurfacePoint> given = {inside(300), inside(420, 0.1f, 0.6f), at_vertex(mesh, 362), inside(800)};
    std::vector<Vec3> points;
    for (const SurfacePoint& point : given) points.push_back(position_of(mesh, point));
    const Made made = make(mesh, given);
    ASSERT_TRUE(made.result.found);
    const std::vector<Vec3> expected = planar(points, 5), nodes = places(mesh, made.curve);
    ASSERT_EQ(nodes.size(), expected.size());
    for (size_t i = 0; i < nodes.size(); ++i) EXPECT_LT((nodes[i] - expected[i]).norm(), 2e-6) << i;
}

TEST(SurfaceBezier, IsDeCasteljausConstructionToTheLetter) {
    for (const bool closed : {false, true}) {
        // Nowhere convex, so there is one locally shortest path.
        const Mesh mesh =
            make_mesh(grid(12, 12, [](double x, double y) { return Vec3(x, y, 3 * (x - 0.5) * (y - 0.5)); }));
        const std::vector<SurfacePoint> given = {inside(100), inside(62), inside(180, 0.5f, 0.2f), inside(207)};
        const Made made = make(mesh, given, closed, 3);
        ASSERT_TRUE(made.result.found);
        const auto control = literal::surface_handles(mesh, given, closed);
        double largest = 0;
        for (size_t s = 0; s < control.size(); ++s) {
            const std::vector<SurfacePoint> expected = literal::surface_bezier(mesh, control[s], 3);
            for (size_t i = 0; i <= 8; ++i) {
                const size_t node = (8 * s + i) % made.curve.nodes.size();
                const Vec3 off = position_of(mesh, made.curve.nodes[node]) - position_of(mesh, expected[i]);
                largest = std::max(largest, off.norm());
            }
        }
        EXPECT_LT(largest, 1e-4);
    }
}

TEST(SurfaceBezier, TwoPointsAreJoinedByTheirShortestPath) {
    const Mesh mesh = make_mesh(sphere(4));
    const Made made = make(mesh, {at_vertex(mesh, 0), at_vertex(mesh, 9)});
    ASSERT_TRUE(made.result.found);
    const std::vector<Vec3> nodes = places(mesh, made.curve);
    const Vec3 across = nodes.front().cross(nodes.back()).normalized();
    for (const Vec3& node : nodes) EXPECT_NEAR(node.dot(across), 0, 0.02);
}

TEST(SurfaceBezier, PassesThroughThePointsWithoutACorner) {
    const Mesh mesh = make_mesh(torus(120, 50));
    for (uint64_t seed = 1; seed <= 6; ++seed) {
        std::vector<SurfacePoint> given;
        for (uint32_t i = 0; i < 8; ++i) {
            const uint32_t around = 15 * i, tube = (17 * i + 5 * static_cast<uint32_t>(seed)) % 50;
            const uint32_t vertex = (around * 50 + tube) % mesh.vertex_count();
            given.push_back(seed % 2 ? at_vertex(mesh, vertex) : inside(2 * vertex));
        }
        for (const bool closed : {false, true}) {
            const Made made = make(mesh, given, closed);
            ASSERT_TRUE(made.result.found);
            const std::vector<Vec3> nodes = places(mesh, made.curve);
            for (size_t i = 0; i < given.size(); ++i)
                EXPECT_EQ((nodes[32 * i] - position_of(mesh, given[i])).norm(), 0);
            EXPECT_LT(largest_turn(nodes), 25) << seed;
        }
    }
}

// Between neighbours it is a shortest path's length at most a leaf's polygon, which halves with each level.
TEST(SurfaceBezier, IsWholeOnAnyConnectedMesh) {
    const Soup soups[] = {sphere(0), tetrahedron(), torus(7, 5), cylinder(9, 3), plane(4, 0.3)};
    for (const Soup& soup : soups) {
        const Mesh mesh = make_mesh(soup);
        for (uint64_t seed = 0; seed < 40; ++seed) {
            const std::vector<SurfacePoint> given = random_stroke(mesh, seed, 3 + seed % 6);
            const Made made = make(mesh, given, seed % 4 > 1);
            ASSERT_TRUE(made.result.found);
            ASSERT_EQ(made.curve.nodes.size(), size_t{made.curve.segments()} * 32 + (made.curve.closed ? 0 : 1));
            const std::vector<Vec3> nodes = places(mesh, made.curve);
            for (size_t i = 0; i + 1 < nodes.size(); ++i) {
                EXPECT_TRUE(nodes[i].allFinite());
                EXPECT_LT((nodes[i + 1] - nodes[i]).norm(), 1.0) << seed;
            }
        }
    }
}

TEST(SurfaceBezier, KeepsSegmentsFarFromADraggedPoint) {
    const Mesh mesh = make_mesh(torus(60, 24));
    for (const bool closed : {false, true}) {
        std::vector<SurfacePoint> given;
        for (uint32_t i = 0; i < 9; ++i) given.push_back(inside((i * 6 * 24 + i * 5 % 24) * 2 % mesh.triangle_count()));
        const Made before = make(mesh, given, closed);
        given[4] = inside(given[4].triangle + 2, 0.2f, 0.5f);
        const Made anew = make(mesh, given, closed), kept = make(mesh, given, closed, 5, &before.curve);
        ASSERT_TRUE(anew.result.found && kept.result.found);
        ASSERT_EQ(anew.curve.nodes.size(), kept.curve.nodes.size());
        EXPECT_EQ(places(mesh, anew.curve), places(mesh, kept.curve));
        EXPECT_NE(places(mesh, before.curve), places(mesh, kept.curve));
        const Made haltingly = make(mesh, given, closed, 5, nullptr, true);
        EXPECT_EQ(places(mesh, anew.curve), places(mesh, haltingly.curve));
    }
}

TEST(SurfaceBezier, SaysBetweenWhichPointsThereIsNoWay) {
    Soup soup = sphere(0);
    const auto first = static_cast<uint32_t>(soup.positions.size()),
               triangles = static_cast<uint32_t>(soup.triangles.size());
    for (const Position& p : sphere(0).positions) soup.positions.push_back({p[0] + 5, p[1], p[2]});
    for (const Triple& t : sphere(0).triangles) soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    const Mesh mesh = make_mesh(soup);
    const Made made = make(mesh, {inside(0), inside(5), inside(triangles + 3)});
    EXPECT_FALSE(made.result.found);
    EXPECT_LE(made.result.without_way, 1u);
}

TEST(StraightWalk, GoesStraightAcrossAPlaneAndStopsAtItsBorder) {
    const Mesh mesh = make_mesh(plane(13, 0.4));
    for (uint64_t seed = 0; seed < 50; ++seed) {
        const SurfacePoint from = seed % 2 ? inside(random_below(seed, 0, 0, mesh.triangle_count()))
                                           : at_vertex(mesh, random_below(seed, 0, 1, mesh.vertex_count()));
        DirectionFrame frame(test_memory());
        SurfacePath path(test_memory());
        run_now(test_memory(), [&](Pace& pace) { return set_frame(pace, frame, mesh, place_in(mesh, from)); });
        ASSERT_TRUE(frame.is_valid());
        const double angle = 2 * std::numbers::pi * random_unit(seed, 1, 0), length = random_unit(seed, 1, 1);
        const SurfaceRay ray = frame.ray(mesh, angle);
        run_now(test_memory(), [&](Pace& pace) { return walk_straight(pace, mesh, ray, length, path); });
        const Vec3 start = position_of(mesh, from), end = position_of(mesh, path.points.back());
        const Vec3 wanted = start + length * ray.direction;
        const bool stays = wanted.x() > 0.01 && wanted.x() < 0.99 && wanted.y() > 0.01 && wanted.y() < 0.99;
        if (stays) {
            EXPECT_LT((end - wanted).norm(), 3e-5) << seed;
        }
        EXPECT_LE(path.length(), length + 3e-5);
        EXPECT_LT((end - start).cross(ray.direction).norm(), 3e-5) << seed;
    }
}

}  // namespace
}  // namespace flg::test
