// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/exact_solver.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "core/failure.h"
#include "reference/literal_geodesics.h"
#include "surfaces/exact_distances.h"
#include "surfaces/geodesic_jobs.h"
#include "surfaces/surface.h"

namespace flg::test {
namespace {

Soup both(Soup a, const Soup& b, const Vec3& shift) {
    const auto offset = static_cast<uint32_t>(a.positions.size());
    for (const Position& p : b.positions) a.positions.push_back(to_position(load_vec3(p.data()) + shift));
    for (const Triple& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

// The triangles that are kept, and their vertices.
template <class Keep>
Soup part_of(const Soup& whole, const Keep& keep, std::vector<uint32_t>* numbers = nullptr) {
    std::vector<uint32_t> number(whole.positions.size(), no_index);
    Soup part;
    for (uint32_t t = 0; t < whole.triangles.size(); ++t) {
        if (!keep(t)) continue;
        Triple& kept = part.triangles.emplace_back(whole.triangles[t]);
        for (uint32_t& vertex : kept) {
            if (number[vertex] == no_index) {
                number[vertex] = static_cast<uint32_t>(part.positions.size());
                part.positions.push_back(whole.positions[vertex]);
            }
            vertex = number[vertex];
        }
    }
    if (numbers) *numbers = number;
    return part;
}

Vec3 middle_of(const Soup& soup, uint32_t t) {
    Vec3 sum = Vec3::Zero();
    for (const uint32_t vertex : soup.triangles[t]) sum += load_vec3(soup.positions[vertex].data());
    return sum / 3;
}

// Vertices moved at random: bumps, saddles and slivers.
Soup rough(Soup soup, double size) {
    for (uint32_t v = 0; v < soup.positions.size(); ++v)
        for (uint32_t k = 0; k < 3; ++k)
            soup.positions[v][k] += static_cast<float>(size * (2 * random_unit(3, v, k) - 1));
    return soup;
}

// [0, 1]^2 with a square hole, not flat.
Soup with_hole() {
    const Soup whole = grid(20, 20, [](double x, double y) { return Vec3(x, y, 0.3 * std::sin(7 * x) * y); });
    return part_of(whole, [&](uint32_t t) {
        const Vec3 middle = middle_of(whole, t);
        return std::max(std::abs(middle.x() - 0.5), std::abs(middle.y() - 0.4)) > 0.2;
    });
}

struct Shape {
    const char* name;
    Soup soup;
};

std::vector<Shape> shapes() {
    return {{"sphere", sphere(3)},
            {"torus", torus(24, 12)},
            {"plane", plane(20, 0.3)},
            {"cylinder", cylinder(24, 9)},
            {"tetrahedron", tetrahedron()},
            {"hole", with_hole()},
            {"rough sphere", rough(sphere(3), 0.04)},
            {"rough plane", rough(plane(20), 0.02)},
            {"high sphere", stretched(sphere(3), {1, 20, 1})},
            {"flat sphere", stretched(sphere(3), {1, 1, 0.02})},
            {"high torus", stretched(torus(24, 12), {1, 20, 1})},
            {"long torus", stretched(torus(24, 12), {10, 1, 0.2})},
            {"slivers", stretched(plane(20, 0.4), {1, 200, 1})},
            {"two spheres", both(sphere(2), rough(sphere(2), 0.05), {3, 0, 0})}};
}

// Edges alone, by Dijkstra.
std::vector<double> along_edges(const Mesh& mesh, uint32_t source) {
    std::vector<double> distances(mesh.vertex_count(), std::numeric_limits<double>::infinity());
    distances[source] = 0;
    for (bool improves = true; improves;) {
        improves = false;
        for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
            const uint32_t a = mesh.vertex_at(corner), b = mesh.vertex_at(next_corner(corner));
            const double length = (mesh.position(a) - mesh.position(b)).norm();
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
                if (!(distances[from] + length < distances[to])) continue;
                distances[to] = distances[from] + length;
                improves = true;
            }
        }
    }
    return distances;
}

// Of the largest distance: both round.
TEST(ExactSolver, AgreesWithTheOracle) {
    for (const Shape& shape : shapes()) {
        const Mesh mesh = make_mesh(shape.soup);
        for (const uint32_t source : {0u, mesh.vertex_count() / 3, mesh.vertex_count() - 1}) {
            const std::vector<double> exact = literal::exact_distances(mesh, source);
            const std::vector<double> found = window_distances(mesh, source);
            for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
                if (exact[v] == unreachable) {
                    EXPECT_EQ(found[v], unreachable) << shape.name << ", " << source << " to " << v;
                } else {
                    EXPECT_NEAR(found[v], exact[v], 1e-12 * exact[v]) << shape.name << ", " << source << " to " << v;
                }
            }
        }
    }
}

// A flat grid that floats make rough: shadows of one in ten million behind all saddles.
TEST(ExactSolver, SeesThroughTheRoundingOfATiltedPlane) {
    const Mesh mesh = make_mesh(grid(
        48, 48, [](double x, double y) { return Vec3(0.7 * x + 0.1 * y, 0.9 * y - 0.3 * x, 0.37 * x + 0.21 * y); }));
    for (const uint32_t source : {0u, 5u, 24u * 49 + 24}) {
        const std::vector<double> found = window_distances(mesh, source);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            const double straight = (mesh.position(v) - mesh.position(source)).norm();
            EXPECT_GE(found[v], straight * (1 - 1e-12)) << source << " to " << v;
            EXPECT_LE(found[v], straight * (1 + 1e-9)) << source << " to " << v;
        }
    }
}

