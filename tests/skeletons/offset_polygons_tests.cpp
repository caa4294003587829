// SPDX-License-Identifier: MIT
#include "skeletons/offset_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "skeletons/random_contours.h"

namespace flg::test {
namespace {

OffsetRings offset_of(const StraightSkeleton& skeleton, double distance) {
    OffsetRings rings(std::pmr::new_delete_resource());
    offset_polygons(skeleton, distance, rings, std::pmr::new_delete_resource());
    return rings;
}

double area_of(std::span<const Point2> ring) {
    double twice = 0;
    for (size_t i = 0; i < ring.size(); ++i) {
        const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
        twice += (a.x - ring[0].x) * (b.y - ring[0].y) - (b.x - ring[0].x) * (a.y - ring[0].y);
    }
    return twice / 2;
}

struct Measures {
    double area = 0, length = 0;
};

Measures measures(const OffsetRings& rings) {
    Measures m;
    for (size_t r = 0; r + 1 < rings.offsets.size(); ++r) {
        const std::span<const Point2> ring(rings.points.data() + rings.offsets[r],
                                           rings.offsets[r + 1] - rings.offsets[r]);
        m.area += area_of(ring);
        for (size_t i = 0; i < ring.size(); ++i) {
            const Point2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
            m.length += std::hypot(b.x - a.x, b.y - a.y);
        }
    }
    return m;
}

double last_time(const StraightSkeleton& skeleton) {
    double last = 0;
    for (const SkeletonNode& node : skeleton.nodes) last = std::max(last, node.time);
    return last;
}

TEST(OffsetPolygons, OfARectangle) {
    const StraightSkeleton skeleton = checked_skeleton({{{0, 0}, {5, 0}, {5, 2}, {0, 2}}});
    const OffsetRings rings = offset_of(skeleton, 0.25);
    ASSERT_EQ(rings.offsets.size(), 2u);
    ASSERT_EQ(rings.points.size(), 4u);
    const Point2 corners[] = {{0.25, 0.25}, {4.75, 0.25}, {4.75, 1.75}, {0.25, 1.75}};
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(rings.points[i].x, corners[i].x, 1e-14);
        EXPECT_NEAR(rings.points[i].y, corners[i].y, 1e-14);
        EXPECT_EQ(rings.edges[i], i);
    }
}

// The L comes apart in none: (6 - 2 d) (2 - 2 d) + (2 - 2 d) 3.
TEST(OffsetPolygons, OfAnL) {
    const StraightSkeleton skeleton = checked_skeleton({{{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 5}, {0, 5}}});
    for (const double d : {0.1, 0.5, 0.9, 0.999}) {
        const OffsetRings rings = offset_of(skeleton, d);
        EXPECT_EQ(rings.offsets.size(), 2u);
        EXPECT_EQ(rings.points.size(), 6u);
        EXPECT_NEAR(measures(rings).area, (6 - 2 * d) * (2 - 2 * d) + (2 - 2 * d) * 3, 1e-13);
    }
    EXPECT_EQ(offset_of(skeleton, 1).points.size(), 0u);
    EXPECT_EQ(offset_of(skeleton, 7).offsets.size(), 1u);
}

// Two rooms and a corridor: past half its width they are two.
TEST(OffsetPolygons, ComeApart) {
    const StraightSkeleton skeleton = checked_skeleton(
        {{{0, 0}, {4, 0}, {4, 1.5}, {7, 1.5}, {7, 0}, {11, 0}, {11, 4}, {7, 4}, {7, 2.5}, {4, 2.5}, {4, 4}, {0, 4}}});
    EXPECT_EQ(offset_of(skeleton, 0.4).offsets.size(), 2u);
    const OffsetRings apart = offset_of(skeleton, 0.6);
    EXPECT_EQ(apart.offsets.size(), 3u);
    EXPECT_NEAR(measures(apart).area, 2 * 2.8 * 2.8, 1e-13);
}

TEST(OffsetPolygons, FramesHaveTwoRings) {
    const StraightSkeleton skeleton =
        checked_skeleton({{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{1, 1}, {5, 1}, {5, 5}, {1, 5}}});
    const OffsetRings rings = offset_of(skeleton, 0.25);
    ASSERT_EQ(rings.offsets.size(), 3u);
    EXPECT_NEAR(area_of({rings.points.data(), 4}), 5.5 * 5.5, 1e-13);
    EXPECT_NEAR(area_of({rings.points.data() + 4, 4}), -4.5 * 4.5, 1e-13);
}

TEST(OffsetPolygons, AtZeroTheyAreTheContour) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
        const Contour contour =
            contour_of(seed % 2 == 0 ? pixel_shape(seed, 8, true) : star_with_holes(seed, 20, 2, 5));
        const OffsetRings rings = offset_of(skeleton_of(contour), 0);
        ASSERT_EQ(rings.points.size(), contour.size());
        ASSERT_EQ(rings.offsets.size(), contour.offsets.size());
        for (uint32_t i = 0; i < contour.size(); ++i) EXPECT_EQ(rings.points[i], contour.points[rings.edges[i]]);
        EXPECT_TRUE(std::equal(rings.edges.begin() + 1, rings.edges.begin() + rings.offsets[1], rings.edges.begin(),
                               [&](uint32_t next, uint32_t edge) { return next == contour.next(edge); }));
    }
}

