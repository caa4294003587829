// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "inflation/inflate_part.h"
#include "inflation/models.h"

namespace flg::test {
namespace {

struct Skinned {
    InflatedPart part{test_memory()};
    PartSurface surface;
    MergedMesh mesh;
    BoneWeights weights;
};

Skinned skinned(const Rings& rings, bool haltingly) {
    Skinned all;
    all.part.contour = contour_of(rings);
    made([&](Pace& pace) { return inflate_part(pace, {}, all.part); }, haltingly);
    all.surface = surface_of(all.part, haltingly);
    PlacedPart placed[1];
    placed[0].part = &all.part;
    all.mesh = made([&](Pace& pace) { return merge_parts(pace, placed, {.vertices = 1000}); }, haltingly);
    const BoneSegment bones[] = {{{-1, 0, 0}, {0, 0, 0}, 0.4, 0.4, 0, 0}, {{0, 0, 0}, {1, 0, 0}, 0.4, 0.4, 1, 0}};
    all.weights = made([&](Pace& pace) { return bone_weights(pace, all.mesh, placed, {bones}, {}); }, haltingly);
    return all;
}

TEST(InflatePart, TheSameInOneGoAndHaltingly) {
    const Rings rings = {capsule(-1, 0, 0.4, 1, 0, 0.4)};
    const Skinned a = skinned(rings, false), b = skinned(rings, true);
    EXPECT_GT(a.surface.positions.size(), 500u);
    EXPECT_NEAR(static_cast<double>(a.mesh.positions.size()), 1000, 150);
    ASSERT_EQ(a.mesh.positions.size(), a.weights.weights.size());
    EXPECT_TRUE(std::equal(a.surface.positions.begin(), a.surface.positions.end(), b.surface.positions.begin(),
                           b.surface.positions.end()));
    EXPECT_TRUE(
        std::equal(a.mesh.positions.begin(), a.mesh.positions.end(), b.mesh.positions.begin(), b.mesh.positions.end()));
    EXPECT_TRUE(std::equal(a.weights.weights.begin(), a.weights.weights.end(), b.weights.weights.begin(),
                           b.weights.weights.end()));
    // The two-sided mesh and the merged one are of the same body.
    double reach = 0, merged_reach = 0;
    for (const Vec3& p : a.surface.positions) reach = std::max(reach, p.z());
    for (const Vec3& p : a.mesh.positions) merged_reach = std::max(merged_reach, p.z());
    EXPECT_NEAR(reach, merged_reach, 0.01);
}

TEST(InflatePart, WhatIsWrongIsThrown) {
    EXPECT_THROW(skinned({{{0, 0}, {10, 8}, {10, 0}, {0, 10}}}, true), Failure);
}

}  // namespace
}  // namespace flg::test
