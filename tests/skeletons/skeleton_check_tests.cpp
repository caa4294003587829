// SPDX-License-Identifier: MIT
// The check that every result goes through, on results with something wrong: it finds what the tests' own one finds.
#include "skeletons/skeleton_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/run_now.h"
#include "skeletons/random_contours.h"

namespace flg::test {
namespace {

struct Box {
    std::vector<uint32_t> next;
    double size;
};

Box box_of(const Contour& contour) {
    Box box{{}, 0};
    Point2 low = contour.points[0], high = low;
    for (uint32_t i = 0; i < contour.size(); ++i) {
        const Point2& p = contour.points[i];
        box.next.push_back(contour.next(i));
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    box.size = std::hypot(high.x - low.x, high.y - low.y);
    return box;
}

bool passes(const Contour& contour, StraightSkeleton skeleton, bool haltingly = false) {
    const Box box = box_of(contour);
    Memory* memory = std::pmr::new_delete_resource();
    const auto check = [&](Pace& pace) {
        return can_be_straight_skeleton(pace, contour.points, box.next, contour.ring_count(), box.size, 0, skeleton,
                                        memory);
    };
    return run_now(memory, check, haltingly);
}

// Where three edges' lines are at one distance, if they are somewhere.
std::optional<SkeletonNode> equidistant(const Contour& contour, const std::array<uint32_t, 3>& edges) {
    double m[3][4];
    for (int i = 0; i < 3; ++i) {
        const Point2 &a = contour.points[edges[i]], &b = contour.points[contour.next(edges[i])];
        const double length = std::hypot(b.x - a.x, b.y - a.y), nx = (a.y - b.y) / length, ny = (b.x - a.x) / length;
        m[i][0] = nx;
        m[i][1] = ny;
        m[i][2] = -1;
        m[i][3] = nx * a.x + ny * a.y;
    }
    const auto determinant = [&](int p, int q, int r) {
        return m[0][p] * (m[1][q] * m[2][r] - m[1][r] * m[2][q]) - m[0][q] * (m[1][p] * m[2][r] - m[1][r] * m[2][p]) +
               m[0][r] * (m[1][p] * m[2][q] - m[1][q] * m[2][p]);
    };
    const double all = determinant(0, 1, 2);
    if (std::fabs(all) < 1e-6) return {};
    return SkeletonNode{{determinant(3, 1, 2) / all, determinant(0, 3, 2) / all}, determinant(0, 1, 3) / all};
}

uint32_t third_face(const StraightSkeleton& s, uint32_t node, const SkeletonArc& arc, int& arcs) {
    uint32_t third = ~0u;
    for (const SkeletonArc& other : s.arcs) {
        if (other.a != node && other.b != node) continue;
        ++arcs;
        for (const uint32_t face : {other.left, other.right}) {
            if (face != arc.left && face != arc.right) third = face;
        }
    }
    return third;
}

// The arc between two nodes of three arcs turned to part the two other faces: another roof over the same walls, whose
// nodes are as far from their lines as they say.
std::optional<StraightSkeleton> with_arc_flipped(const Contour& contour, const StraightSkeleton& s, uint32_t index) {
    const SkeletonArc arc = s.arcs[index];
    if (arc.a < contour.size()) return {};
    int arcs_a = 0, arcs_b = 0;
    const uint32_t at_a = third_face(s, arc.a, arc, arcs_a), at_b = third_face(s, arc.b, arc, arcs_b);
    if (arcs_a != 3 || arcs_b != 3 || at_a == ~0u || at_b == ~0u || at_a == at_b) return {};
    const auto left = equidistant(contour, {at_a, at_b, arc.left}),
               right = equidistant(contour, {at_a, at_b, arc.right});
    if (!left || !right || !(left->time > 0) || !(right->time > 0)) return {};
    // Node a becomes the one on the left, b the one on the right.
    StraightSkeleton out = s;
    out.nodes[arc.a] = *left;
    out.nodes[arc.b] = *right;
    for (SkeletonArc& other : out.arcs) {
        const bool is_lefts = other.left == arc.left || other.right == arc.left;
        for (uint32_t* end : {&other.a, &other.b}) {
            if (*end == arc.a || *end == arc.b) *end = is_lefts ? arc.a : arc.b;
        }
    }
    // From a the face of a is right of the way from the left node to the right one.
    out.arcs[index] = {arc.a, arc.b, at_b, at_a};
    for (SkeletonArc& other : out.arcs) {
        if (out.nodes[other.a].time <= out.nodes[other.b].time) continue;
        std::swap(other.a, other.b);
        std::swap(other.left, other.right);
    }
    out.face_offsets.clear();
    out.face_nodes.clear();
    for (uint32_t f = 0; f < contour.size(); ++f) {
        out.face_offsets.push_back(static_cast<uint32_t>(out.face_nodes.size()));
        for (uint32_t i = s.face_offsets[f]; i < s.face_offsets[f + 1]; ++i) {
            const uint32_t node = s.face_nodes[i];
            const bool is_end = node == arc.a || node == arc.b;
            if (is_end && (f == at_a || f == at_b)) {
                out.face_nodes.push_back(f == at_b ? arc.a : arc.b);
                out.face_nodes.push_back(f == at_b ? arc.b : arc.a);
            } else if (!is_end || node == (f == arc.left ? arc.a : arc.b)) {
                out.face_nodes.push_back(node);
            }
        }
    }
    out.face_offsets.push_back(static_cast<uint32_t>(out.face_nodes.size()));
    return out;
}

Rings drawn(uint64_t seed) {
    switch (seed % 4) {
        case 0: return random_star(seed, 24);
        case 1: return random_tour(seed, 30);
        case 2: return rotated(grid_tour(seed, 24, 9), 0.3);
        default: return star_with_holes(seed, 12, 2, 5);
    }
}

TEST(SkeletonCheck, GoodOnesPass) {
    for (uint64_t seed = 0; seed < 60; ++seed) {
        const Contour contour = contour_of(drawn(seed));
        const StraightSkeleton skeleton = skeleton_of(contour);
        EXPECT_TRUE(passes(contour, skeleton)) << seed;
        EXPECT_TRUE(passes(contour, skeleton, true)) << seed;
    }
}

TEST(SkeletonCheck, NodesThatMovedAreFound) {
    for (uint64_t seed = 0; seed < 20; ++seed) {
        const Contour contour = contour_of(drawn(seed));
        const StraightSkeleton good = skeleton_of(contour);
        const double reach = 1e-5 * box_of(contour).size;
        for (uint32_t i = contour.size(); i < good.nodes.size(); ++i) {
            StraightSkeleton moved = good, later = good;
            moved.nodes[i].at.x += reach;
            moved.nodes[i].at.y -= reach;
            later.nodes[i].time += reach;
            EXPECT_FALSE(passes(contour, moved)) << seed << ", node " << i;
            EXPECT_FALSE(passes(contour, later)) << seed << ", node " << i;
        }
    }
}

// Other roofs, some of which only the rule of how the front goes on tells apart.
TEST(SkeletonCheck, OtherRoofsAreFound) {
    int roofs = 0, by_front = 0;
    for (uint64_t seed = 0; seed < 120; ++seed) {
        const Contour contour = contour_of(drawn(seed));
        const StraightSkeleton good = skeleton_of(contour);
        for (uint32_t arc = 0; arc < good.arcs.size(); ++arc) {
            const auto flipped = with_arc_flipped(contour, good, arc);
            if (!flipped) continue;
            const auto broken = broken_invariants(contour, *flipped);
            if (broken.empty()) continue;  // two arcs that are nearly one point
            ++roofs;
            by_front +=
                std::all_of(broken.begin(), broken.end(), [](const std::string& b) { return b.starts_with("I7"); });
            EXPECT_FALSE(passes(contour, *flipped)) << seed << ", arc " << arc << ": " << joined(broken);
        }
    }
    EXPECT_GT(roofs, 500);
    EXPECT_GT(by_front, 20);
}

// A rectangle's skeleton with a node more in the lower face, on the middle of the ridge bent down to that height.
StraightSkeleton with_bent_ridge(const Contour& rectangle, double height) {
    const StraightSkeleton good = skeleton_of(rectangle);
    StraightSkeleton bent = good;
    const auto added = static_cast<uint32_t>(good.nodes.size());
    bent.nodes.push_back({{4, height}, height});
    bent.arcs.push_back(bent.arcs.back());  // as many as so many nodes ask for
    bent.face_nodes.clear();
    bent.face_offsets.clear();
    for (uint32_t f = 0; f < 4; ++f) {
        bent.face_offsets.push_back(static_cast<uint32_t>(bent.face_nodes.size()));
        for (uint32_t i = good.face_offsets[f]; i < good.face_offsets[f + 1]; ++i) {
            bent.face_nodes.push_back(good.face_nodes[i]);
            const bool is_ridge = i + 1 < good.face_offsets[f + 1] && good.face_nodes[i] >= 4;
            if (f == 0 && is_ridge) bent.face_nodes.push_back(added);
        }
    }
    bent.face_offsets.push_back(static_cast<uint32_t>(bent.face_nodes.size()));
    return bent;
}

// A face that meets itself in one point, as a front edge makes that did not vanish: nothing else is wrong with it.
TEST(SkeletonCheck, PinchedFacesAreFound) {
    const Contour contour = contour_of({{{0, 0}, {8, 0}, {8, 2}, {0, 2}}});
    EXPECT_TRUE(passes(contour, with_bent_ridge(contour, 1e-3)));
    EXPECT_TRUE(passes(contour, with_bent_ridge(contour, 1e-10)));
    EXPECT_FALSE(passes(contour, with_bent_ridge(contour, 1e-14)));
}

}  // namespace
}  // namespace flg::test