// The area shrinks by its length: by Simpson's rule over each stretch between two nodes' times, on which it is linear.
TEST(OffsetPolygons, LengthsAddUpToTheArea) {
    for (uint64_t seed = 0; seed < 24; ++seed) {
        const Contour contour = contour_of(seed % 3 == 0   ? random_star(seed, 30)
                                           : seed % 3 == 1 ? random_tour(seed, 30)
                                                           : star_with_holes(seed, 20, 2, 5));
        const StraightSkeleton skeleton = skeleton_of(contour);
        std::vector<double> times = {0};
        for (const SkeletonNode& node : skeleton.nodes) times.push_back(node.time);
        std::sort(times.begin(), times.end());
        double swept = 0;
        for (size_t i = 0; i + 1 < times.size(); ++i) {
            if (times[i + 1] - times[i] < 1e-9) continue;
            const double middle = (times[i] + times[i + 1]) / 2;
            swept += (times[i + 1] - times[i]) * measures(offset_of(skeleton, middle)).length;
        }
        EXPECT_NEAR(swept, measures(offset_of(skeleton, 0)).area, 1e-6) << seed;
        EXPECT_EQ(offset_of(skeleton, last_time(skeleton)).points.size(), 0u);
    }
}

// Each side lies at the distance from its edge's line, along it, and goes its way.
TEST(OffsetPolygons, SidesAreParallelToTheirEdges) {
    for (uint64_t seed = 0; seed < 40; ++seed) {
        const Contour contour = contour_of(seed % 2 == 0 ? random_tour(seed, 40) : grid_tour(seed, 30, 9));
        const StraightSkeleton skeleton = skeleton_of(contour);
        for (const double share : {0.05, 0.3, 0.7, 0.95}) {
            const double distance = share * last_time(skeleton);
            const OffsetRings rings = offset_of(skeleton, distance);
            ASSERT_GT(rings.points.size(), 2u);
            for (size_t r = 0; r + 1 < rings.offsets.size(); ++r) {
                for (uint32_t i = rings.offsets[r]; i < rings.offsets[r + 1]; ++i) {
                    const Point2 &p = rings.points[i],
                                 &q = rings.points[i + 1 == rings.offsets[r + 1] ? rings.offsets[r] : i + 1];
                    const Point2 &a = contour.points[rings.edges[i]], &b = contour.points[contour.next(rings.edges[i])];
                    const double length = std::hypot(b.x - a.x, b.y - a.y);
                    for (const Point2& end : {p, q}) {
                        const double off = ((b.x - a.x) * (end.y - a.y) - (b.y - a.y) * (end.x - a.x)) / length;
                        EXPECT_NEAR(off, distance, 1e-9) << seed;
                    }
                    EXPECT_GT((q.x - p.x) * (b.x - a.x) + (q.y - p.y) * (b.y - a.y), -1e-9) << seed;
                }
            }
        }
    }
}

TEST(OffsetPolygons, RingsThatWereThereDoNotMatter) {
    const StraightSkeleton skeleton = checked_skeleton(pixel_shape(4, 12, true));
    const OffsetRings one = offset_of(skeleton, 0.3);
    OffsetRings other = offset_of(skeleton, 0.1);
    offset_polygons(skeleton, 0.3, other, std::pmr::new_delete_resource());
    EXPECT_GT(one.points.size(), 20u);
    EXPECT_EQ(one.points, other.points);
    EXPECT_EQ(one.edges, other.edges);
    EXPECT_EQ(one.offsets, other.offsets);
}

}  // namespace
}  // namespace flg::test
