// SPDX-License-Identifier: MIT
// Which points of curves are corners, and samples that come to them.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "core/random.h"
#include "curves/corners.h"
#include "curves/curve_inputs.h"

namespace flg::test {
namespace {

constexpr double degree = two_pi / 360;
constexpr double fifty_degrees = 50 * degree;

struct Found {
    uint32_t corners = 0, first_segment = 0;
    std::vector<uint8_t> marks;
};

Found found_in(const Points& points, CornerSearch search) {
    Found found;
    found.marks.resize(points.view().count);
    const CornerCount count = run_now(
        std::pmr::new_delete_resource(),
        [&](Pace& pace) { return find_corners(pace, points.view(), search, found.marks); }, true);
    found.corners = count.corners;
    found.first_segment = count.first_segment;
    return found;
}

Found corners_of(const Points& points, double angle = fifty_degrees) {
    return found_in(points, {angle, 0});
}

// Unit steps, each turned by so many degrees against the one before.
Points turning(const std::vector<double>& turns_deg, bool closed = false) {
    std::vector<Vec3> points = {Vec3::Zero(), Vec3::UnitX()};
    double angle = 0;
    for (const double turn : turns_deg) {
        angle += turn * degree;
        points.push_back(points.back() + Vec3(std::cos(angle), std::sin(angle), 0));
    }
    return points_of(points, closed);
}

Points polygon(int corners, int points_a_side, int first = 0) {
    std::vector<Vec3> points;
    const auto corner = [&](int i) { return Vec3(std::cos(two_pi * i / corners), std::sin(two_pi * i / corners), 0); };
    const int count = corners * points_a_side;
    for (int k = first; k < first + count; ++k) {
        const int side = k / points_a_side;
        const double t = static_cast<double>(k % points_a_side) / points_a_side;
        points.push_back((1 - t) * corner(side) + t * corner(side + 1));
    }
    return points_of(points, true);
}

TEST(Corners, StandOut) {
    EXPECT_EQ(corners_of(turning({0, 60, 0, 0})).corners, 1u);
    EXPECT_EQ(corners_of(turning({60})).corners, 1u);
    EXPECT_EQ(corners_of(turning({0, 45, 0})).corners, 0u);
    // A bend that is sampled coarsely, as hands draw it.
    EXPECT_EQ(corners_of(turning({25, 56, 46, 79, 53})).corners, 0u);
    // The same turns to and fro: a zigzag.
    EXPECT_EQ(corners_of(turning({60, -60, 60, -60})).corners, 4u);
    // A sharp turn at the end of a bend.
    EXPECT_EQ(corners_of(turning({30, 30, 120, 30})).corners, 1u);
    EXPECT_EQ(corners_of(turning({0, 90, 90, 0})).corners, 2u);
    EXPECT_EQ(corners_of(turning({0, 180, 0})).corners, 1u);
    EXPECT_EQ(corners_of(turning({0, 30, 0}), 20 * degree).corners, 1u);
}

TEST(Corners, OfPolygons) {
    for (const int points : {1, 2, 9}) {
        EXPECT_EQ(corners_of(polygon(3, points)).corners, 3u) << points;
        EXPECT_EQ(corners_of(polygon(4, points)).corners, 4u) << points;
        EXPECT_EQ(corners_of(polygon(8, points)).corners, 0u) << points;
        // Between others, corners need not stand out of each other.
        EXPECT_EQ(corners_of(polygon(6, points)).corners, points == 1 ? 0u : 6u) << points;
    }
}

TEST(Corners, OfSmoothCurvesAreNone) {
    for (const int points : {8, 12, 50}) {
        const auto circle = [](double u) { return Vec3(std::cos(two_pi * u), std::sin(two_pi * u), 0); };
        EXPECT_EQ(corners_of(sampled(circle, points, true)).corners, 0u) << points;
    }
    EXPECT_EQ(corners_of(sampled(helix, 40)).corners, 0u);
    EXPECT_EQ(corners_of(points_of({Vec3::Zero()})).corners, 0u);
    EXPECT_EQ(corners_of(points_of({Vec3::Zero(), Vec3::Zero()}, true)).corners, 0u);
    EXPECT_EQ(corners_of(points_of({Vec3::Zero(), Vec3::UnitX()})).corners, 0u);
}

TEST(Corners, AreFoundWhereverAClosedCurveBegins) {
    for (int first = 0; first < 7; ++first) {
        const Found count = corners_of(polygon(4, 7, first));
        EXPECT_EQ(count.corners, 4u) << first;
        EXPECT_EQ(count.first_segment, static_cast<uint32_t>((7 - first) % 7)) << first;
    }
}

// ---- drawn round ----

// Straight sides from corner to corner; each is a circle's arc of so many points, over so much of the path.
struct RoundedPolygon {
    std::vector<Vec3> corners;
    bool closed = true;
    double spacing = 0.02;
    int arc_points = 5;
    double tremor = 0;  // metres
    uint32_t seed = 1;