TEST(ExactSolver, IsSymmetricAndKeepsTheTriangleInequality) {
    for (const Soup& soup : {rough(torus(40, 20), 0.06), with_hole(), stretched(sphere(3), {1, 20, 1})}) {
        const Mesh mesh = make_mesh(soup);
        const uint32_t a = 3, b = mesh.vertex_count() / 2, c = mesh.vertex_count() - 2;
        const auto from_a = window_distances(mesh, a), from_b = window_distances(mesh, b),
                   from_c = window_distances(mesh, c);
        EXPECT_NEAR(from_a[b], from_b[a], 1e-12 * from_a[b]);
        EXPECT_NEAR(from_a[c], from_c[a], 1e-12 * from_a[c]);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            EXPECT_LE(from_a[v], from_a[b] + from_b[v] + 1e-12);
            EXPECT_LE(from_b[v], from_b[c] + from_c[v] + 1e-12);
        }
    }
}

TEST(ExactSolver, LabelsTheNearestOfManySources) {
    for (const Shape& shape : shapes()) {
        const Mesh mesh = make_mesh(shape.soup);
        const std::vector<uint32_t> sources = {mesh.vertex_count() - 1, 1, mesh.vertex_count() / 2, 1};
        const ExactField together = exact_field(mesh, [&](ExactSources& to) {
            for (uint32_t i = 0; i < sources.size(); ++i) to.add_vertex(sources[i], i);
        });
        std::vector<std::vector<double>> alone;
        for (const uint32_t source : sources) alone.push_back(window_distances(mesh, source));
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            double nearest = unreachable;
            for (const auto& distances : alone) nearest = std::min(nearest, distances[v]);
            ASSERT_EQ(nearest == unreachable, together.labels[v] == no_index) << shape.name << ", " << v;
            if (nearest == unreachable) continue;
            EXPECT_NEAR(together.distances[v], nearest, 1e-12 * nearest) << shape.name << ", " << v;
            EXPECT_NEAR(alone[together.labels[v]][v], nearest, 1e-12 * nearest) << shape.name << ", " << v;
            EXPECT_NE(together.labels[v], 3u) << "the first of two that are one";
        }
    }
}

