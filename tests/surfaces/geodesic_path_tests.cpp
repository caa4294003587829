// SPDX-License-Identifier: MIT
#include "surfaces/tracing/geodesic_path.h"

#include <gtest/gtest.h>

#include "runtime/run_now.h"
#include "surfaces/curve_checks.h"
#include "surfaces/mesh/surface_place.h"

namespace flg::test {
namespace {

constexpr double pi = std::numbers::pi;

struct Path {
    SurfaceCurves curves{test_memory()};
    double length = 0;
    bool found = false;
};

SurfacePoint at_vertex(const Mesh& mesh, uint32_t vertex) {
    const Corner corner = mesh.corner_of_vertex[vertex];
    return {triangle_of(corner), corner % 3 == 1 ? 1.0f : 0.0f, corner % 3 == 2 ? 1.0f : 0.0f};
}

SurfacePoint random_point(const Mesh& mesh, uint64_t seed) {
    const double u = random_unit(seed, 0, 0), v = random_unit(seed, 0, 1);
    const uint32_t triangle = random_below(seed, 0, 2, mesh.triangle_count());
    switch (seed % 3) {
        case 0: return {triangle, float(u * (1 - v)), float(u * v)};
        case 1: return point_on_edge(3 * triangle + 1, round_on_edge(u));
        default: return {triangle, 0, 1};
    }
}

// The corners of a triangle that is near where the distances come from; enough for a first guess.
std::vector<float> distances_to(const Mesh& mesh, const SurfacePoint& to) {
    std::vector<uint32_t> sources;
    const Weights weights = weights_of(to);
    for (uint32_t k = 0; k < 3; ++k) {
        if (weights[k] > 0) sources.push_back(mesh.triangles[to.triangle][k]);
    }
    return edge_distances(mesh, sources);
}

double angle(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

// The next triangle about a vertex; no_index where the mesh or the regions end.
uint32_t next_about(const Mesh& mesh, const RegionSet& regions, uint32_t vertex, uint32_t triangle,
                    bool counter_clockwise) {
    const Triple& t = mesh.triangles[triangle];
    const uint32_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
    const uint32_t next = mesh.neighbours[triangle][counter_clockwise ? (k + 2) % 3 : k];
    return next != no_index && regions.contains(mesh.regions[next]) ? next : no_index;
}

// The least of the angles at a vertex between two of the path's stretches; infinite across a border.
double min_angle(const Mesh& mesh, uint32_t vertex, const SurfacePoint& before, const SurfacePoint& here,
                 const SurfacePoint& after, const RegionSet& regions) {
    const Vec3 at = mesh.position(vertex);
    const Vec3 in = position_of(mesh, before) - at, out = position_of(mesh, after) - at;
    const uint32_t first = before.triangle, last = here.triangle;
    double least = std::numeric_limits<double>::infinity();
    for (bool counter_clockwise : {false, true}) {
        const auto edge = [&](uint32_t triangle, bool leaving) {
            const Triple& t = mesh.triangles[triangle];
            const uint32_t k = t[0] == vertex ? 0 : t[1] == vertex ? 1 : 2;
            return Vec3(mesh.position(t[(k + (leaving == counter_clockwise ? 2 : 1)) % 3]) - at);
        };
        if (first == last) {
            // One side lies in the triangle; its angle is that between the stretches.
            least = std::min(least, angle(in, out));
            continue;
        }
        double sum = angle(in, edge(first, true)) + angle(edge(last, false), out);
        uint32_t triangle = next_about(mesh, regions, vertex, first, counter_clockwise);
        while (triangle != no_index && triangle != last) {
            sum += angle(edge(triangle, false), edge(triangle, true));
            triangle = next_about(mesh, regions, vertex, triangle, counter_clockwise);
        }
        if (triangle == last) least = std::min(least, sum);
    }
    return least;
}

// Straight across edges: the same angle with the edge before and behind it; at vertices at least pi on both sides.
void expect_locally_shortest(const Mesh& mesh, const SurfaceCurves& curves, uint32_t curve,
                             const RegionSet& regions = RegionSet(test_memory())) {
    const auto points = points_of(curves, curve);
    for (size_t i = 1; i + 1 < points.size(); ++i) {
        const SurfacePlace place = place_in(mesh, points[i].triangle, weights_of(points[i]));
        const Vec3 at = position_of(mesh, points[i]);
        const Vec3 in = position_of(mesh, points[i - 1]) - at, out = position_of(mesh, points[i + 1]) - at;
        // Points are moved by up to 1e-6 of an edge, which shows where stretches are short.
        const Triple& t = mesh.triangles[points[i].triangle];
        const double size =
            (mesh.position(t[0]) - mesh.position(t[1])).norm() + (mesh.position(t[0]) - mesh.position(t[2])).norm();
        const double tolerance = 1e-5 + 2e-6 * size * (1 / in.norm() + 1 / out.norm());
        if (place.on == SurfacePlace::On::vertex) {
            EXPECT_GE(min_angle(mesh, place.index, points[i - 1], points[i], points[i + 1], regions), pi - tolerance)
                << "at point " << i << " of " << points.size();
        } else {
            ASSERT_EQ(place.on, SurfacePlace::On::edge);
            const Vec3 edge =
                mesh.position(mesh.vertex_at(next_corner(place.index))) - mesh.position(mesh.vertex_at(place.index));
            EXPECT_NEAR(angle(in, edge) + angle(out, edge), pi, tolerance)
                << "at point " << i << " of " << points.size();
        }
    }
}

GeodesicPath add_path(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
                      const std::vector<float>& distances, const RegionSet& regions, SurfaceCurves& out) {
    return run_haltingly(test_memory(),
                         [&](Pace& pace) { return add_geodesic_path(pace, mesh, from, to, distances, regions, out); });
}

Path find_path(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to,
               const RegionSet& regions = RegionSet(test_memory()), bool haltingly = false) {
    const auto distances = distances_to(mesh, to);
    Path path;
    const GeodesicPath found = run_now(
        test_memory(),
        [&](Pace& pace) { return add_geodesic_path(pace, mesh, from, to, distances, regions, path.curves); },
        haltingly);
    path.found = found.found;
    path.length = found.length;
    EXPECT_EQ(found.is_straight, found.found);
    if (end_polyline(path.curves, false, path.length)) {
        expect_valid(mesh, path.curves);
        expect_locally_shortest(mesh, path.curves, 0, regions);
        // The length that was reckoned in the plane is that of the curve.
        EXPECT_NEAR(length_of(mesh, path.curves, 0), path.length, 1e-6 * (1 + path.length));
        const auto points = points_of(path.curves, 0);
        EXPECT_NEAR((position_of(mesh, points.front()) - position_of(mesh, from)).norm(), 0, 1e-6);
        EXPECT_NEAR((position_of(mesh, points.back()) - position_of(mesh, to)).norm(), 0, 1e-6);
    }
    return path;
}

Mesh cube(uint32_t cells) {
    // Six grids, joined where positions are equal.
    Soup soup;
    std::map<Position, uint32_t> known;
    for (uint32_t face = 0; face < 6; ++face) {
        const uint32_t axis = face / 2;
        const Soup side = grid(cells, cells, [&](double u, double v) {
            Vec3 p;
            p[axis] = face % 2;
            p[(axis + 1) % 3] = face % 2 == 1 ? u : v;
            p[(axis + 2) % 3] = face % 2 == 1 ? v : u;
            return p;
        });
        std::vector<uint32_t> index;
        for (const Position& p : side.positions) {
            const auto [found, is_new] = known.try_emplace(p, static_cast<uint32_t>(soup.positions.size()));
            if (is_new) soup.positions.push_back(p);
            index.push_back(found->second);
        }
        for (const Triple& t : side.triangles) soup.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
    }
    return make_mesh(soup);
}

SurfacePoint nearest_vertex(const Mesh& mesh, const Vec3& place) {
    uint32_t nearest = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        if ((mesh.position(v) - place).norm() < (mesh.position(nearest) - place).norm()) nearest = v;
    }
    return at_vertex(mesh, nearest);
}

TEST(GeodesicPath, IsStraightOnAPlane) {
    const Mesh mesh = make_mesh(plane(16, 0.2));
    for (uint64_t seed = 0; seed < 60; ++seed) {
        const SurfacePoint from = random_point(mesh, 2 * seed), to = random_point(mesh, 2 * seed + 1001);
        const Path path = find_path(mesh, from, to);
        EXPECT_TRUE(path.found);
        EXPECT_NEAR(path.length, (position_of(mesh, from) - position_of(mesh, to)).norm(), 2e-6);
    }
}

// Unfolded, a prism is a strip of the plane.
TEST(GeodesicPath, IsStraightOnAnUnfoldedPrism) {
    const uint32_t around = 12, up = 7;
    const Mesh mesh = make_mesh(cylinder(around, up));
    const double side = 2 * std::sin(pi / around);
    for (uint32_t i = 0; i < around / 2; ++i) {
        for (uint32_t j = 0; j <= up; ++j) {
            const Path path = find_path(mesh, at_vertex(mesh, 3), at_vertex(mesh, (3 + i) % around + around * j));
            EXPECT_TRUE(path.found);
            EXPECT_NEAR(path.length, std::hypot(i * side, 2.0 * j / up), 1e-6) << i << " " << j;
        }
    }
}

TEST(GeodesicPath, OnACubeIsThatOfItsNet) {
    const Mesh mesh = cube(6);
    const struct {
        Vec3 from, to;
        double length;
    } cases[] = {{{0, 0, 0}, {1, 1, 1}, std::sqrt(5)},
                 {{0.5, 0.5, 0}, {0.5, 0.5, 1}, 2},
                 {{0.5, 0.5, 0}, {1, 0.5, 0.5}, 1},
                 {{0.5, 0.5, 0}, {1, 1, 1}, std::hypot(0.5, 1.5)},
                 {{0, 0, 0}, {0, 0, 1}, 1}};
    for (const auto& [from, to, length] : cases) {
        const Path there = find_path(mesh, nearest_vertex(mesh, from), nearest_vertex(mesh, to));
        const Path back = find_path(mesh, nearest_vertex(mesh, to), nearest_vertex(mesh, from));
        EXPECT_NEAR(there.length, length, 1e-6);
        EXPECT_NEAR(back.length, length, 1e-6);
    }
}

// Around reflex corners of the border, of the mesh or of the regions alike.
TEST(GeodesicPath, TurnsAtReflexCornersOfBorders) {
    Mesh mesh = make_mesh(plane(20));
    Soup ell;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) ell.positions.push_back(mesh.positions[v]);
    std::vector<uint32_t> renamed(mesh.vertex_count(), no_index);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 centre = position_of(mesh, {t, 1 / 3.0f, 1 / 3.0f});
        const bool cut = centre.x() > 0.5 && centre.y() > 0.5;
        mesh.regions[t] = cut ? 9 : 4;
        if (!cut) ell.triangles.push_back(mesh.triangles[t]);
    }
    // Without the vertices that no triangle is left of.
    std::vector<Position> used;
    for (Triple& t : ell.triangles) {
        for (uint32_t& v : t) {
            if (renamed[v] == no_index) {
                renamed[v] = static_cast<uint32_t>(used.size());
                used.push_back(ell.positions[v]);
            }
            v = renamed[v];
        }
    }
    ell.positions = used;
    const Mesh l_shape = make_mesh(ell);
    const uint32_t label = 4;
    const RegionSet kept(&label, 1, test_memory());
    const Vec3 from(0.95, 0.2, 0), to(0.3, 0.9, 0), corner(0.5, 0.5, 0);
    const double expected = (from - corner).norm() + (to - corner).norm();
    EXPECT_NEAR(find_path(l_shape, nearest_vertex(l_shape, from), nearest_vertex(l_shape, to)).length, expected, 1e-6);
    Path restricted;
    {
        // The field, too, keeps to the regions.
        const SurfacePoint end = nearest_vertex(mesh, to);
        std::vector<float> distances(mesh.vertex_count(), std::numeric_limits<float>::infinity());
        const auto field = distances_to(l_shape, nearest_vertex(l_shape, to));
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            if (renamed[v] != no_index) distances[v] = field[renamed[v]];
        }
        const GeodesicPath path = add_path(mesh, nearest_vertex(mesh, from), end, distances, kept, restricted.curves);
        EXPECT_NEAR(path.length, expected, 1e-6);
        ASSERT_TRUE(end_polyline(restricted.curves, false, path.length));
        expect_valid(mesh, restricted.curves);
        for (const SurfacePoint& p : restricted.curves.points) EXPECT_EQ(mesh.regions[p.triangle], label);
    }
}

