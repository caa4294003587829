// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/offset_lines.h"

#include <gtest/gtest.h>

#include "surfaces/exact_distances.h"
#include "surfaces/tracing/surface_walk.h"

namespace flg::test {
namespace {

using Height = std::function<double(double, double)>;

// Over [0, 1]^2.
Soup ground(uint32_t cells, const Height& height) {
    return grid(
        cells, cells, [&](double x, double y) { return Vec3(x, y, height(x, y)); }, false, true);
}

double dents(double x, double y) {
    double z = 0;
    for (const auto& [u, v, depth] : {std::array{0.35, 0.62, -0.2}, std::array{0.62, 0.6, -0.15},
                                      std::array{0.5, 0.35, 0.18}, std::array{0.8, 0.72, 0.1}})
        z += depth * std::exp(-((x - u) * (x - u) + (y - v) * (y - v)) / 0.008);
    return z;
}

SurfacePoint point_above(const Mesh& mesh, double x, double y) {
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 a = mesh.position(mesh.triangles[t][0]), b = mesh.position(mesh.triangles[t][1]) - a,
                   c = mesh.position(mesh.triangles[t][2]) - a;
        const double area = b.x() * c.y() - b.y() * c.x(), u = ((x - a.x()) * c.y() - (y - a.y()) * c.x()) / area,
                     v = (b.x() * (y - a.y()) - b.y() * (x - a.x())) / area;
        if (u >= 0 && v >= 0 && u + v <= 1) return {t, static_cast<float>(u), static_cast<float>(v)};
    }
    ADD_FAILURE() << x << " " << y;
    return {0, 0, 0};
}

using Plan = std::vector<std::array<double, 2>>;

Task<void> walk(Pace& pace, const Mesh& mesh, SurfacePoint from, SurfacePoint to, SurfaceCurves& out) {
    const SurfaceWalk found = co_await add_surface_walk(pace, mesh, from, to, out);
    EXPECT_TRUE(found.found);
}

// Over the ground, straight from each of them to the next as seen from above, or nearly.
SurfaceCurves curve_over(const Mesh& mesh, const Plan& plan, bool closed) {
    SurfaceCurves out(test_memory());
    const size_t count = plan.size() - (closed ? 0 : 1);
    for (size_t i = 0; i < count; ++i) {
        const auto &from = plan[i], &to = plan[(i + 1) % plan.size()];
        const SurfacePoint begin = point_above(mesh, from[0], from[1]), end = point_above(mesh, to[0], to[1]);
        run_now(test_memory(), [&](Pace& pace) { return walk(pace, mesh, begin, end, out); });
    }
    if (closed) out.points.pop_back();
    out.offsets.push_back(static_cast<uint32_t>(out.points.size()));
    out.closed.push_back(closed);
    out.values.push_back(0);
    return out;
}

struct Lines {
    SurfaceCurves curves{test_memory()};
    std::pmr::deque<uint32_t> pieces{test_memory()};
};

Lines lines_beside(const Mesh& mesh, const SurfaceCurves& curve, double offset, bool haltingly = false) {
    Lines out;
    run_now(
        test_memory(), [&](Pace& pace) { return add_offset_lines(pace, mesh, curve, offset, out.curves, out.pieces); },
        haltingly);
    EXPECT_EQ(out.pieces.size(), out.curves.points.size());
    return out;
}

// Calls each(triangle, weights of the stretch's begin, of its end).
template <class Each>
void for_stretches(const Mesh& mesh, const SurfaceCurves& curves, const Each& each_stretch) {
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
        const uint32_t first = curves.offsets[c], end = curves.offsets[c + 1];
        for (uint32_t i = first; i < (curves.closed[c] ? end : end - 1); ++i)
            each_stretch(curves.points[i], position_of(mesh, curves.points[i]),
                         position_of(mesh, curves.points[i + 1 == end ? first : i + 1]));
    }
}

