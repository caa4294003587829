// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "skeletons/random_contours.h"

namespace flg::test {
namespace {

// Inner nodes only.
std::vector<SkeletonNode> inner_nodes(const StraightSkeleton& skeleton) {
    return {skeleton.nodes.begin() + static_cast<ptrdiff_t>(skeleton.face_offsets.size() - 1), skeleton.nodes.end()};
}

bool has_node(const StraightSkeleton& skeleton, double x, double y, double time, double tolerance = 1e-12) {
    for (const SkeletonNode& node : inner_nodes(skeleton)) {
        if (std::fabs(node.at.x - x) + std::fabs(node.at.y - y) + std::fabs(node.time - time) < tolerance) return true;
    }
    return false;
}

std::vector<Point2> regular(int n, double radius) {
    std::vector<Point2> ring;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return ring;
}

TEST(StraightSkeleton, TriangleMeetsInItsIncentre) {
    const StraightSkeleton skeleton = checked_skeleton({{{0, 0}, {4, 0}, {0, 3}}});
    ASSERT_EQ(skeleton.nodes.size(), 4u);
    EXPECT_TRUE(has_node(skeleton, 1, 1, 1));
}

TEST(StraightSkeleton, SquareHasOneNode) {
    const StraightSkeleton skeleton = checked_skeleton({{{0, 0}, {2, 0}, {2, 2}, {0, 2}}});
    ASSERT_EQ(skeleton.nodes.size(), 5u);
    EXPECT_TRUE(has_node(skeleton, 1, 1, 1));
    EXPECT_EQ(skeleton.perturbation, 0);
}

TEST(StraightSkeleton, RectangleHasARidge) {
    const StraightSkeleton skeleton = checked_skeleton({{{0, 0}, {5, 0}, {5, 2}, {0, 2}}});
    ASSERT_EQ(skeleton.nodes.size(), 6u);
    EXPECT_TRUE(has_node(skeleton, 1, 1, 1));
    EXPECT_TRUE(has_node(skeleton, 4, 1, 1));
}

TEST(StraightSkeleton, RegularPolygonsMeetAtTheirApothem) {
    for (const int n : {3, 5, 6, 7, 12, 40, 99, 300}) {
        const StraightSkeleton skeleton = checked_skeleton({regular(n, 3)});
        ASSERT_EQ(skeleton.nodes.size(), static_cast<size_t>(n) + 1) << n;
        EXPECT_TRUE(has_node(skeleton, 0, 0, 3 * std::cos(std::numbers::pi / n), 1e-11)) << n;
    }
}

Rings turned(Rings rings, double angle) {
    for (auto& ring : rings)
        for (Point2& p : ring)
            p = {p.x * std::cos(angle) - p.y * std::sin(angle), p.x * std::sin(angle) + p.y * std::cos(angle)};
    return rings;
}

// Half of all changes come at one time, in triangles that are flat together; turned, their points are off their lines
// by more than a rounding error.
TEST(StraightSkeleton, CombsNeedNoPerturbation) {
    EXPECT_EQ(checked_skeleton(turned(comb(1000, 0), 0.3)).perturbation, 0);
    for (const double angle : {0.0, 0.3, 1.1})
        EXPECT_EQ(skeleton_of(contour_of(turned(comb(5000, 0), angle))).perturbation, 0) << angle;
}

// By looks at the pace, each after some 10 us of work.
TEST(StraightSkeleton, StructuredGiantsTakeLinearTime) {
    const auto looks = [](const Rings& rings) {
        size_t count = 0;
        const Contour contour = contour_of(rings);
        StraightSkeleton skeleton(std::pmr::new_delete_resource());
        run_haltingly(
            std::pmr::new_delete_resource(), [&](Pace& pace) { return straight_skeleton(pace, contour, skeleton); },
            [&](const auto& slice) {
                ++count;
                slice();
            });
        return static_cast<double>(count) / contour.size();
    };
    for (const double angle : {0.0, 0.3})
        EXPECT_LT(looks(turned(comb(8000, 0), angle)), 1.6 * looks(turned(comb(2000, 0), angle))) << angle;
    EXPECT_LT(looks({regular(80000, 3)}), 3);
}

// Two arms of width 2; the reflex corner's arc reaches the diagonal of the outer corner.
TEST(StraightSkeleton, LHasThreeNodes) {
    const StraightSkeleton skeleton = checked_skeleton({{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}}});
    ASSERT_EQ(skeleton.nodes.size(), 9u);
    EXPECT_TRUE(has_node(skeleton, 1, 1, 1));
    EXPECT_TRUE(has_node(skeleton, 5, 1, 1));
    EXPECT_TRUE(has_node(skeleton, 1, 4, 1));
}

// Arms of width 2: four reflex corners meet in the middle, each arm ends in a roof.
TEST(StraightSkeleton, CrossMeetsInTheMiddle) {
    const StraightSkeleton skeleton = checked_skeleton(
        {{{1, 1}, {1, 4}, {-1, 4}, {-1, 1}, {-4, 1}, {-4, -1}, {-1, -1}, {-1, -4}, {1, -4}, {1, -1}, {4, -1}, {4, 1}}});
    ASSERT_EQ(skeleton.nodes.size(), 12u + 5u);
    EXPECT_TRUE(has_node(skeleton, 0, 0, 1));
    EXPECT_TRUE(has_node(skeleton, 0, 3, 1));
    EXPECT_TRUE(has_node(skeleton, 0, -3, 1));
    EXPECT_TRUE(has_node(skeleton, 3, 0, 1));
    EXPECT_TRUE(has_node(skeleton, -3, 0, 1));
}

// A square frame of width 1: a ridge half way around.
TEST(StraightSkeleton, FrameHasARidgeAround) {
    const StraightSkeleton skeleton =
        checked_skeleton({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {5, 1}, {5, 5}, {1, 5}}});
    ASSERT_EQ(skeleton.nodes.size(), 8u + 4u);
    EXPECT_TRUE(has_node(skeleton, 0.5, 0.5, 0.5));
    EXPECT_TRUE(has_node(skeleton, 5.5, 5.5, 0.5));
}