// No path on a polyhedron is shorter than the straight line; on a fine sphere near ones are arcs of great circles.
TEST(GeodesicPath, OnASphereIsAnArc) {
    const Mesh mesh = make_mesh(sphere(4));
    for (uint64_t seed = 0; seed < 40; ++seed) {
        const SurfacePoint from = random_point(mesh, 2 * seed), to = random_point(mesh, 2 * seed + 777);
        const double arc = angle(position_of(mesh, from), position_of(mesh, to));
        const Path there = find_path(mesh, from, to), back = find_path(mesh, to, from);
        EXPECT_TRUE(there.found && back.found);
        EXPECT_NEAR(there.length, arc, 0.01 * arc + 1e-3);
        EXPECT_NEAR(back.length, there.length, 0.01 * arc);
    }
}

// As solvers leave it that stop once the start has its distance: all that is further is infinite.
TEST(GeodesicPath, NeedsDistancesOnlyOnItsWay) {
    const Mesh mesh = make_mesh(plane(16, 0.2));
    for (uint64_t seed = 2; seed < 90; seed += 3) {
        const SurfacePoint from = random_point(mesh, seed), to = random_point(mesh, seed + 600);
        auto distances = distances_to(mesh, to);
        const float start = distances[mesh.triangles[from.triangle][2]];
        for (float& distance : distances) {
            if (distance > start) distance = std::numeric_limits<float>::infinity();
        }
        SurfaceCurves curves(test_memory());
        const RegionSet all(test_memory());
        const GeodesicPath path = add_path(mesh, from, to, distances, all, curves);
        EXPECT_TRUE(path.found);
        EXPECT_NEAR(path.length, (position_of(mesh, from) - position_of(mesh, to)).norm(), 2e-6);
    }
}

