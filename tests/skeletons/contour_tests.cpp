// SPDX-License-Identifier: MIT
#include "skeletons/contour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"
#include "skeletons/random_contours.h"

namespace flg::test {
namespace {

// What is said about rings that have no skeleton.
std::string refusal(const Rings& rings) {
    try {
        skeleton_of(contour_of(rings));
    } catch (const Failure& failure) {
        EXPECT_EQ(failure.result(), FLG_ERROR_INVALID_ARGUMENT);
        return failure.what();
    }
    return "none";
}

const std::vector<Point2> square = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};

std::vector<Point2> box(double x, double y, double width) {
    return {{x, y}, {x, y + width}, {x + width, y + width}, {x + width, y}};
}

TEST(Contour, RingsAreTurned) {
    const Contour contour = contour_of({{{0, 10}, {10, 10}, {10, 0}, {0, 0}}, {{2, 2}, {4, 2}, {4, 4}, {2, 4}}});
    EXPECT_EQ(contour.points[0], (Point2{0, 0}));
    EXPECT_EQ(contour.points[1], (Point2{10, 0}));
    EXPECT_EQ(contour.points[4], (Point2{2, 4}));
    EXPECT_EQ(contour.points[5], (Point2{4, 4}));
    const std::vector<uint32_t> input(contour.input_points.begin(), contour.input_points.end());
    EXPECT_EQ(input, (std::vector<uint32_t>{3, 2, 1, 0, 7, 6, 5, 4}));
    const StraightSkeleton skeleton = skeleton_of(contour);
    EXPECT_EQ(joined(broken_invariants(contour, skeleton)), "");
}

TEST(Contour, RepeatedPointsAreDropped) {
    const Contour contour = contour_of({{{0, 0}, {0, 0}, {10, 0}, {10, 1e-13}, {10, 10}, {0, 10}, {0, 0}}});
    EXPECT_EQ(std::vector<Point2>(contour.points.begin(), contour.points.end()), square);
}

TEST(Contour, RingsWithoutThreePointsAreRefused) {
    EXPECT_EQ(refusal({{{0, 0}, {1, 1}}}), "contour: ring 0 has 2 distinct points; a ring has three or more");
    EXPECT_EQ(refusal({square, {{3, 3}, {3, 3}, {3, 3}}}),
              "contour: ring 1 has 1 distinct points; a ring has three or more");
    EXPECT_EQ(refusal({}), "contour: it has no points");
    EXPECT_EQ(refusal({{{2, 2}, {2, 2}, {2, 2}}}), "contour: all its points are within 0 of each other");
}

TEST(Contour, RingsWithoutAreaAreRefused) {
    const std::string sentence = "contour: ring 0, with (0, 0), has no area, or runs back on itself";
    EXPECT_EQ(refusal({{{0, 0}, {1, 1}, {2, 2}}}), sentence);
    EXPECT_EQ(refusal({{{0, 0}, {1, 1}, {2, 2}, {1, 1}}}), sentence);
    EXPECT_EQ(refusal({{{0, 0}, {1, 1e-12}, {2, 0}}}), sentence);
}

TEST(Contour, NumbersAreFinite) {
    const double infinite = std::numeric_limits<double>::infinity(), nan = std::nan("");
    EXPECT_EQ(refusal({{{0, 0}, {infinite, 0}, {0, 1}}}),
              "contour: point 1 is (inf, 0); coordinates are finite, at most 1e+150");
    EXPECT_EQ(refusal({{{0, 0}, {1, 0}, {0, nan}}}),
              "contour: point 2 is (0, nan); coordinates are finite, at most 1e+150");
    EXPECT_EQ(refusal({{{0, 0}, {1e200, 0}, {0, 1}}}),
              "contour: point 1 is (1e+200, 0); coordinates are finite, at most 1e+150");
}

TEST(Contour, CrossingsAreReportedWithTheirPlace) {
    EXPECT_EQ(refusal({{{0, 0}, {10, 8}, {10, 0}, {0, 10}}}),
              "contour: the edges between points 0 and 1 and between 2 and 3 cross at (5.55555556, 4.44444444)");
    EXPECT_EQ(refusal({square, box(8, 4, 4)}),
              "contour: the edges between points 1 and 2 and between 5 and 6 cross at (10, 8)");
}

// As much area turned one way as the other.
TEST(Contour, FiguresOfEightCross) {
    EXPECT_EQ(refusal({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}),
              "contour: the edges between points 0 and 1 and between 2 and 3 cross at (1, 1)");
}

TEST(Contour, SpikesAreReported) {
    EXPECT_EQ(refusal({{{0, 0}, {10, 0}, {10, 10}, {10, 15}, {10, 10}, {0, 10}}}),
              "contour: points 2 and 4 are at one place, (10, 10)");
    EXPECT_EQ(refusal({{{0, 0}, {10, 0}, {10, 15}, {10, 10}, {0, 10}}}),
              "contour: point 3 is on the edge between points 1 and 2, at (10, 10)");
}

TEST(Contour, TouchingRingsAreReported) {
    EXPECT_EQ(refusal({square, box(2, 2, 3), box(5, 5, 2)}), "contour: points 6 and 8 are at one place, (5, 5)");
    EXPECT_EQ(refusal({square, box(0, 2, 3)}), "contour: point 5 is on the edge between points 3 and 0, at (0, 5)");
    EXPECT_EQ(refusal({square, box(2, 2, 3), {{5, 3}, {7, 4}, {7, 2}}}),
              "contour: point 8 is on the edge between points 6 and 7, at (5, 3)");
}

TEST(Contour, HolesAreInside) {
    EXPECT_EQ(refusal({square, box(20, 2, 3)}), "contour: ring 1, with (20, 2), is outside of ring 0");
    EXPECT_EQ(refusal({square, box(-5, -5, 30)}), "contour: ring 1, with (-5, -5), is outside of ring 0");
    EXPECT_EQ(refusal({square, box(2, 2, 6), box(3, 3, 2)}),
              "contour: ring 1, with (2, 2), is a hole with a ring in it");
    EXPECT_EQ(refusal({square, square}), "contour: points 0 and 4 are at one place, (0, 0)");
}

// Rings of points anywhere: refused exactly when two of their edges touch.
TEST(Contour, WhatIsRefusedIsNotSimple) {
    int simple = 0, crossing = 0;
    for (uint64_t seed = 0; seed < 3000; ++seed) {
        std::vector<Point2> ring;
        const uint32_t n = 3 + random_below(seed, 0, 9, 6), grid = seed % 2 == 0 ? 6 : 1000;
        for (uint32_t i = 0; i < n; ++i)
            ring.push_back({double(random_below(seed, i, 0, grid)), double(random_below(seed, i, 1, grid))});
        bool repeats = false;
        for (uint32_t i = 0; i < n; ++i) repeats |= ring[i] == ring[(i + 1) % n];
        if (repeats) continue;
        const bool is_good = is_simple(ring);
        ++(is_good ? simple : crossing);
        EXPECT_EQ(refusal({ring}) == "none", is_good) << "seed " << seed << ": " << refusal({ring});
    }
    EXPECT_GT(simple, 300);
    EXPECT_GT(crossing, 300);
}

}  // namespace
}  // namespace flg::test