Plan bent_plan(double bend) {
    Plan plan;
    for (int i = 0; i <= 40; ++i) plan.push_back({0.151 + 0.7 * i / 40, 0.503 + bend * std::sin(9.0 * i / 40)});
    return plan;
}

// The middles of stretches become vertices, whose distances are had from the curve by the solver alone.
void expect_at_distance(const Soup& soup, const Mesh& mesh, const SurfaceCurves& curve, const SurfaceCurves& lines,
                        double away) {
    std::vector<bool> is_taken(mesh.triangle_count(), false);
    for (const SurfacePoint& point : curve.points) is_taken[point.triangle] = true;
    Soup split = soup;
    for_stretches(mesh, lines, [&](const SurfacePoint& at, const Vec3& a, const Vec3& b) {
        if (is_taken[at.triangle]) return;
        is_taken[at.triangle] = true;
        const auto added = static_cast<uint32_t>(split.positions.size());
        split.positions.push_back(to_position(0.5 * (a + b)));
        const Triple t = split.triangles[at.triangle];
        split.triangles[at.triangle] = {t[0], t[1], added};
        split.triangles.push_back({t[1], t[2], added});
        split.triangles.push_back({t[2], t[0], added});
    });
    EXPECT_GT(split.positions.size(), soup.positions.size() + 50);
    const ExactField field =
        exact_field_by(make_mesh(split), RegionSet(test_memory()), {},
                       [&](Pace& pace, ExactSources& sources) { return add_curve(pace, curve, 0, 0, sources); });
    for (size_t v = soup.positions.size(); v < split.positions.size(); ++v)
        EXPECT_NEAR(field.distances[v], away, 1.1 * offset_tolerance * away) << v;
}

void expect_simple(const Mesh& mesh, const SurfaceCurves& lines) {
    std::vector<std::vector<std::array<Vec3, 2>>> within(mesh.triangle_count());
    for_stretches(mesh, lines, [&](const SurfacePoint& at, const Vec3& a, const Vec3& b) {
        const auto side = [](const Vec3& p, const Vec3& q, const Vec3& r) {
            return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
        };
        for (const auto& [c, d] : within[at.triangle])
            EXPECT_FALSE(side(a, b, c) * side(a, b, d) < -1e-18 && side(c, d, a) * side(c, d, b) < -1e-18);
        within[at.triangle].push_back({a, b});
    });
}

TEST(OffsetLines, OverDentsAndBumpsAreSoFarAwayAndSimple) {
    const Soup soup = ground(60, dents);
    const Mesh mesh = make_mesh(soup);
    for (const double bend : {0.0, 0.12}) {
        const SurfaceCurves curve = curve_over(mesh, bent_plan(bend), false);
        for (const double offset : {0.03, -0.03, 0.09, -0.09, 0.17, -0.17}) {
            const Lines lines = lines_beside(mesh, curve, offset);
            ASSERT_GE(lines.curves.curve_count(), 1u) << offset;
            expect_at_distance(soup, mesh, curve, lines.curves, std::abs(offset));
            expect_simple(mesh, lines.curves);
        }
    }
}