// Even where that is a single row of edges, with no finite triangle.
TEST(GeodesicPath, FollowsARowOfFiniteDistances) {
    const Mesh mesh = make_mesh(plane(6));
    std::vector<float> distances(mesh.vertex_count(), std::numeric_limits<float>::infinity());
    for (uint32_t i = 0; i <= 6; ++i) distances[3 * 7 + i] = float(i) / 6;
    SurfaceCurves curves(test_memory());
    const RegionSet all(test_memory());
    const GeodesicPath path =
        add_path(mesh, at_vertex(mesh, 3 * 7 + 6), at_vertex(mesh, 3 * 7), distances, all, curves);
    EXPECT_TRUE(path.found);
    EXPECT_NEAR(path.length, 1, 1e-6);
}

// Distances are a guess: misleading ones, and none at all, give a locally shortest path as well.
TEST(GeodesicPath, IsFoundWhateverTheFieldSays) {
    const RegionSet all(test_memory());
    uint64_t vertex = 0;
    const Mesh meshes[] = {
        make_mesh(plane(12, 0.2)), make_mesh(torus(24, 12)),
        make_mesh(grid(14, 14, [&](double x, double y) { return Vec3(x, y, 0.3 * random_unit(5, vertex++, 0)); }))};
    for (const Mesh& mesh : meshes) {
        std::vector<float> level(mesh.vertex_count(), 1), noise, unreachable(mesh.vertex_count(), HUGE_VALF);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) noise.push_back(float(random_unit(11, v, 0)));
        for (const std::vector<float>& distances : {std::vector<float>(), level, noise, unreachable}) {
            for (uint64_t seed = 0; seed < 30; ++seed) {
                const SurfacePoint from = random_point(mesh, seed), to = random_point(mesh, seed + 900);
                SurfaceCurves curves(test_memory());
                const GeodesicPath path = add_path(mesh, from, to, distances, all, curves);
                ASSERT_TRUE(path.found && path.is_straight);
                ASSERT_TRUE(end_polyline(curves, false, path.length));
                expect_valid(mesh, curves);
                expect_locally_shortest(mesh, curves, 0);
                EXPECT_NEAR(length_of(mesh, curves, 0), path.length, 1e-6 * (1 + path.length));
                const Vec3 straight = position_of(mesh, from) - position_of(mesh, to);
                EXPECT_GE(path.length, straight.norm() - 2e-6);
                if (&mesh != meshes) continue;
                EXPECT_NEAR(path.length, straight.norm(), 2e-6);
            }
        }
    }
}