// A point within a triangle, on an edge, at a corner: as if the triangles there were split so that it is a vertex.
TEST(ExactSolver, StartsAtPointsAsAtVertices) {
    // Positions of few bits, so that a quarter of the way has a float.
    Soup soup = rough(sphere(3), 0.05);
    for (Position& p : soup.positions)
        for (float& x : p) x = std::round(x * 256) / 256;
    const Mesh mesh = make_mesh(soup);
    for (const uint32_t t : {0u, 77u, 500u, 1111u}) {
        const Triple corners = soup.triangles[t];
        const auto place = [&](float u, float v) {
            return to_position(position_of(mesh, {.triangle = t, .u = u, .v = v}));
        };
        const auto added = static_cast<uint32_t>(soup.positions.size());
        Soup split = soup;
        split.positions.push_back(place(0.25f, 0.5f));
        split.triangles[t] = {corners[0], corners[1], added};
        split.triangles.push_back({corners[1], corners[2], added});
        split.triangles.push_back({corners[2], corners[0], added});
        Soup on_edge = soup;
        on_edge.positions.push_back(place(0.25f, 0));
        const uint32_t other = mesh.neighbours[t][0];
        on_edge.triangles[t] = {corners[0], added, corners[2]};
        on_edge.triangles.push_back({added, corners[1], corners[2]});
        const Corner across = mesh.opposite(3 * t);
        const uint32_t top = mesh.vertex_at(previous_corner(across));
        on_edge.triangles[other] = {corners[1], added, top};
        on_edge.triangles.push_back({added, corners[0], top});
        const auto expect = [&](const SurfacePoint& point, const Soup& with_vertex, uint32_t vertex) {
            const auto found = exact_field(mesh, [&](ExactSources& to) { to.add_point(point, 0); }).distances;
            const auto expected = window_distances(make_mesh(with_vertex), vertex);
            for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
                EXPECT_NEAR(found[v], expected[v], 1e-12 * expected[v]) << t << " to " << v;
            }
        };
        expect({t, 0.25f, 0.5f}, split, added);
        expect({t, 0.25f, 0}, on_edge, added);
        expect({t, 1, 0}, soup, corners[1]);
        expect({t, 0, 1}, soup, corners[2]);
    }
}

// Sources inside of triangles stand in each other's light.
TEST(ExactSolver, KeepsManyPointsApart) {
    for (const Soup& soup : {plane(12, 0.3), rough(torus(20, 10), 0.05), sphere(2)}) {
        const Mesh mesh = make_mesh(soup);
        for (uint64_t seed = 0; seed < 10; ++seed) {
            std::vector<SurfacePoint> points;
            for (uint32_t i = 0; i < 12; ++i) {
                const auto u = static_cast<float>(random_unit(seed, i, 0));
                points.push_back({random_below(seed, i, 1, mesh.triangle_count()), u,
                                  (1 - u) * static_cast<float>(random_unit(seed, i, 2))});
            }
            const ExactField together = exact_field(mesh, [&](ExactSources& to) {
                for (uint32_t i = 0; i < points.size(); ++i) to.add_point(points[i], i);
            });
            std::vector<double> nearest(mesh.vertex_count(), unreachable);
            std::vector<std::vector<double>> alone;
            for (const SurfacePoint& point : points) {
                alone.push_back(exact_field(mesh, [&](ExactSources& to) { to.add_point(point, 0); }).distances);
                for (uint32_t v = 0; v < nearest.size(); ++v) nearest[v] = std::min(nearest[v], alone.back()[v]);
            }
            for (uint32_t v = 0; v < nearest.size(); ++v) {
                EXPECT_NEAR(together.distances[v], nearest[v], 1e-12) << seed << ", " << v;
                EXPECT_NEAR(alone[together.labels[v]][v], nearest[v], 1e-12) << seed << ", " << v;
            }
        }
    }
}

double to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double t = (p - a).dot(b - a) / (b - a).squaredNorm();
    return (p - a - std::clamp(t, 0.0, 1.0) * (b - a)).norm();
}

// A polyline across the plane, given by where it meets edges.
TEST(ExactSolver, MeasuresFromCurvesInThePlane) {
    const Mesh mesh = make_mesh(plane(15, 0.3));
    std::vector<std::pair<SurfacePoint, SurfacePoint>> segments;
    const Vec3 begin(0.21, 0.13, 0), end(0.83, 0.67, 0);
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        std::vector<SurfacePoint> crossings;
        for (Corner corner = 3 * t; corner < 3 * t + 3; ++corner) {
            const Vec3 a = mesh.position(mesh.vertex_at(corner)),
                       b = mesh.position(mesh.vertex_at(next_corner(corner)));
            const Vec3 along = end - begin, normal(-along.y(), along.x(), 0);
            const double at_a = normal.dot(a - begin), at_b = normal.dot(b - begin);
            if ((at_a < 0) == (at_b < 0)) continue;
            const Vec3 place = a + at_a / (at_a - at_b) * (b - a);
            if ((place - begin).dot(along) < 0 || (place - end).dot(along) > 0) continue;
            crossings.push_back(point_on_edge(corner, round_on_edge(at_a / (at_a - at_b))));
        }
        if (crossings.size() == 2) segments.emplace_back(crossings[0], crossings[1]);
    }
    ASSERT_GT(segments.size(), 15u);
    const ExactField found = exact_field(mesh, [&](ExactSources& to) {
        for (const auto& [from, end_point] : segments) to.add_segment(from, end_point, 0);
    });
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        double nearest = unreachable;
        for (const auto& [from, end_point] : segments) {
            nearest =
                std::min(nearest, to_segment(mesh.position(v), position_of(mesh, from), position_of(mesh, end_point)));
        }
        EXPECT_NEAR(found.distances[v], nearest, 1e-12) << v;
    }
}