    std::vector<Vec3> middles{};  // of the arcs
    Points points() {
        std::vector<Vec3> all;
        middles.clear();
        const size_t count = corners.size();
        const auto at = [&](size_t i) { return corners[(i + count) % count]; };
        const auto line = [&](const Vec3& to) {
            while (!all.empty() && (to - all.back()).norm() > 1.5 * spacing) {
                all.push_back(all.back() + spacing * (to - all.back()).normalized());
            }
            all.push_back(to);
        };
        for (size_t i = 0; i < count; ++i) {
            if (!closed && (i == 0 || i + 1 == count)) {
                line(at(i));
                continue;
            }
            const Vec3 before = (at(i) - at(i + count - 1)).normalized(), behind = (at(i + 1) - at(i)).normalized();
            const double turn = std::acos(before.dot(behind));
            // Arcs of points as far apart as elsewhere.
            const double radius = spacing * (arc_points - 1) / turn, cut = radius * std::tan(turn / 2);
            const Vec3 from = at(i) - cut * before, across = (behind - before.dot(behind) * before).normalized();
            for (int k = 0; k < arc_points; ++k) {
                const double a = turn * k / (arc_points - 1);
                const Vec3 p = from + radius * (std::sin(a) * before + (1 - std::cos(a)) * across);
                k == 0 ? line(p) : all.push_back(p);
            }
            middles.push_back(from + radius * (std::sin(turn / 2) * before + (1 - std::cos(turn / 2)) * across));
        }
        if (closed) {
            const Vec3 end = all.front();
            line(end);
            all.pop_back();
        }
        for (size_t i = 0; i < all.size(); ++i) {
            for (int c = 0; c < 2; ++c) {
                all[i][c] += tremor * (2 * random_unit(seed, static_cast<uint64_t>(c), static_cast<uint32_t>(i)) - 1);
            }
        }
        return points_of(all, closed);
    }
};

const CornerSearch bends{fifty_degrees, 0.3};

void expect_at(const Found& found, const Points& points, const std::vector<Vec3>& middles, double tolerance,
               const char* what) {
    EXPECT_EQ(found.corners, middles.size()) << what;
    for (const Vec3& middle : middles) {
        double nearest = HUGE_VAL;
        for (uint32_t i = 0; i < found.marks.size(); ++i) {
            if (found.marks[i]) nearest = std::min(nearest, (points.view().point(i) - middle).norm());
        }
        EXPECT_LE(nearest, tolerance) << what;
    }
}

TEST(RoundCorners, OfPolygonsAndLetters) {
    const auto star = [] {
        std::vector<Vec3> corners;
        for (int i = 0; i < 10; ++i) {
            const double a = two_pi * i / 10, r = i % 2 == 0 ? 3 : 1.4;
            corners.push_back(Vec3(r * std::cos(a), r * std::sin(a), 0));
        }
        return corners;
    }();
    const std::vector<Vec3> rectangle = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 2, 0), Vec3(0, 2, 0)};
    const std::vector<Vec3> n = {Vec3(0, 0, 0), Vec3(0, 3, 0), Vec3(2, 0, 0), Vec3(2, 3, 0)};
    const std::vector<Vec3> z = {Vec3(0, 3, 0), Vec3(2, 3, 1), Vec3(0, 0, 0), Vec3(2, 0, 0)};
    const std::vector<Vec3> l = {Vec3(0, 3, 0), Vec3(0, 0, 0), Vec3(1.5, 0, 0)};
    for (const double spacing : {0.02, 0.03, 0.05}) {
        for (int arc = 2; arc <= 9; ++arc) {
            if (spacing * (arc - 1) > bends.longest_bend) continue;
            for (const double tremor : {0.0, 0.1}) {
                for (const auto* corners : {&star, &rectangle, &n, &z, &l}) {
                    const bool closed = corners == &star || corners == &rectangle;
                    RoundedPolygon drawn{*corners, closed, spacing, arc, tremor * spacing};
                    const Points points = drawn.points();
                    char what[96];
                    std::snprintf(what, sizeof what, "%zu corners, spacing %g, %d points, tremor %g", corners->size(),
                                  spacing, arc, tremor);
                    expect_at(found_in(points, bends), points, drawn.middles, (tremor > 0 ? 2 : 1.01) * spacing, what);
                }
            }
        }
    }
}