// Triangles of other regions are no way, nor is a vertex that fans only touch at; another part of the mesh is none
// either.
TEST(GeodesicPath, WithoutAFieldKeepsToTheRegions) {
    Mesh mesh = make_mesh(plane(9));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 centre = position_of(mesh, {t, 1 / 3.0f, 1 / 3.0f});
        const bool wall = centre.x() > 0.44 && centre.x() < 0.56;
        mesh.regions[t] = wall ? centre.y() < 0.9 ? 2 : 3 : 1;
    }
    const SurfacePoint from = nearest_vertex(mesh, {0, 0, 0}), to = nearest_vertex(mesh, {1, 0, 0});
    const uint32_t labels[] = {1, 3};
    const RegionSet halves(labels, 1, test_memory()), gate(labels, 2, test_memory());
    SurfaceCurves curves(test_memory());
    EXPECT_FALSE(add_path(mesh, from, to, {}, halves, curves).found);
    EXPECT_EQ(curves.points.size(), 0u);
    const double top = 8.0 / 9, left = 4.0 / 9, right = 5.0 / 9;
    EXPECT_NEAR(add_path(mesh, from, to, {}, gate, curves).length,
                std::hypot(left, top) + (right - left) + std::hypot(1 - right, top), 1e-6);
}

// Saddles are where paths go through vertices: many locally shortest ones, and each test is in find_path().
TEST(GeodesicPath, IsLocallyShortestOnRoughGround) {
    for (double height : {0.02, 0.1, 0.4}) {
        uint64_t vertex = 0;
        const Mesh mesh = make_mesh(
            grid(14, 14, [&](double x, double y) { return Vec3(x, y, height * random_unit(5, vertex++, 0)); }));
        for (uint64_t seed = 0; seed < 60; ++seed) {
            const Path path = find_path(mesh, random_point(mesh, seed), random_point(mesh, seed + 500));
            EXPECT_TRUE(path.found);
        }
    }
    const Mesh ring = make_mesh(torus(24, 12));
    for (uint64_t seed = 0; seed < 60; ++seed)
        find_path(ring, random_point(ring, seed), random_point(ring, seed + 500));
}

