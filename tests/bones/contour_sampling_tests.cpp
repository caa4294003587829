// SPDX-License-Identifier: MIT
#include <cmath>
#include <set>

#include "bones/parts.h"

namespace flg::test {
namespace {

Contour even(const Contour& contour, double spacing, bool haltingly = false) {
    return made([&](Pace& pace) { return even_contour(pace, contour, spacing); }, haltingly);
}

Contour simplified(const Contour& contour, double tolerance, bool haltingly = false) {
    return made([&](Pace& pace) { return simplified_contour(pace, contour, tolerance); }, haltingly);
}

double distance_to(const Point2& p, const Point2& a, const Point2& b) {
    const double length2 = distance(a, b) * distance(a, b);
    const double along = std::clamp(((p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y)) / length2, 0.0, 1.0);
    return distance(p, mix(a, b, along));
}

Rings circle(uint32_t n) {
    std::vector<Point2> ring;
    for (uint32_t i = 0; i < n; ++i) ring.push_back({std::cos(2 * M_PI * i / n), std::sin(2 * M_PI * i / n)});
    return {ring};
}

TEST(EvenContour, HasPointsAtEqualDistancesOnTheLine) {
    const Contour square = contour_of({{{0, 0}, {3, 0}, {3, 1}, {0, 1}}, {{1, 0.4}, {2, 0.4}, {2, 0.6}, {1, 0.6}}});
    const Contour points = even(square, 0.1);
    ASSERT_EQ(points.ring_count(), 2u);
    EXPECT_EQ(points.offsets[1], 80u);
    EXPECT_EQ(points.size(), 80u + 24u);
    for (uint32_t i = 0; i < 80; ++i) {
        EXPECT_NEAR(distance(points.points[i], points.points[points.next(i)]), 0.1, 1e-12);
        EXPECT_LT(points.input_points[i], 4u);
    }
}

TEST(EvenContour, AFewPointsAreMadeAtLeast) {
    EXPECT_EQ(even(contour_of(circle(40)), 100).size(), 8u);
}

TEST(EvenContour, CornersStay) {
    // However the spacing falls, and wherever the ring begins.
    const std::vector<Point2> leg = {{-0.2, -2}, {0.2, -2}, {0.25, 0}, {-0.25, 0}};
    for (size_t shift = 0; shift < 4; ++shift) {
        std::vector<Point2> ring = leg;
        std::rotate(ring.begin(), ring.begin() + static_cast<ptrdiff_t>(shift), ring.end());
        const Contour out = even(contour_of({ring}), 0.0237);
        for (const Point2& corner : leg) EXPECT_EQ(std::count(out.points.begin(), out.points.end(), corner), 1);
        for (uint32_t i = 0; i < out.size(); ++i) {
            const double edge = distance(out.points[i], out.points[out.next(i)]);
            EXPECT_LT(edge, 1.3 * 0.0237);
            EXPECT_GT(edge, 0.2 * 0.0237);
        }
        // Its axis is upright, not a diagonal.
        const PartSkeleton part = part_of(simplified(out, 0.008), 0.02);
        for (const AxisNode& node : part.graph.nodes) EXPECT_NEAR(node.at.x, 0, 1e-9);
        EXPECT_EQ(part.branches.size(), 1u);
    }
}

TEST(EvenContour, RefusesMorePointsThanThereMayBe) {
    EXPECT_THROW(even(contour_of({{{0, 0}, {1, 0}, {0, 1}}}), 1e-8), Failure);
}

TEST(SimplifiedContour, StaysWithinTheTolerance) {
    for (const Contour& contour : some_contours()) {
        for (const double share : {0.0, 0.003, 0.03, 10.0}) {
            const double tolerance = share * size_of(contour);
            const Contour out = simplified(contour, tolerance);
            ASSERT_EQ(out.ring_count(), contour.ring_count());
            for (uint32_t r = 0; r < out.ring_count(); ++r) {
                const uint32_t begin = out.offsets[r], end = out.offsets[r + 1];
                ASSERT_GE(end - begin, 3u);
                for (uint32_t i = contour.offsets[r]; i < contour.offsets[r + 1]; ++i) {
                    double nearest = 1e300;
                    for (uint32_t k = begin; k < end; ++k)
                        nearest = std::min(nearest, distance_to(contour.points[i], out.points[k],
                                                                out.points[k + 1 == end ? begin : k + 1]));
                    ASSERT_LE(nearest, tolerance + 1e-15);
                }
            }
        }
    }
}

TEST(SimplifiedContour, DoesNotDependOnWhereARingBegins) {
    const Rings rings = random_star(5, 90);
    const auto kept = [](const Contour& contour) {
        std::set<std::pair<double, double>> points;
        for (const Point2& p : simplified(contour, 0.02).points) points.insert({p.x, p.y});
        return points;
    };
    const auto expected = kept(contour_of(rings));
    EXPECT_LT(expected.size(), 90u);
    EXPECT_GT(expected.size(), 5u);
    for (const size_t shift : {1u, 17u, 60u}) {
        Rings shifted = rings;
        std::rotate(shifted[0].begin(), shifted[0].begin() + static_cast<ptrdiff_t>(shift), shifted[0].end());
        EXPECT_EQ(kept(contour_of(shifted)), expected);
    }
}

TEST(SimplifiedContour, NeedsFewPointsForACircleWithinOnePercent) {
    // A chord of angle a is 1 - cos(a / 2) off: 22 degrees and more within 0.02.
    const uint32_t points = simplified(contour_of(circle(1000)), 0.02).size();
    EXPECT_GE(points, 16u);
    EXPECT_LE(points, 32u);
}

TEST(ContourSampling, SameBitsWithPauses) {
    for (const Rings& rings : {random_tour(9, 200), star_with_holes(3, 40, 3, 7)}) {
        const Contour contour = contour_of(rings);
        EXPECT_EQ(even(contour, 0.01).points, even(contour, 0.01, true).points);
        EXPECT_EQ(simplified(contour, 0.01).points, simplified(contour, 0.01, true).points);
    }
}

}  // namespace
}  // namespace flg::test