TEST(StraightSkeleton, PointsOnALineKeepTheirFaces) {
    const StraightSkeleton skeleton = checked_skeleton({{{0, 0}, {1, 0}, {3, 0}, {5, 0}, {5, 2}, {0, 2}}});
    EXPECT_TRUE(has_node(skeleton, 1, 1, 1));
    EXPECT_TRUE(has_node(skeleton, 3, 1, 1));
    EXPECT_TRUE(has_node(skeleton, 4, 1, 1));
}

TEST(StraightSkeleton, ScalesByPowersOfTwoToTheBit) {
    const Rings rings = random_tour(5, 50);
    const StraightSkeleton one = checked_skeleton(rings);
    for (const int exponent : {-40, -3, 7, 40}) {
        const double scale = std::ldexp(1, exponent);
        const StraightSkeleton other = checked_skeleton(rotated(rings, 0, scale));
        ASSERT_EQ(other.nodes.size(), one.nodes.size());
        for (size_t i = 0; i < one.nodes.size(); ++i) {
            EXPECT_EQ(other.nodes[i].at.x, one.nodes[i].at.x * scale);
            EXPECT_EQ(other.nodes[i].at.y, one.nodes[i].at.y * scale);
            EXPECT_EQ(other.nodes[i].time, one.nodes[i].time * scale);
        }
        EXPECT_TRUE(
            std::equal(one.face_nodes.begin(), one.face_nodes.end(), other.face_nodes.begin(), other.face_nodes.end()));
    }
}

TEST(StraightSkeleton, TurnsAndGrowsWithItsContour) {
    for (uint64_t seed = 0; seed < 40; ++seed) {
        const Rings rings = seed % 2 == 0 ? random_tour(seed, 40) : random_star(seed, 40);
        const StraightSkeleton one = checked_skeleton(rings);
        const double angle = 0.1 + 0.15 * static_cast<double>(seed), scale = seed % 3 == 0 ? 1e12 : 1e-12;
        const StraightSkeleton other = checked_skeleton(rotated(rings, angle, scale));
        ASSERT_EQ(other.nodes.size(), one.nodes.size()) << seed;
        const double c = std::cos(angle) * scale, s = std::sin(angle) * scale;
        for (const SkeletonNode& node : inner_nodes(one)) {
            const Point2 at = {c * node.at.x - s * node.at.y, s * node.at.x + c * node.at.y};
            EXPECT_TRUE(has_node(other, at.x, at.y, node.time * scale, 1e-9 * scale)) << seed;
        }
    }
}

// Mirrored, and drawn from another point on.
TEST(StraightSkeleton, IsTheSameMirroredAndFromAnyPoint) {
    for (uint64_t seed = 0; seed < 40; ++seed) {
        Rings rings = random_tour(seed, 30);
        const StraightSkeleton one = checked_skeleton(rings);
        for (Point2& p : rings[0]) p.x = -p.x;
        std::rotate(rings[0].begin(), rings[0].begin() + 7, rings[0].end());
        const StraightSkeleton other = checked_skeleton(rings);
        ASSERT_EQ(other.nodes.size(), one.nodes.size()) << seed;
        for (const SkeletonNode& node : inner_nodes(one))
            EXPECT_TRUE(has_node(other, -node.at.x, node.at.y, node.time, 1e-9)) << seed;
    }
}

TEST(StraightSkeleton, SlicesDoNotMatter) {
    for (uint64_t seed = 0; seed < 10; ++seed) {
        const Contour contour = contour_of(pixel_shape(seed, 9, true));
        const StraightSkeleton one = skeleton_of(contour), other = skeleton_of(contour, true);
        ASSERT_EQ(one.nodes.size(), other.nodes.size());
        for (size_t i = 0; i < one.nodes.size(); ++i) {
            EXPECT_EQ(one.nodes[i].at, other.nodes[i].at);
            EXPECT_EQ(one.nodes[i].time, other.nodes[i].time);
        }
        EXPECT_EQ(one.face_nodes, other.face_nodes);
    }
}