TEST(RoundCorners, WiderThanWantedAreNone) {
    RoundedPolygon drawn{{Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(9, 6, 0), Vec3(0, 6, 0)}, true, 0.05, 30};
    EXPECT_EQ(found_in(drawn.points(), bends).corners, 0u);
    EXPECT_EQ(found_in(drawn.points(), {fifty_degrees, 1.6}).corners, 4u);
}

// Wherever the curve begins, in the middle of a corner, too.
TEST(RoundCorners, AreFoundWhereverAClosedCurveBegins) {
    RoundedPolygon drawn{{Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 2, 0), Vec3(0, 2, 0)}, true, 0.05, 5};
    const Points points = drawn.points();
    const uint32_t count = points.view().count;
    for (uint32_t first = 0; first < count; ++first) {
        std::vector<Vec3> turned;
        for (uint32_t i = 0; i < count; ++i) turned.push_back(points.view().point((first + i) % count));
        const Points begun = points_of(turned, true);
        expect_at(found_in(begun, bends), begun, drawn.middles, 0.051, "begun elsewhere");
    }
}

// Whatever bends are looked for; but for narrow ones, which are corners to who looks for wider ones.
TEST(RoundCorners, SmoothCurvesHaveNone) {
    struct Smooth {
        const char* name;
        std::function<Vec3(double)> at;
        bool closed = false;
        double narrowest = HUGE_VAL;  // bend
    };
    const auto around = [](double u) { return two_pi * u; };
    const Smooth curves[] = {
        {"circle", [=](double u) { return Vec3(std::cos(around(u)), std::sin(around(u)), 0); }, true},
        {"ellipse", [=](double u) { return Vec3(2 * std::cos(around(u)), std::sin(around(u)), 0); }, true},
        {"narrow", [=](double u) { return Vec3(3 * std::cos(around(u)), std::sin(around(u)), 0); }, true},
        {"eight", [=](double u) { return Vec3(std::sin(around(u)), 0.5 * std::sin(2 * around(u)), 0); }, true},
        {"spiral", [=](double u) { return Vec3(2 * u * std::cos(5 * around(u)), 2 * u * std::sin(5 * around(u)), 0); }},
        {"coil", [=](double u) { return Vec3(u, 0.1 * std::cos(9 * around(u)), 0.1 * std::sin(9 * around(u))); }},
        {"waves", [=](double u) { return Vec3(4 * u, 0.15 * std::sin(5 * around(u)), 0); }},
        {"eee",
         [=](double u) { return Vec3(3 * u - 0.25 * std::sin(6 * around(u)), 0.4 * std::cos(6 * around(u)), 0); }},
        {"lll", [=](double u) { return Vec3(2 * u - 0.2 * std::sin(6 * around(u)), std::cos(6 * around(u)), 0); },
         false, 0.02},
        {"mmm", [=](double u) { return Vec3(4 * u, 0.3 * std::sin(5 * around(u)), 0); }, false, 0.05}};
    for (const Smooth& curve : curves) {
        for (const int count : {40, 60, 90, 200, 1000}) {
            const Points points = sampled(curve.at, count, curve.closed);
            // What single points make of coarse samples is not asked here.
            const uint32_t single = corners_of(points).corners;
            for (const double bend : {0.02, 0.05, 0.1, 0.3, 0.7, 1.5, 4.0}) {
                if (bend > curve.narrowest) continue;
                EXPECT_EQ(found_in(points, {fifty_degrees, bend}).corners, single)
                    << curve.name << ", " << count << ", " << bend;
            }
        }
    }
}