TEST(ExactSolver, MeasuresFromTheBorderOfAPlane) {
    const Mesh mesh = make_mesh(plane(17, 0.3));
    const RegionSet all(test_memory());
    const ExactField found =
        exact_field_by(mesh, all, {}, [&](Pace& pace, ExactSources& to) { return add_border(pace, mesh, all, 7, to); });
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = mesh.position(v);
        EXPECT_NEAR(found.distances[v], std::min({p.x(), p.y(), 1 - p.x(), 1 - p.y()}), 1e-12);
        EXPECT_EQ(found.labels[v], 7u);
    }
}

// Segments in a triangle, to its corners and edges too, against points along them: the nearest of these is at most half
// a gap from a foot.
TEST(ExactSolver, MeasuresFromSegmentsAsFromDensePoints) {
    const Mesh mesh = make_mesh(rough(sphere(2), 0.1));
    constexpr uint32_t parts = 128;
    const std::array<std::array<float, 4>, 5> segments = {
        {{0.3f, 0.2f, 0, 1}, {0.3f, 0, 0, 0}, {0.3f, 0.7f, 0, 0.6f}, {0.1f, 0.2f, 0.5f, 0.3f}, {1, 0, 0, 1}}};
    for (uint32_t t = 0; t < mesh.triangle_count(); t += 7) {
        const auto& [u, v, to_u, to_v] = segments[t % segments.size()];
        const SurfacePoint begin{t, u, v}, end{t, to_u, to_v};
        const ExactField line = exact_field(mesh, [&](ExactSources& to) { to.add_segment(begin, end, 0); });
        const ExactField points = exact_field(mesh, [&](ExactSources& to) {
            for (uint32_t p = 0; p <= parts; ++p) {
                const float at = static_cast<float>(p) / parts;
                to.add_point({t, u + (to_u - u) * at, v + (to_v - v) * at}, 0);
            }
        });
        const double gap = (position_of(mesh, end) - position_of(mesh, begin)).norm() / parts;
        for (uint32_t w = 0; w < mesh.vertex_count(); ++w) {
            EXPECT_LE(line.distances[w], points.distances[w] + 1e-6) << t << " to " << w;
            EXPECT_GE(line.distances[w], points.distances[w] - gap / 2 - 1e-6) << t << " to " << w;
        }
    }
}

// A closed curve along edges of a bumpy surface.
TEST(ExactSolver, MeasuresFromLinesAsFromDensePoints) {
    const Mesh mesh = make_mesh(rough(torus(30, 15), 0.04));
    SurfaceCurves curves(test_memory());
    for (uint32_t i = 0; i < 30; ++i) {
        // Around the torus: from ring to ring, at vertex 15 i + 4.
        for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
            if (mesh.vertex_at(corner) != 15 * i + 4 || mesh.vertex_at(next_corner(corner)) != (15 * (i + 1)) % 450 + 4)
                continue;
            curves.points.push_back(point_on_edge(corner, 0));
        }
    }
    ASSERT_EQ(curves.points.size(), 30u);
    curves.offsets.push_back(30);
    curves.closed.push_back(true);
    const RegionSet all(test_memory());
    const ExactField line =
        exact_field_by(mesh, all, {}, [&](Pace& pace, ExactSources& to) { return add_curve(pace, curves, 0, 0, to); });
    constexpr uint32_t parts = 64;
    double longest = 0;
    const ExactField points = exact_field(mesh, [&](ExactSources& to) {
        for (uint32_t i = 0; i < 30; ++i) {
            const SurfacePoint at = curves.points[i];
            const Corner corner = 3 * at.triangle + (at.u == 1 ? 1 : at.v == 1 ? 2 : 0);
            longest = std::max(
                longest,
                (mesh.position(mesh.vertex_at(corner)) - mesh.position(mesh.vertex_at(next_corner(corner)))).norm());
            for (uint32_t p = 0; p < parts; ++p) to.add_point(point_on_edge(corner, static_cast<float>(p) / parts), 0);
        }
    });
    const double gap = longest / parts;
    double furthest = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        EXPECT_LE(line.distances[v], points.distances[v] + 1e-12) << v;
        EXPECT_GE(line.distances[v], points.distances[v] - gap / 2) << v;
        furthest = std::max(furthest, line.distances[v]);
    }
    EXPECT_GT(furthest, 1);
}