// Triangles much larger and much smaller than the distance: in the plane it is known. Left of the curve above.
TEST(OffsetLines, OfThePlaneAreThoseOfThePlane) {
    for (const uint32_t cells : {3u, 7u, 80u}) {
        const Mesh mesh = make_mesh(ground(cells, [](double, double) { return 0.0; }));
        const Plan plan = bent_plan(0.1);
        const SurfaceCurves curve = curve_over(mesh, plan, false);
        const auto distance_to = [&](const Vec3& x) {
            double nearest = 1e9;
            for_stretches(mesh, curve, [&](const SurfacePoint&, const Vec3& a, const Vec3& b) {
                const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (x - a - t * (b - a)).norm());
            });
            return nearest;
        };
        for (const double offset : {0.05, -0.15}) {
            const Lines lines = lines_beside(mesh, curve, offset);
            ASSERT_EQ(lines.curves.curve_count(), 1u);
            EXPECT_FALSE(lines.curves.closed[0]);
            const double away = std::abs(offset);
            for_stretches(mesh, lines.curves, [&](const SurfacePoint&, const Vec3& a, const Vec3& b) {
                EXPECT_NEAR(distance_to(a), away, 1e-5 * away);
                EXPECT_NEAR(distance_to(0.5 * (a + b)), away, 1.1 * offset_tolerance * away);
            });
            // It begins and ends beside the curve's ends.
            const auto beside_end = [&](const std::array<double, 2>& end, const std::array<double, 2>& next,
                                        double sign, const SurfacePoint& point) {
                const Vec3 way = sign * Vec3(next[0] - end[0], next[1] - end[1], 0).normalized();
                const Vec3 left = Vec3(end[0], end[1], 0) + offset * Vec3(-way.y(), way.x(), 0);
                if (distance_to(left) < (1 - 1e-6) * away) return;  // cut off
                EXPECT_LT((position_of(mesh, point) - left).norm(), 2e-3 * away) << cells << " " << offset;
            };
            beside_end(plan[0], plan[1], 1, lines.curves.points.front());
            beside_end(plan[40], plan[39], -1, lines.curves.points.back());
            for (size_t i = 1; i < lines.pieces.size(); ++i) EXPECT_GE(lines.pieces[i] + 1, lines.pieces[i - 1]);
        }
    }
}

// Where the curve leads through vertices and along edges each side is still its own.
TEST(OffsetLines, AlongEdgesAreStraight) {
    const Mesh mesh = make_mesh(ground(8, [](double, double) { return 0.0; }));
    const SurfaceCurves curve = curve_over(mesh, {{0.25, 0.5}, {0.5, 0.5}, {0.75, 0.5}}, false);
    for (const double offset : {0.1, -0.1, 0.3}) {
        const Lines lines = lines_beside(mesh, curve, offset);
        ASSERT_EQ(lines.curves.curve_count(), 1u);
        EXPECT_NEAR(lines.curves.values[0], 0.5, 1e-6);
        for (const SurfacePoint& point : lines.curves.points)
            EXPECT_NEAR(position_of(mesh, point).y(), 0.5 + offset, 1e-6);
        EXPECT_LT(position_of(mesh, lines.curves.points.front()).x(), 0.26);
    }
}

// ---- along edges ----

// From vertex to vertex along edges, in the triangles to the left of them where there are any, or to the right.
SurfaceCurves curve_along(const Mesh& mesh, const std::vector<uint32_t>& vertices, bool closed, bool left) {
    SurfaceCurves out(test_memory());
    const auto place_at = [&](Corner corner) { return point_on_edge(corner, 0); };
    const auto edge_from = [&](uint32_t from, uint32_t to) {
        for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
            const Triple& t = mesh.triangles[corner / 3];
            if (t[corner % 3] == from && t[(corner + 1) % 3] == to) return corner;
        }
        return no_index;
    };
    const size_t count = vertices.size();
    for (size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const Corner on_left = edge_from(vertices[i], vertices[(i + 1) % count]),
                     on_right = edge_from(vertices[(i + 1) % count], vertices[i]);
        const bool takes_left = on_left != no_index && (left || on_right == no_index);
        out.points.push_back(place_at(takes_left ? on_left : next_corner(on_right)));
        if (!closed && i + 2 == count) out.points.push_back(place_at(takes_left ? next_corner(on_left) : on_right));
    }
    out.offsets.push_back(static_cast<uint32_t>(out.points.size()));
    out.closed.push_back(closed);
    out.values.push_back(0);
    return out;
}

using Cell = std::array<int, 2>;

// Vertices of a grid of 8 x 8 cells, in steps of one cell along an axis or a diagonal.
std::vector<uint32_t> vertices_along(const std::vector<Cell>& corners, bool closed) {
    const auto sign = [](int x) { return (x > 0) - (x < 0); };
    std::vector<uint32_t> out;
    for (size_t i = 0; i + (closed ? 0 : 1) < corners.size(); ++i) {
        const Cell &from = corners[i], &to = corners[(i + 1) % corners.size()];
        for (Cell at = from; at != to; at[0] += sign(to[0] - at[0]), at[1] += sign(to[1] - at[1]))
            out.push_back(static_cast<uint32_t>(9 * at[1] + at[0]));
    }
    if (!closed) out.push_back(static_cast<uint32_t>(9 * corners.back()[1] + corners.back()[0]));
    return out;
}