// All invariants, and where one of so many edges crosses another.
TEST(StraightSkeleton, ManyPoints) {
    std::vector<Point2> ring;
    constexpr int n = 20'000;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        const double radius = 1 + 0.3 * std::sin(5 * angle) + 0.1 * std::sin(17 * angle);
        ring.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    EXPECT_EQ(checked_skeleton({ring}).perturbation, 0);
    ring[700] = {5, 5};
    ring[900] = {5.001, 4.8};
    const Contour crossing = contour_of({ring});
    try {
        skeleton_of(crossing);
        ADD_FAILURE() << "nothing crosses";
    } catch (const Failure& failure) {
        EXPECT_NE(std::string(failure.what()).find("cross at ("), std::string::npos) << failure.what();
    }
}

// From tiny to huge: the shape of the numbers is the same.
TEST(StraightSkeleton, SizesFromTinyToHuge) {
    for (const double size : {1e-140, 1e-12, 1e12, 1e140}) {
        const Rings rings = rotated({{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}}}, 0, size);
        const Contour contour = contour_of(rings);
        const StraightSkeleton skeleton = skeleton_of(contour);
        ASSERT_EQ(skeleton.nodes.size(), 9u);
        for (const SkeletonNode& node : inner_nodes(skeleton)) EXPECT_NEAR(node.time / size, 1, 1e-13);
    }
}

TEST(StraightSkeleton, FarFromTheOrigin) {
    const Rings rings = rotated(random_tour(3, 40), 0.3, 1, {1e6, -1e6});
    checked_skeleton(rings, 1e-8);
}

// A millimetre beside a kilometre.
TEST(StraightSkeleton, ShortEdgesBesideLongOnes) {
    const StraightSkeleton skeleton =
        checked_skeleton({{{0, 0}, {1000, 0}, {1000, 1000}, {500.001, 1000}, {500, 1000.001}, {0, 1000}}});
    EXPECT_EQ(skeleton.perturbation, 0);
}

// A front edge that has no length any more has to vanish: grids on which programs are known to keep one.
TEST(StraightSkeleton, EdgesWithoutLengthVanish) {
    const StraightSkeleton one = checked_skeleton(
        {{{2, 2}, {4, 0}, {5, 0}, {3, 3}, {3, 4}, {5, 1}, {4, 3}, {5, 5}, {0, 4}, {1, 3}, {0, 0}, {1, 1}}});
    EXPECT_TRUE(has_node(one, 2.0521776, 3.2882456, 0.9478224, 3e-7));
    const StraightSkeleton other = checked_skeleton({{{4, 7},
                                                      {0, 7},
                                                      {0, 5},
                                                      {0, 4},
                                                      {1, 5},
                                                      {1, 6},
                                                      {2, 5},
                                                      {1, 3},
                                                      {3, 4},
                                                      {4, 3},
                                                      {3, 1},
                                                      {6, 0},
                                                      {5, 3},
                                                      {6, 4},
                                                      {4, 6},
                                                      {7, 7}}});
    EXPECT_TRUE(has_node(other, 3.25, 5.25, 0.75 * std::numbers::sqrt2, 1e-12));
}

// A grid moved by 1e-6: a vertex as fast as 1e6 whose slit closes from its other end.
TEST(StraightSkeleton, SlitsThatCloseAtOnce) {
    const StraightSkeleton skeleton = checked_skeleton({{{4.9999990692990099, 4.0000008981104065},
                                                         {3.9999993234832321, 4.9999998172978817},
                                                         {2.9999990037171127, 4.9999995454060597},
                                                         {8.8577781012170744e-07, 4.9999998883166494},
                                                         {-5.1589267673634693e-07, 4.0000000226056249},
                                                         {3.000000619244835, 3.9999999815426022},
                                                         {4.0000000285183548, 4.0000002553991321},
                                                         {-7.3955310072493431e-07, 1.000000388082056},
                                                         {2.0000006814114339, 3.3321565676143861e-08},
                                                         {3.9999993998354419, 0.99999918589734227},
                                                         {5.0000003358540379, 2.0000008332360673},
                                                         {5.0000004546037085, 3.0000004081575797}}},
                                                       1e-6);
    EXPECT_EQ(skeleton.perturbation, 0);
    EXPECT_LE(skeleton.residual, 1e-6);
}

// Pixels moved by 1e-11, whose skeleton is found with points moved by 1e-9.
TEST(StraightSkeleton, TheLadderIsSaid) {
    const StraightSkeleton skeleton = checked_skeleton(jittered(pixel_shape(32, 10, true), 32, 1e-11), 1e-6);
    EXPECT_EQ(skeleton.perturbation, 1e-9);
    EXPECT_GT(skeleton.residual, 1e-10);
    EXPECT_LE(skeleton.residual, 1e-6);
}

}  // namespace
}  // namespace flg::test