TEST(ExactSolver, DoesNotDependOnTheOrderOfTriangles) {
    for (const Shape& shape : shapes()) {
        const Mesh mesh = make_mesh(shape.soup);
        std::mt19937 random(5);
        Soup mixed = shape.soup;
        for (uint32_t t = static_cast<uint32_t>(mixed.triangles.size()) - 1; t > 0; --t)
            std::swap(mixed.triangles[t], mixed.triangles[random() % (t + 1)]);
        for (Triple& t : mixed.triangles) std::rotate(t.begin(), t.begin() + random() % 3, t.end());
        const auto found = window_distances(make_mesh(mixed), 2), expected = window_distances(mesh, 2);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            if (expected[v] == unreachable) continue;
            EXPECT_NEAR(found[v], expected[v], 1e-12 * expected[v]) << shape.name << ", " << v;
        }
    }
}

// A power of two times as large: all bits of the mantissas are the same.
TEST(ExactSolver, ScalesWithTheMesh) {
    for (const double size : {0x1p-60, 0x1p50}) {
        const Soup soup = rough(torus(24, 12), 0.05);
        const auto large = window_distances(make_mesh(stretched(soup, Vec3::Constant(size))), 9);
        const auto small = window_distances(make_mesh(soup), 9);
        for (uint32_t v = 0; v < small.size(); ++v) EXPECT_EQ(large[v], small[v] * size);
    }
}

TEST(ExactSolver, DoesNotDependOnSlices) {
    for (const Shape& shape : shapes()) {
        const Mesh mesh = make_mesh(shape.soup);
        const auto add = [](ExactSources& to) {
            to.add_vertex(2, 0);
            to.add_point({1, 0.25f, 0.5f}, 1);
            to.add_edge(4, 2);
        };
        const ExactField at_once = exact_field(mesh, add), haltingly = exact_field(mesh, add, {}, true);
        EXPECT_EQ(at_once.distances, haltingly.distances) << shape.name;
        EXPECT_EQ(at_once.labels, haltingly.labels) << shape.name;
    }
}

TEST(ExactSolver, StopsAtTheLimitAndAtTargets) {
    const Mesh mesh = make_mesh(rough(torus(60, 30), 0.02));
    const auto add = [](ExactSources& to) { to.add_vertex(11, 0); };
    const ExactField whole = exact_field(mesh, add);
    const ExactField near = exact_field(mesh, add, {.distance = 0.9f, .targets = {}});
    uint32_t beyond = 0;
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const float distance = whole.field.distances[v];
        EXPECT_EQ(near.field.distances[v], distance <= 0.9f ? distance : unreachable);
        EXPECT_EQ(near.field.labels[v], distance <= 0.9f ? 0u : no_index);
        beyond += distance > 0.9f;
    }
    EXPECT_GT(beyond, mesh.vertex_count() / 2);
    SolveLimits to_targets;
    to_targets.targets = {100, 15, 11};
    const ExactField until = exact_field(mesh, add, to_targets);
    for (const uint32_t target : to_targets.targets) EXPECT_EQ(until.distances[target], whole.distances[target]);
    uint32_t left = 0;
    for (const double distance : until.distances) left += distance == unreachable;
    EXPECT_GT(left, mesh.vertex_count() / 4);
}