// [0, 1]^2 of 8 x 8 cells with the middle 2 x 2 missing.
Soup holed_plane() {
    Soup soup = plane(8), out{soup.positions, {}};
    for (const Triple& t : soup.triangles) {
        const auto is_inside = [&](int axis) {
            const double middle =
                (soup.positions[t[0]][axis] + soup.positions[t[1]][axis] + soup.positions[t[2]][axis]) / 3;
            return middle > 0.375 && middle < 0.625;
        };
        if (!is_inside(0) || !is_inside(1)) out.triangles.push_back(t);
    }
    return out;
}

double farthest_off(const Mesh& mesh, const Lines& lines, const std::function<double(const Vec3&)>& off) {
    double out = 0;
    for (const SurfacePoint& point : lines.curves.points) out = std::max(out, std::abs(off(position_of(mesh, point))));
    return out;
}

// Straight ones, on both sides, in both directions, of either triangle's edges: along rows, columns and diagonals.
TEST(OffsetLines, AlongEdgesOfGridsAreStraight) {
    for (const bool woven : {false, true}) {
        const Mesh mesh = make_mesh(woven ? ground(8, [](double, double) { return 0.0; }) : plane(8));
        std::vector<std::vector<Cell>> ways{{{2, 4}, {6, 4}}, {{4, 2}, {4, 6}}, {{6, 4}, {2, 4}}, {{4, 6}, {4, 2}}};
        if (!woven) ways.insert(ways.end(), {{{2, 2}, {6, 6}}, {{6, 6}, {2, 2}}});
        for (const std::vector<Cell>& way : ways) {
            const Vec3 from(way[0][0] / 8.0, way[0][1] / 8.0, 0), to(way[1][0] / 8.0, way[1][1] / 8.0, 0);
            const Vec3 along = (to - from).normalized(), beside(-along.y(), along.x(), 0);
            for (const bool left : {false, true}) {
                const SurfaceCurves curve = curve_along(mesh, vertices_along(way, false), false, left);
                for (const double offset : {0.03, -0.03, 0.125, -0.125, 0.25, -0.25}) {
                    const Lines lines = lines_beside(mesh, curve, offset);
                    ASSERT_EQ(lines.curves.curve_count(), 1u) << offset << woven << left;
                    EXPECT_NEAR(lines.curves.values[0], (to - from).norm(), 1e-6) << offset;
                    const auto off = [&](const Vec3& x) { return (x - from).dot(beside) - offset; };
                    EXPECT_LT(farthest_off(mesh, lines, off), 1e-6) << offset << woven << left;
                    EXPECT_NEAR((position_of(mesh, lines.curves.points.front()) - from).dot(along), 0, 1e-6);
                }
            }
        }
    }
}

// Across each cell from corner to corner: every point of the curve is a vertex.
TEST(OffsetLines, ThroughVerticesAreStraight) {
    const Mesh mesh = make_mesh(plane(8));
    for (const bool back : {false, true}) {
        Plan plan;
        for (int i = 2; i <= 6; ++i) plan.push_back({i / 8.0, 1 - i / 8.0});
        if (back) std::reverse(plan.begin(), plan.end());
        const SurfaceCurves curve = curve_over(mesh, plan, false);
        for (const double offset : {0.05, -0.05, 0.125, -0.25}) {
            const Lines lines = lines_beside(mesh, curve, offset);
            ASSERT_EQ(lines.curves.curve_count(), 1u) << offset;
            EXPECT_NEAR(lines.curves.values[0], std::sqrt(0.5), 1e-6);
            const double side = back ? -offset : offset;
            const auto off = [&](const Vec3& x) { return (x.x() + x.y() - 1) / std::sqrt(2) - side; };
            EXPECT_LT(farthest_off(mesh, lines, off), 1e-6) << offset;
        }
    }
}

