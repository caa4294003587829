// SPDX-License-Identifier: MIT
// Axes of shapes: trees inside of them, and the slices across.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "api/drawings.h"
#include "bones/axis_stubs.h"
#include "bones/parts.h"

namespace flg::test {
namespace {

const Rings rectangle = {{{0, 0}, {10, 0}, {10, 2}, {0, 2}}};

uint32_t degree(const AxisGraph& graph, uint32_t node) {
    uint32_t arcs = 0;
    for (const auto& arc : graph.arcs) arcs += (arc[0] == node) + (arc[1] == node);
    return arcs;
}

bool is_connected(const AxisGraph& graph) {
    std::vector<uint32_t> root(graph.nodes.size());
    std::iota(root.begin(), root.end(), 0);
    const auto find = [&](uint32_t n) {
        while (root[n] != n) n = root[n];
        return n;
    };
    for (const auto& arc : graph.arcs) root[find(arc[0])] = find(arc[1]);
    for (uint32_t n = 0; n < graph.nodes.size(); ++n)
        if (find(n) != find(0)) return false;
    return true;
}

TEST(AxisGraph, OfARectangleIsItsRidge) {
    const Contour contour = contour_of(rectangle);
    const AxisGraph graph = axis_of(contour, skeleton_of(contour));
    ASSERT_EQ(graph.nodes.size(), 2u);
    ASSERT_EQ(graph.arcs.size(), 1u);
    const double left = std::min(graph.nodes[0].at.x, graph.nodes[1].at.x);
    EXPECT_NEAR(left, 1, 1e-12);
    EXPECT_NEAR(graph.nodes[0].at.x + graph.nodes[1].at.x, 10, 1e-12);
    for (const AxisNode& node : graph.nodes) {
        EXPECT_NEAR(node.at.y, 1, 1e-12);
        EXPECT_NEAR(node.clearance, 1, 1e-12);
    }
}

TEST(AxisGraph, OfATriangleIsANode) {
    const Contour contour = contour_of({{{0, 0}, {2, 0}, {1, std::sqrt(3.0)}}});
    const AxisGraph graph = axis_of(contour, skeleton_of(contour));
    ASSERT_EQ(graph.nodes.size(), 1u);
    EXPECT_TRUE(graph.arcs.empty());
    EXPECT_NEAR(graph.nodes[0].clearance, 1 / std::sqrt(3.0), 1e-12);  // the incircle
}

AxisGraph without_stubs_of(const Contour& contour, bool haltingly) {
    const AxisGraph graph = axis_of(contour, skeleton_of(contour));
    return run_now(
        memory(), [&](Pace& pace) { return without_stubs(pace, contour, graph); }, haltingly);
}

// A skirt, with a foot on either side: the axis leads to both feet, and to no corner of the hem.
TEST(AxisStubs, CornersBesideALimbAreNone) {
    Rings rings(1);
    for (const auto& [x, y] : person_in_a_skirt()) rings[0].push_back({x, y});
    const Contour gown = contour_of(rings);
    const auto reaches = [](const AxisGraph& graph, auto is_there) {
        return std::any_of(graph.nodes.begin(), graph.nodes.end(), [&](const AxisNode& n) { return is_there(n.at); });
    };
    const auto is_corner = [](const Point2& p) { return std::abs(p.x) > 0.25 && p.y < 0.5; };
    const auto is_foot = [](const Point2& p) { return p.y < 0.1; };
    ASSERT_TRUE(reaches(axis_of(gown, skeleton_of(gown)), is_corner));
    for (const bool haltingly : {false, true}) {
        const AxisGraph graph = without_stubs_of(gown, haltingly);
        EXPECT_FALSE(reaches(graph, is_corner));
        EXPECT_TRUE(reaches(graph, is_foot));
        EXPECT_TRUE(is_connected(graph));
        EXPECT_EQ(graph.arcs.size() + 1, graph.nodes.size());
    }
}

// A palm with two fingers, and a short straight edge between them.
TEST(AxisStubs, ValleysBetweenLimbsAreNone) {
    const Contour palm = contour_of({{{-3, -6}, {3, -6}, {3, 9}, {0.4, 9}, {0.25, 0}, {-0.25, 0}, {-0.4, 9}, {-3, 9}}});
    const AxisGraph graph = without_stubs_of(palm, false);
    for (uint32_t n = 0; n < graph.nodes.size(); ++n) {
        const Point2& at = graph.nodes[n].at;
        EXPECT_FALSE(degree(graph, n) == 1 && std::abs(at.x) < 0.5 && at.y > -1.5) << at.x << " " << at.y;
    }
    EXPECT_TRUE(is_connected(graph));
}

TEST(AxisStubs, ShapesWithoutLimbsKeepTheirAxis) {
    for (const Rings& rings : {rectangle, Rings{{{0, 0}, {4, 0}, {0, 3}}}}) {
        const Contour contour = contour_of(rings);
        EXPECT_EQ(without_stubs_of(contour, false).nodes.size(), axis_of(contour, skeleton_of(contour)).nodes.size());
    }
}

TEST(AxisGraph, GoesIntoSharpTips) {
    // An ear: the incircle of 3, 4, 5 has radius 1, and only the way to (4, 0) is longer than 2.5.
    const Contour ear = contour_of({{{0, 0}, {4, 0}, {0, 3}}});
    const AxisGraph graph = axis_of(ear, skeleton_of(ear));
    ASSERT_EQ(graph.nodes.size(), 2u);
    EXPECT_NEAR(graph.nodes[1].at.x, 1 + 0.75 * 3, 1e-12);
    EXPECT_NEAR(graph.nodes[1].at.y, 0.25, 1e-12);
    EXPECT_NEAR(graph.nodes[1].clearance, 0.25, 1e-12);
}

TEST(AxisGraph, IsATreeInsideOfTheShapeAlsoWithHoles) {
    for (const Contour& contour : some_contours()) {
        const StraightSkeleton skeleton = skeleton_of(contour);
        for (const double collapse : {0.0, 0.5, 3.0}) {
            const AxisGraph graph = axis_of(contour, skeleton, collapse);
            ASSERT_EQ(graph.arcs.size() + 1, graph.nodes.size());
            ASSERT_TRUE(is_connected(graph));
            if (skeleton.perturbation > 0) continue;
            for (const auto& arc : graph.arcs) {
                const AxisNode &a = graph.nodes[arc[0]], &b = graph.nodes[arc[1]];
                ASSERT_TRUE(is_in_shape(contour, a.at, b.at));
            }
        }
    }
}

TEST(AxisGraph, ShortArcsVanishAndOthersStay) {
    for (const Contour& contour : some_contours()) {
        const StraightSkeleton skeleton = skeleton_of(contour);
        const AxisGraph all = axis_of(contour, skeleton, 0), some = axis_of(contour, skeleton, 0.5);
        EXPECT_LE(some.nodes.size(), all.nodes.size());
        // Every node that is left was there before: nothing is moved.
        for (const AxisNode& node : some.nodes) {
            EXPECT_TRUE(
                std::any_of(all.nodes.begin(), all.nodes.end(), [&](const AxisNode& n) { return n.at == node.at; }));
        }
    }
    // Of a long shape's arcs none is as short as half of the mean.
    const Contour comb_like = contour_of(comb(9, 0.1));
    const AxisGraph graph = axis_of(comb_like, skeleton_of(comb_like));
    double sum = 0;
    for (const auto& arc : graph.arcs) sum += distance(graph.nodes[arc[0]].at, graph.nodes[arc[1]].at);
    for (const auto& arc : graph.arcs)
        EXPECT_GT(distance(graph.nodes[arc[0]].at, graph.nodes[arc[1]].at), 0.2 * sum / graph.arcs.size());
}

TEST(AxisGraph, TheWayAroundAHoleIsCutWhereItIsNarrow) {
    // A frame that is narrow on its right.
    const Contour contour = contour_of({{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{3, 3}, {9.5, 3}, {9.5, 7}, {3, 7}}});
    const AxisGraph graph = axis_of(contour, skeleton_of(contour), 0);
    EXPECT_TRUE(is_connected(graph));
    for (const auto& arc : graph.arcs) {
        const AxisNode &a = graph.nodes[arc[0]], &b = graph.nodes[arc[1]];
        EXPECT_FALSE(a.clearance < 0.26 && b.clearance < 0.26) << "the narrow side is not crossed";
    }
}

TEST(AxisBranches, SlicesOfARectangleReachItsSides) {
    const PartSkeleton part = part_of(contour_of(rectangle), 0.5);
    ASSERT_EQ(part.branches.size(), 1u);
    const std::vector<AxisSample> samples = samples_of(part, 0);
    ASSERT_EQ(samples.size(), 17u);
    for (size_t i = 0; i < samples.size(); ++i) {
        EXPECT_NEAR(std::abs(samples[i].at.x - samples[0].at.x), 0.5 * static_cast<double>(i), 1e-9);
        EXPECT_NEAR(samples[i].left, 1, 1e-9);
        EXPECT_NEAR(samples[i].right, 1, 1e-9);
        EXPECT_NEAR(samples[i].left_of.x, 0, 1e-12);
    }
}

TEST(AxisBranches, AStarHasABranchForEachTip) {
    const PartSkeleton sharp = part_of(contour_of(even_star(5, 0.3)), 0.02);
    EXPECT_EQ(sharp.branches.size(), 5u);
    // Blunt ones too.
    Rings blunt(1);
    for (int i = 0; i < 5; ++i) {
        const auto at = [&](double radius, double turn) {
            const double angle = 2 * M_PI * (i + turn) / 5;
            blunt[0].push_back({radius * std::cos(angle), radius * std::sin(angle)});
        };
        at(1, -0.02);
        at(1, 0.02);
        at(0.25, 0.5);
    }
    const PartSkeleton five = part_of(contour_of(blunt), 0.02);
    EXPECT_EQ(five.branches.size(), 5u);
    uint32_t ends = 0;
    for (uint32_t n = 0; n < five.graph.nodes.size(); ++n) ends += degree(five.graph, n) == 1;
    EXPECT_EQ(ends, 5u);
}

// No two edges are parallel.
bool is_generic(const Contour& contour) {
    std::vector<double> directions;
    for (uint32_t i = 0; i < contour.size(); ++i) {
        const Point2 &a = contour.points[i], &b = contour.points[contour.next(i)];
        directions.push_back(std::fmod(std::atan2(b.y - a.y, b.x - a.x) + 2 * M_PI, M_PI));
    }
    std::sort(directions.begin(), directions.end());
    for (size_t i = 1; i < directions.size(); ++i)
        if (directions[i] - directions[i - 1] < 1e-9) return false;
    return true;
}

TEST(AxisBranches, CoverTheGraphAndStayInTheShape) {
    size_t slices = 0;
    for (const Contour& contour : some_contours()) {
        const double size = size_of(contour);
        if (skeleton_of(contour).perturbation > 0) continue;
        const PartSkeleton part = part_of(contour, 0.01 * size);
        uint32_t ends = 0;
        for (uint32_t n = 0; n < part.graph.nodes.size(); ++n) {
            const uint32_t d = degree(part.graph, n);
            ends += d == 2 ? 0 : d;
        }
        ASSERT_EQ(ends, 2 * part.branches.size());
        for (size_t b = 0; b < part.branches.size(); ++b) {
            const AxisBranch& branch = part.branches[b];
            const std::vector<AxisSample> samples = samples_of(part, b);
            ASSERT_GE(samples.size(), 2u);
            ASSERT_EQ(samples.front().at, part.graph.nodes[branch.from].at);
            ASSERT_EQ(samples.back().at, part.graph.nodes[branch.to].at);
            for (size_t i = 0; i < samples.size(); ++i) {
                const AxisSample& s = samples[i];
                ASSERT_GT(s.left, 0);
                ASSERT_GT(s.right, 0);
                ASSERT_NEAR(std::hypot(s.left_of.x, s.left_of.y), 1, 1e-12);
                const Point2 left = {s.at.x + 0.999 * s.left * s.left_of.x, s.at.y + 0.999 * s.left * s.left_of.y};
                const Point2 right = {s.at.x - 0.999 * s.right * s.left_of.x, s.at.y - 0.999 * s.right * s.left_of.y};
                // (Slices may touch a corner of shapes on a grid.)
                if (contour.ring_count() == 1 && is_generic(contour)) {
                    ASSERT_TRUE(is_in_shape(contour, right, left));
                    ++slices;
                }
                if (i == 0) continue;
                ASSERT_TRUE(is_in_shape(contour, samples[i - 1].at, s.at));
                ASSERT_LT(distance(samples[i - 1].at, s.at), 0.0101 * size);
            }
        }
    }
    EXPECT_GT(slices, 5000u);
}

TEST(AxisBranches, SameBitsWithPauses) {
    for (const Rings& rings : {random_tour(4, 150), pixel_shape(2, 14, true)}) {
        const Contour contour = contour_of(rings);
        const PartSkeleton whole = part_of(contour, 0.05, 0.5), paused = part_of(contour, 0.05, 0.5, true);
        ASSERT_EQ(whole.samples.size(), paused.samples.size());
        for (size_t i = 0; i < whole.samples.size(); ++i) {
            ASSERT_EQ(whole.samples[i].at, paused.samples[i].at);
            ASSERT_EQ(whole.samples[i].left, paused.samples[i].left);
        }
    }
}

TEST(AxisBranches, TurnWithTheShape) {
    const Rings rings = random_star(8, 40);
    const PartSkeleton part = part_of(contour_of(rings), 0.02);
    const double angle = 0.7, scale = 1e6;
    const PartSkeleton turned = part_of(contour_of(rotated(rings, angle, scale)), 0.02 * scale);
    ASSERT_EQ(part.branches.size(), turned.branches.size());
    ASSERT_EQ(part.samples.size(), turned.samples.size());
    // Branches may come in another order, and the other way around.
    for (const AxisSample& s : part.samples) {
        const Point2 at = {scale * (std::cos(angle) * s.at.x - std::sin(angle) * s.at.y),
                           scale * (std::sin(angle) * s.at.x + std::cos(angle) * s.at.y)};
        const auto is_same = [&](const AxisSample& t) {
            const bool same_sides = std::abs(t.left - scale * s.left) + std::abs(t.right - scale * s.right) < 1e-4;
            const bool other_sides = std::abs(t.left - scale * s.right) + std::abs(t.right - scale * s.left) < 1e-4;
            return distance(t.at, at) < 1e-5 && (same_sides || other_sides);
        };
        EXPECT_TRUE(std::any_of(turned.samples.begin(), turned.samples.end(), is_same));
    }
}

}  // namespace
}  // namespace flg::test
