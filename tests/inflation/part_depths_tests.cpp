// SPDX-License-Identifier: MIT
#include "inflation/part_depths.h"

#include <gtest/gtest.h>

#include "inflation/closed_mesh.h"
#include "inflation/crossing_triangles.h"
#include "inflation/models.h"

namespace flg::test {
namespace {

// Limbs on a body, all drawn in the plane z = 0.
struct Limbs {
    Limbs() {
        model.add({ellipse(0, 0, 1.5, 0.8)}, placement({0, 0, 0}), 0.8);
        model.chain({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}}, 0.7);
        hung.emplace_back();
    }
    // From where it hangs on the body.
    void add(const Point2& from, const Point2& to, double radius) {
        model.add({capsule(from.x, from.y, radius, to.x, to.y, radius)}, placement({0, 0, 0}), 0.75);
        model.chain({{from.x, from.y, 0}, {(from.x + to.x) / 2, (from.y + to.y) / 2, 0}, {to.x, to.y, 0}}, radius);
        const Vec3 at(from.x, from.y, 0);
        hung.push_back({.parent = 0, .joint = at, .bearing = at, .hold = 1});
    }
    PartDepths depths(bool haltingly = false) const {
        const DrawnParts drawn{model.parts, hung, model.bones, apart, 0.1};
        return made([&](Pace& pace) { return find_depths(pace, drawn); }, haltingly);
    }
    MergedMesh mesh(const PartDepths& found) {
        for (uint32_t p = 0; p < model.parts.size(); ++p) {
            model.parts[p].apart_from = found.apart_from(p);
            model.parts[p].lift = found.lift(p);
        }
        return merged(model, {.vertices = 8000});
    }

    Model model;
    std::vector<HungPart> hung;
    std::vector<std::array<uint32_t, 2>> apart;
};

Limbs crossed_legs() {
    Limbs limbs;
    limbs.add({-0.6, -0.4}, {0.7, -3}, 0.2);
    limbs.add({0.6, -0.4}, {-0.7, -3}, 0.2);
    return limbs;
}

double lift_at_end(const PartDepths& found, uint32_t part) {
    const PartLift* lift = found.lift(part);
    return lift ? lift->base + lift->rise : 0;
}

void expect_whole(const MergedMesh& mesh) {
    const ClosedMesh closed = check_closed(mesh.positions, {mesh.triangles.data(), mesh.triangles.size()});
    EXPECT_EQ(closed.fault, "");
    EXPECT_EQ(closed.components, 1u);
    EXPECT_EQ(closed.euler, 2) << "no limb is a handle";
    const std::span<const double> positions(mesh.positions.data()->data(), 3 * mesh.positions.size());
    const std::span<const uint32_t> triangles(mesh.triangles.data()->data(), 3 * mesh.triangles.size());
    EXPECT_EQ(crossing_triangles(positions, triangles).size(), 0u);
}

TEST(PartDepths, LimbsThatCrossPassInDrawingOrder) {
    Limbs limbs = crossed_legs();
    const PartDepths found = limbs.depths();
    EXPECT_EQ(found.lift(0), nullptr);
    // Both give way, by half the sum of their heights and the gap.
    const double height = 0.75 * std::sqrt(2.0) * 0.2;
    EXPECT_NEAR(lift_at_end(found, 2), height + 0.05, 0.03);
    EXPECT_NEAR(lift_at_end(found, 1), -lift_at_end(found, 2), 1e-9);
    ASSERT_EQ(found.apart_from(1).size(), 1u);
    EXPECT_EQ(found.apart_from(1)[0], 2u);
    EXPECT_EQ(found.apart_from(0).size(), 0u);
    expect_whole(limbs.mesh(found));
}

TEST(PartDepths, DepthThenPlaneThenOrderDecide) {
    Limbs limbs = crossed_legs();
    limbs.model.parts[1].placement = placement({0, 0, 0.01});
    EXPECT_GT(lift_at_end(limbs.depths(), 1), 0) << "its plane is in front";
    limbs.hung[2].depth = 1;
    EXPECT_LT(lift_at_end(limbs.depths(), 1), 0);
    expect_whole(limbs.mesh(limbs.depths()));
}

// A tail around to the front of the body that it hangs on.
TEST(PartDepths, LimbsPassInFrontOfWhatTheyHangOn) {
    Limbs limbs;
    limbs.model.add({{{1.2, 0},
                      {1.2, 0.3},
                      {2.4, 0.3},
                      {2.4, -1.3},
                      {-0.3, -1.3},
                      {-0.3, 0.4},
                      {0, 0.4},
                      {0, -1},
                      {2.1, -1},
                      {2.1, 0}}},
                    placement({0, 0, 0}), 0.75);
    limbs.model.chain({{1.3, 0.15, 0}, {2.25, 0.15, 0}, {2.25, -1.15, 0}, {-0.15, -1.15, 0}, {-0.15, 0.3, 0}}, 0.14);
    limbs.hung.push_back({.parent = 0, .joint = {1.3, 0.15, 0}, .bearing = {1, 0, 0}, .hold = 1});
    const PartDepths found = limbs.depths();
    EXPECT_GT(lift_at_end(found, 1), 0.8 * 0.8) << "in front of the body's height";
    EXPECT_EQ(found.apart_from(1).size(), 0u) << "they are joined where it hangs";
    expect_whole(limbs.mesh(found));
    limbs.hung[1].depth = -1;
    EXPECT_LT(lift_at_end(limbs.depths(), 1), -0.8 * 0.8);
}

TEST(PartDepths, LimbsOfSeveralRivals) {
    Limbs limbs;
    for (int i = -1; i <= 1; ++i) limbs.add({0.9 * i, -0.4}, {-0.9 * i, -3.6}, 0.14);
    const PartDepths found = limbs.depths();
    EXPECT_EQ(found.apart_from(1).size(), 2u);
    EXPECT_LT(lift_at_end(found, 1), lift_at_end(found, 2));
    EXPECT_LT(lift_at_end(found, 2), lift_at_end(found, 3));
    expect_whole(limbs.mesh(found));
}

// A fork: they only meet where they hang.
TEST(PartDepths, WhatDoesNotCrossStaysInItsPlane) {
    Limbs limbs;
    limbs.add({-0.2, -0.4}, {-0.8, -3}, 0.2);
    limbs.add({0.2, -0.4}, {0.8, -3}, 0.2);
    const PartDepths found = limbs.depths();
    for (uint32_t p = 0; p < 3; ++p) {
        EXPECT_EQ(found.lift(p), nullptr);
        EXPECT_EQ(found.apart_from(p).size(), 0u);
    }
    limbs.apart = {{1, 2}, {0, 1}};
    EXPECT_EQ(limbs.depths().apart_from(1).size(), 1u) << "but not from what it hangs on";
}

TEST(PartDepths, SameBitsWithPauses) {
    const Limbs limbs = crossed_legs();
    const PartDepths a = limbs.depths(), b = limbs.depths(true);
    for (uint32_t p = 1; p < 3; ++p) {
        EXPECT_EQ(a.lift(p)->base, b.lift(p)->base);
        EXPECT_EQ(a.lift(p)->rise, b.lift(p)->rise);
        EXPECT_EQ(a.lift(p)->reach, b.lift(p)->reach);
        EXPECT_TRUE(std::equal(a.lift(p)->ways.begin(), a.lift(p)->ways.end(), b.lift(p)->ways.begin()));
    }
}

}  // namespace
}  // namespace flg::test