// Within a square smaller squares, without it one with rounded corners.
TEST(OffsetLines, OfSquaresAlongEdgesAreClosed) {
    for (const bool woven : {false, true}) {
        const Mesh mesh = make_mesh(woven ? ground(8, [](double, double) { return 0.0; }) : plane(8));
        for (const bool left : {false, true}) {
            for (const bool back : {false, true}) {
                std::vector<Cell> square{{2, 2}, {6, 2}, {6, 6}, {2, 6}};
                if (back) std::reverse(square.begin(), square.end());
                const SurfaceCurves curve = curve_along(mesh, vertices_along(square, true), true, left);
                for (const double within : {0.05, 0.125, 0.2, -0.06, -0.125}) {
                    const Lines lines = lines_beside(mesh, curve, back ? -within : within);
                    ASSERT_EQ(lines.curves.curve_count(), 1u) << within << woven << left << back;
                    EXPECT_TRUE(lines.curves.closed[0]);
                    const double length = within > 0 ? 4 * (0.5 - 2 * within) : 4 * 0.5 - 2 * M_PI * within;
                    EXPECT_NEAR(lines.curves.values[0], length, 1e-3 * length) << within << woven << left << back;
                    const auto off = [&](const Vec3& x) {
                        const double dx = std::abs(x.x() - 0.5) - 0.25, dy = std::abs(x.y() - 0.5) - 0.25;
                        return std::min(std::max(dx, dy), 0.0) + std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) +
                               within;
                    };
                    EXPECT_LT(farthest_off(mesh, lines, off), 1.1 * offset_tolerance * std::abs(within));
                }
                EXPECT_EQ(lines_beside(mesh, curve, back ? -0.251 : 0.251).curves.curve_count(), 0u);
            }
        }
    }
}

// Along a border there is one side; all of it, or the border of a hole, is a closed curve.
TEST(OffsetLines, AlongBordersLieWithinTheSurface) {
    const Mesh mesh = make_mesh(plane(8)), holed = make_mesh(holed_plane());
    const SurfaceCurves side = curve_along(mesh, vertices_along({{0, 0}, {8, 0}}, false), false, true);
    const SurfaceCurves around = curve_along(mesh, vertices_along({{0, 0}, {8, 0}, {8, 8}, {0, 8}}, true), true, true);
    const SurfaceCurves hole = curve_along(holed, vertices_along({{3, 3}, {3, 5}, {5, 5}, {5, 3}}, true), true, true);
    for (const double offset : {0.02, 0.125, 0.3}) {
        const Lines beside = lines_beside(mesh, side, offset), within = lines_beside(mesh, around, offset),
                    about = lines_beside(holed, hole, offset);
        ASSERT_EQ(beside.curves.curve_count(), 1u);
        EXPECT_NEAR(beside.curves.values[0], 1, 1e-6);
        EXPECT_LT(farthest_off(mesh, beside, [&](const Vec3& x) { return x.y() - offset; }), 1e-6);
        ASSERT_EQ(within.curves.curve_count(), 1u);
        EXPECT_NEAR(within.curves.values[0], 4 * (1 - 2 * offset), 1e-3);
        ASSERT_EQ(about.curves.curve_count(), 1u) << offset;
        EXPECT_TRUE(about.curves.closed[0]);
        EXPECT_NEAR(about.curves.values[0], 4 * 0.25 + 2 * M_PI * offset, 1e-3) << offset;
        for (const auto& [on, curve] : {std::pair{&mesh, &side}, {&mesh, &around}, {&holed, &hole}})
            EXPECT_EQ(lines_beside(*on, *curve, -offset).curves.curve_count(), 0u);
    }
}