TEST(GeodesicPath, TakesTrianglesWithoutArea) {
    // Collapsed edges and vertices in a row.
    for (uint64_t seed = 0; seed < 40; ++seed) {
        Soup soup = plane(8);
        for (Position& p : soup.positions) {
            for (float& x : p) x = std::round(x * float(3 + seed % 4)) / float(3 + seed % 4);
        }
        const Mesh mesh = make_mesh(soup);
        const SurfacePoint from = random_point(mesh, seed), to = random_point(mesh, seed + 500);
        const auto distances = distances_to(mesh, to);
        SurfaceCurves curves(test_memory());
        const RegionSet all(test_memory());
        const GeodesicPath path = add_path(mesh, from, to, distances, all, curves);
        end_polyline(curves, false, path.length);
        expect_valid(mesh, curves);
        EXPECT_TRUE(path.found);
        EXPECT_TRUE(std::isfinite(path.length));
        EXPECT_GE(path.length, (position_of(mesh, from) - position_of(mesh, to)).norm() - 1e-6);
    }
}

TEST(GeodesicPath, IsNoneBetweenComponents) {
    Soup soup = plane(3);
    const auto count = static_cast<uint32_t>(soup.positions.size());
    const Soup other = plane(3);
    for (const Position& p : other.positions) soup.positions.push_back({p[0], p[1], 1});
    for (const Triple& t : other.triangles) soup.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    const Mesh mesh = make_mesh(soup);
    const Path path = find_path(mesh, {2, 0.2f, 0.2f}, {25, 0.2f, 0.2f});
    EXPECT_FALSE(path.found);
    EXPECT_TRUE(path.curves.points.empty());
}