// The same as on a surface that ends where the regions do.
TEST(ExactSolver, StaysWithinRegions) {
    const Soup soup =
        grid(30, 30, [](double x, double y) { return Vec3(x, y, 0.2 * std::sin(9 * x) * std::cos(8 * y)); });
    for (uint64_t seed = 0; seed < 10; ++seed) {
        Mesh mesh = make_mesh(soup);
        const auto is_inside = [&](uint32_t t) {
            const Vec3 middle = middle_of(soup, t);
            // A skyline: no two of its corners touch.
            return static_cast<uint32_t>(10 * middle.y()) <=
                   random_below(seed, static_cast<uint64_t>(10 * middle.x()), 0, 10);
        };
        for (uint32_t t = 0; t < mesh.triangle_count(); ++t) mesh.regions[t] = is_inside(t) ? 4 : 0;
        std::vector<uint32_t> numbers;
        const Mesh cut = make_mesh(part_of(soup, is_inside, &numbers));
        const uint32_t label = 4;
        const RegionSet within(&label, 1, test_memory());
        const ExactField found = exact_field_by(mesh, within, {}, [&](Pace& pace, ExactSources& to) {
            return each(pace, 1, Cost::microseconds, [&](uint32_t) { to.add_vertex(3, 0); });
        });
        const auto expected = window_distances(cut, numbers[3]);
        for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
            if (numbers[v] == no_index || expected[numbers[v]] == unreachable) {
                EXPECT_EQ(found.distances[v], unreachable) << v;
            } else {
                EXPECT_NEAR(found.distances[v], expected[numbers[v]], 1e-12) << v;
            }
        }
    }
}

// Two parts of a region that touch at a vertex alone: the way leads through it.
TEST(ExactSolver, PassesVerticesWhereRegionsTouch) {
    Mesh mesh = make_mesh(plane(10));
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 a = mesh.position(mesh.triangles[t][0]), b = mesh.position(mesh.triangles[t][1]),
                   c = mesh.position(mesh.triangles[t][2]), middle = (a + b + c) / 3;
        mesh.regions[t] = (middle.x() < 0.5) == (middle.y() < 0.5) ? 1 : 0;
    }
    const uint32_t label = 1;
    const RegionSet within(&label, 1, test_memory());
    const ExactField found = exact_field_by(mesh, within, {}, [&](Pace& pace, ExactSources& to) {
        return each(pace, 1, Cost::microseconds, [&](uint32_t) { to.add_vertex(1, 0); });
    });
    const Vec3 source = mesh.position(1), pass(0.5, 0.5, 0);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const Vec3 p = mesh.position(v);
        if (!(p.x() > 0.51 && p.y() > 0.51)) continue;
        EXPECT_NEAR(found.distances[v], (source - pass).norm() + (pass - p).norm(), 1e-6) << v;
    }
}

// Vertices pulled onto each other, onto edges, and far out: edges without length, spikes without area.
Soup pulled(Soup soup, uint64_t seed, uint32_t moves) {
    for (uint32_t i = 0; i < moves; ++i) {
        const Triple& corners = soup.triangles[random_below(seed, i, 0, static_cast<uint32_t>(soup.triangles.size()))];
        const Vec3 a = load_vec3(soup.positions[corners[0]].data()), b = load_vec3(soup.positions[corners[1]].data());
        const double at = std::array{0.0, 0.5, 1.0, 20.0, 1e-7, -1.0}[random_below(seed, i, 1, 6)];
        soup.positions[corners[2]] = to_position(a + at * (b - a));
    }
    return soup;
}

// All together are as far as the nearest of them, also where triangles have no area.
TEST(ExactSolver, KeepsSourcesOnUglyTrianglesApart) {
    for (uint64_t seed = 0; seed < 60; ++seed) {
        const Mesh mesh = make_mesh(pulled(seed % 2 == 0 ? plane(12, 0.4) : sphere(2), seed, 30));
        constexpr uint32_t sources = 9;
        const auto add = [&](ExactSources& to, uint32_t i) {
            const uint32_t t = random_below(seed, i, 7, mesh.triangle_count());
            if (i % 3 == 0) to.add_point({t, 0.3f, 0.2f}, i);
            if (i % 3 == 1) to.add_segment({t, 0.3f, 0.2f}, {t, 0, 1}, i);
            if (i % 3 == 2) to.add_edge(3 * t + 1, i);
        };
        const ExactField together = exact_field(mesh, [&](ExactSources& to) {
            for (uint32_t i = 0; i < sources; ++i) add(to, i);
        });
        std::vector<double> nearest(mesh.vertex_count(), unreachable);
        for (uint32_t i = 0; i < sources; ++i) {
            const ExactField alone = exact_field(mesh, [&](ExactSources& to) { add(to, i); });
            for (uint32_t v = 0; v < nearest.size(); ++v) nearest[v] = std::min(nearest[v], alone.distances[v]);
        }
        for (uint32_t v = 0; v < nearest.size(); ++v) {
            EXPECT_NEAR(together.distances[v], nearest[v], 1e-9) << seed << ", " << v;
        }
    }
}