// Past a hole the shortest ways bend around its corners.
TEST(OffsetLines, BesideAHoleBendAroundIt) {
    const Soup soup = holed_plane();
    const Mesh mesh = make_mesh(soup);
    for (const bool left : {false, true}) {
        const SurfaceCurves curve = curve_along(mesh, vertices_along({{0, 2}, {8, 2}}, false), false, left);
        for (const double offset : {0.06, 0.2, 0.5, 0.6, -0.2}) {
            const Lines lines = lines_beside(mesh, curve, offset);
            ASSERT_GE(lines.curves.curve_count(), 1u) << offset;
            const auto off = [&](const Vec3& x) {
                const double straight = std::abs(x.y() - 0.25);
                if (x.y() < 0.625 - 1e-6 || x.x() < 0.375 || x.x() > 0.625) return straight - std::abs(offset);
                const double aside = std::min(x.x() - 0.375, 0.625 - x.x());
                return 0.375 + std::hypot(aside, x.y() - 0.625) - std::abs(offset);
            };
            EXPECT_LT(farthest_off(mesh, lines, off), 1.1 * offset_tolerance * std::abs(offset)) << offset;
        }
    }
}

TEST(OffsetLines, FartherThanTheSurfaceReachesAreNone) {
    const Mesh flat = make_mesh(plane(8)), ball = make_mesh(sphere(2));
    const SurfaceCurves straight = curve_along(flat, vertices_along({{2, 4}, {6, 4}}, false), false, true);
    const Triple& t = ball.triangles[0];
    const SurfaceCurves around = curve_along(ball, {t[0], t[1], t[2]}, true, true);
    for (const double offset : {6.0, 1e3, 1e12, 1e30}) {
        for (const double side : {1, -1}) {
            EXPECT_EQ(lines_beside(flat, straight, side * offset).curves.curve_count(), 0u) << offset;
            EXPECT_EQ(lines_beside(ball, around, side * offset).curves.curve_count(), 0u) << offset;
        }
    }
}

// Around a circle: within it nothing is farther away than its middle.
TEST(OffsetLines, OfACircleAreCircles) {
    const Mesh mesh = make_mesh(ground(20, [](double, double) { return 0.0; }));
    Plan plan;
    for (int i = 0; i < 120; ++i)
        plan.push_back({0.5 + 0.2 * std::cos(M_PI * i / 60 + 0.01), 0.5 + 0.2 * std::sin(M_PI * i / 60 + 0.01)});
    const SurfaceCurves curve = curve_over(mesh, plan, true);
    for (const double offset : {0.1, 0.15, -0.1, -0.2}) {
        const Lines lines = lines_beside(mesh, curve, offset);
        ASSERT_EQ(lines.curves.curve_count(), 1u);
        EXPECT_TRUE(lines.curves.closed[0]);
        EXPECT_NEAR(lines.curves.values[0], 2 * M_PI * (0.2 - offset), 2e-3);
        double turn = 0;
        for_stretches(mesh, lines.curves, [&](const SurfacePoint&, const Vec3& a, const Vec3& b) {
            turn += (a - Vec3(0.5, 0.5, 0)).cross(b - Vec3(0.5, 0.5, 0)).z();
        });
        EXPECT_GT(turn, 0);
    }
    EXPECT_EQ(lines_beside(mesh, curve, 0.21).curves.curve_count(), 0u);
}

TEST(OffsetLines, AreTheSameBitsHowEverSliced) {
    const Mesh mesh = make_mesh(ground(30, dents));
    const SurfaceCurves curve = curve_over(mesh, bent_plan(0.1), false);
    const Lines one = lines_beside(mesh, curve, 0.1), other = lines_beside(mesh, curve, 0.1, true);
    ASSERT_EQ(one.curves.points.size(), other.curves.points.size());
    for (size_t i = 0; i < one.curves.points.size(); ++i) {
        EXPECT_EQ(one.curves.points[i].u, other.curves.points[i].u);
        EXPECT_EQ(one.curves.points[i].triangle, other.curves.points[i].triangle);
    }
}

}  // namespace
}  // namespace flg::test