TEST(GeodesicPath, IsNoneFromOutsideOfTheRegions) {
    Mesh mesh = make_mesh(plane(8));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        mesh.regions[t] = mesh.position(mesh.triangles[t][0]).x() < 0.45 ? 1 : 2;
    }
    const uint32_t label = 2;
    const RegionSet right(&label, 1, test_memory());
    // Vertices in the midst of the left half, and of the right one.
    const SurfacePoint left = at_vertex(mesh, 4 * 9 + 2), beside = at_vertex(mesh, 5 * 9 + 2),
                       inside = at_vertex(mesh, 4 * 9 + 7);
    ASSERT_LT(position_of(mesh, left).x(), 0.3);
    ASSERT_GT(position_of(mesh, inside).x(), 0.7);
    for (const auto& [from, to] : {std::pair{left, beside}, std::pair{left, inside}, std::pair{inside, left}}) {
        const Path path = find_path(mesh, from, to, right);
        EXPECT_FALSE(path.found);
        EXPECT_TRUE(path.curves.points.empty());
    }
}

TEST(GeodesicPath, OfNoLengthIsNone) {
    const Mesh mesh = make_mesh(plane(3));
    // One vertex, seen from two triangles; and the same point inside of one.
    const SurfacePoint vertex = at_vertex(mesh, 5), inside{4, 0.2f, 0.3f};
    const Corner other = mesh.turn(mesh.corner_of_vertex[5]);
    const SurfacePoint again = point_on_edge(other, 0);
    for (const auto& [from, to] : {std::pair{vertex, again}, std::pair{inside, inside}}) {
        const Path path = find_path(mesh, from, to);
        EXPECT_TRUE(path.found);
        EXPECT_EQ(path.length, 0);
        EXPECT_EQ(path.curves.curve_count(), 0u);
        EXPECT_TRUE(path.curves.points.empty());
    }
    // Within one triangle.
    EXPECT_NEAR(find_path(mesh, inside, {4, 0.4f, 0.1f}).length, std::hypot(0.2, 0.2) / 3, 0.2);
}

TEST(GeodesicPath, PathsJoinToPolylines) {
    const Mesh mesh = make_mesh(plane(12, 0.2));
    const SurfacePoint corners[] = {
        nearest_vertex(mesh, {0.2, 0.2, 0}), nearest_vertex(mesh, {0.8, 0.3, 0}), {150, 0.3f, 0.3f}};
    for (bool closed : {false, true}) {
        SurfaceCurves curves(test_memory());
        const RegionSet all(test_memory());
        double length = 0, expected = 0;
        for (uint32_t i = 0; i < (closed ? 3 : 2); ++i) {
            const SurfacePoint& to = corners[(i + 1) % 3];
            const auto distances = distances_to(mesh, to);
            // A leg without length changes nothing.
            add_path(mesh, corners[i], corners[i], distances, all, curves);
            length += add_path(mesh, corners[i], to, distances, all, curves).length;
            expected += (position_of(mesh, corners[i]) - position_of(mesh, to)).norm();
        }
        ASSERT_TRUE(end_polyline(curves, closed, length));
        expect_valid(mesh, curves);
        EXPECT_EQ(curves.closed[0], closed);
        EXPECT_NEAR(length_of(mesh, curves, 0), expected, 1e-5);
        EXPECT_NEAR(curves.values[0], expected, 1e-5);
    }
}

TEST(GeodesicPath, DoesNotDependOnSlices) {
    uint64_t vertex = 0;
    const Mesh mesh =
        make_mesh(grid(20, 20, [&](double x, double y) { return Vec3(x, y, 0.1 * random_unit(5, vertex++, 0)); }));
    const RegionSet all(test_memory());
    for (uint64_t seed = 0; seed < 10; ++seed) {
        const SurfacePoint from = random_point(mesh, seed), to = random_point(mesh, seed + 500);
        const Path whole = find_path(mesh, from, to, all), sliced = find_path(mesh, from, to, all, true);
        expect_same(whole.curves, sliced.curves);
        EXPECT_EQ(whole.length, sliced.length);
    }
}

}  // namespace
}  // namespace flg::test