// Neither shorter than the straight line nor longer than along edges, whatever the triangles.
TEST(ExactSolver, TakesUglyTriangles) {
    std::vector<Shape> ugly;
    // A cone of many slivers, one of its triangles without area, and two vertices in one place.
    Soup cone;
    const uint32_t around = 1000;
    cone.positions.push_back({0, 0, 1});
    for (uint32_t i = 0; i < around; ++i) {
        const double angle = 2 * std::numbers::pi * (i == 1 ? 0 : i) / around;
        cone.positions.push_back(to_position({std::cos(angle), std::sin(angle), 0}));
        cone.triangles.push_back({0, 1 + i, 1 + (i + 1) % around});
    }
    ugly.push_back({"cone", cone});
    ugly.push_back({"needle", stretched(cone, {1e-5, 1e-5, 1})});
    Soup flat = plane(8);
    for (Position& p : flat.positions) p = {p[0], 0, 0};
    ugly.push_back({"line", flat});
    for (Position& p : flat.positions) p = {};
    ugly.push_back({"place", flat});
    for (uint64_t seed = 0; seed < 40; ++seed)
        ugly.push_back({"pulled", pulled(seed % 2 == 0 ? plane(9, 0.2) : sphere(2), seed, 25)});
    constexpr double rounding = 1e-15;  // of places some metres away; vertices may be 1e-8 apart
    for (const Shape& shape : ugly) {
        const Mesh mesh = make_mesh(shape.soup);
        for (const uint32_t source : {0u, mesh.vertex_count() / 2}) {
            const auto found = window_distances(mesh, source), longest = along_edges(mesh, source);
            for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
                const double straight = (mesh.position(v) - mesh.position(source)).norm();
                EXPECT_GE(found[v], straight * (1 - 1e-9) - rounding) << shape.name << ", " << source << " to " << v;
                EXPECT_LE(found[v], longest[v] * (1 + 1e-12)) << shape.name << ", " << source << " to " << v;
            }
        }
        // Points and lines inside.
        const ExactField field = exact_field(mesh, [&](ExactSources& to) {
            to.add_point({3, 0.3f, 0.3f}, 0);
            to.add_segment({9, 0.1f, 0.2f}, {9, 0.5f, 0.4f}, 1);
            to.add_edge(40, 2);
        });
        for (const double distance : field.distances) EXPECT_TRUE(std::isfinite(distance)) << shape.name;
    }
}

GeodesicRequest request_of(const Soup& soup, uint32_t source) {
    auto surface = std::make_shared<Surface>(test_memory(), test_memory());
    surface->mesh() = make_mesh(soup);
    GeodesicSources sources;
    sources.vertices = Buffer<uint32_t>(1, test_memory());
    sources.vertices[0] = source;
    return {.surface = surface,
            .sources = std::move(sources),
            .regions = RegionSet(test_memory()),
            .max_distance = unreachable,
            .targets = {},
            .labelled = true,
            .perturbation = {},
            .exact = true};
}

TEST(ExactFields, AreTheSolversInFloats) {
    const Soup soup = rough(torus(24, 12), 0.05);
    const GeodesicRequest request = request_of(soup, 7);
    DistanceField field;
    run_haltingly(test_memory(), [&](Pace& pace) { return solve_field(pace, request, field); });
    const auto expected = window_distances(make_mesh(soup), 7);
    for (uint32_t v = 0; v < expected.size(); ++v) {
        EXPECT_FLOAT_EQ(field.distances[v], static_cast<float>(expected[v]));
        EXPECT_EQ(field.labels[v], 0u);
    }
}

TEST(ExactFields, AreNotPerturbed) {
    GeodesicRequest request = request_of(sphere(1), 7);
    request.perturbation.amount = 0.5f;
    DistanceField field;
    try {
        run_now(test_memory(), [&](Pace& pace) { return solve_field(pace, request, field); });
        FAIL();
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.result(), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_STREQ(failure.what(), "accuracy is exact, perturbation is 0.5 and must be 0");
    }
}

}  // namespace
}  // namespace flg::test