// A line and an arc by a hand that trembles.
TEST(RoundCorners, TremorMakesNone) {
    for (uint32_t seed = 0; seed < 20; ++seed) {
        for (const double tremor : {0.05, 0.15, 0.25}) {
            for (const double bend : {0.05, 0.3, 1.0}) {
                std::vector<Vec3> line, arc;
                const double spacing = 0.02;
                for (uint32_t i = 0; i < 300; ++i) {
                    const auto off = [&](uint64_t c) { return tremor * spacing * (2 * random_unit(seed, c, i) - 1); };
                    const double s = spacing * i;
                    line.push_back(Vec3(s + off(0), off(1), off(2)));
                    arc.push_back(Vec3(std::cos(s) + off(3), std::sin(s) + off(4), off(5)));
                }
                for (const auto* points : {&line, &arc}) {
                    const Points drawn = points_of(*points);
                    EXPECT_EQ(found_in(drawn, {fifty_degrees, bend}).corners, corners_of(drawn).corners)
                        << seed << ", " << tremor << ", " << bend;
                }
            }
        }
    }
}

// Repeated points are one.
TEST(Corners, AreMetByASampleEach) {
    const std::vector<Vec3> corners = {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 0, 0), Vec3(3, 1, 0), Vec3(-2, 1, 4)};
    const Points points = points_of(corners);
    ASSERT_EQ(corners_of(points).corners, 2u);
    std::vector<CurvePiece> pieces(3);
    pieces[1].first_segment = 2;
    pieces[2].first_segment = 3;
    run_now(
        std::pmr::new_delete_resource(),
        [&](Pace& pace) { return split_at_corners(pace, points.view(), nullptr, pieces); }, true);
    EXPECT_NEAR(pieces[0].length, 3, 1e-6);
    EXPECT_NEAR(pieces[1].length, 1, 1e-6);
    const uint32_t steps[] = {7, 1, 20};
    uint32_t end = 0;
    for (int p = 0; p < 3; ++p) {
        end += steps[p];
        pieces[p].end_step = end;
        pieces[p].step = pieces[p].length / steps[p];
    }
    SamplingPlan plan = plan_of(points, end);
    plan.pieces = pieces;
    const Resampled samples = resample(plan, true);
    EXPECT_EQ(samples.position(0), corners[0]);
    EXPECT_EQ(samples.position(7), corners[1]);
    EXPECT_EQ(samples.position(8), corners[3]);
    EXPECT_EQ(samples.position(end), corners[4]);
    for (uint32_t i = 1; i < 7; ++i) EXPECT_NEAR(samples.position(i).x(), i * 3.0 / 7, 1e-5);
    // A corner's sample goes the way behind it.
    EXPECT_NEAR(samples.tangent(7).y(), 1, 1e-5);
}

}  // namespace
}  // namespace flg::test
