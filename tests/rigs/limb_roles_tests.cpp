// SPDX-License-Identifier: MIT
// Limbs of figures whose limbs are known, from the front and from the side, in any place, size and order of joints.
#include <gtest/gtest.h>

#include "rigs/figures.h"

namespace flg::test {
namespace {

void expect_limb(const FigureRig& rig, const std::string& name, FlgLimb limb, int32_t side = 0, uint32_t pair = 0) {
    EXPECT_EQ(rig.joint(name).limb, limb) << name;
    EXPECT_EQ(rig.joint(name).side, side) << name;
    EXPECT_EQ(rig.joint(name).pair, pair) << name;
}

void expect_human(const FigureRig& rig) {
    for (const char* name : {"hips", "spine_0", "spine_1"}) expect_limb(rig, name, FLG_LIMB_TRUNK);
    expect_limb(rig, "head_0", FLG_LIMB_NECK);
    expect_limb(rig, "head_1", FLG_LIMB_HEAD);
    for (int i = 0; i < 4; ++i) {
        const std::string number = std::to_string(i);
        expect_limb(rig, "arm.L_" + number, FLG_LIMB_ARM, 1);
        expect_limb(rig, "arm.R_" + number, FLG_LIMB_ARM, -1);
        expect_limb(rig, "leg.L_" + number, FLG_LIMB_LEG, 1);
        expect_limb(rig, "leg.R_" + number, FLG_LIMB_LEG, -1);
        EXPECT_EQ(rig.joint("leg.L_" + number).index, static_cast<uint32_t>(i));
    }
}

TEST(LimbRoles, AHumanFromTheFront) {
    const FigureRig rig(human());
    EXPECT_TRUE(rig.frame.left.isApprox(Vec3::UnitX()));
    EXPECT_TRUE(rig.frame.forward.isApprox(Vec3::UnitZ()));
    EXPECT_NEAR(rig.frame.ground, 0.02 - 0.06, 1e-12);
    expect_human(rig);
    EXPECT_EQ(rig.joint("leg.L_0").place, FLG_LIMB_PLACE_UPPER);
    EXPECT_EQ(rig.joint("leg.L_1").place, FLG_LIMB_PLACE_MIDDLE);
    EXPECT_EQ(rig.joint("leg.L_2").place, FLG_LIMB_PLACE_END);
    EXPECT_EQ(rig.joint("leg.L_3").place, FLG_LIMB_PLACE_NONE);
    EXPECT_EQ(rig.joint("arm.R_2").place, FLG_LIMB_PLACE_END);
}

// One arm up, the other one bent: no mirror images of each other.
TEST(LimbRoles, ArmsThatPointToDifferentPlaces) {
    Figure waves = human();
    waves.at[waves.find("arm.L_1")] = {0.4, 1.6, 0};
    waves.at[waves.find("arm.L_2")] = {0.45, 1.9, 0};
    waves.at[waves.find("arm.L_3")] = {0.47, 1.97, 0};
    waves.at[waves.find("arm.R_2")] = {-0.25, 1.1, 0};
    waves.at[waves.find("arm.R_3")] = {-0.18, 1.08, 0};
    expect_human(FigureRig(waves));
}

// Ears that are longer than the arms.
TEST(LimbRoles, EarsAreNoArms) {
    Figure rabbit = human();
    rabbit.add_pair("ear", rabbit.find("head_1"), {{0.1, 1.9, 0}, {0.2, 2.4, 0}, {0.3, 2.9, 0}}, 0.03);
    const FigureRig rig(rabbit);
    for (const char* name : {"hips", "spine_0", "spine_1"}) expect_limb(rig, name, FLG_LIMB_TRUNK);
    expect_limb(rig, "head_1", FLG_LIMB_HEAD);
    expect_limb(rig, "arm.L_2", FLG_LIMB_ARM, 1);
    expect_limb(rig, "arm.R_2", FLG_LIMB_ARM, -1);
    expect_limb(rig, "ear.L_2", FLG_LIMB_OTHER, 1);
}

// Hands on the hips, and hands crossed over the chest.
TEST(LimbRoles, ArmsThatBendBackToTheMiddle) {
    for (const double hand : {0.05, -0.15}) {
        Figure bent = human();
        for (const std::string side : {".L", ".R"}) {
            const double way = bent.at[bent.find("arm" + side + "_0")].x() > 0 ? 1 : -1;
            bent.at[bent.find("arm" + side + "_1")] = {0.45 * way, 1.2, 0.05};
            bent.at[bent.find("arm" + side + "_2")] = {(hand + 0.1) * way, 1.1, 0.2};
            bent.at[bent.find("arm" + side + "_3")] = {hand * way, 1.1, 0.2};
        }
        expect_human(FigureRig(bent));
    }
}

TEST(LimbRoles, NeitherPlaceNorSizeNorTheOrderOfChildrenMatters) {
    Figure moved = human();
    for (Vec3& place : moved.at) place = 1e-3 * place + Vec3(7, -3, 2);
    for (double& radius : moved.radii) radius *= 1e-3;
    expect_human(FigureRig(moved));
    // Legs before arms, right before left.
    const Figure whole = human();
    Figure other;
    std::vector<uint32_t> numbers(whole.at.size());
    for (const char* prefix : {"hips", "leg.R", "leg.L", "spine", "arm.R", "arm.L", "head"})
        for (uint32_t j = 0; j < whole.at.size(); ++j) {
            if (!whole.names[j].starts_with(prefix)) continue;
            const uint32_t parent = whole.parents[j];
            numbers[j] = other.add(whole.names[j], whole.at[j], parent == FLG_NO_INDEX ? parent : numbers[parent],
                                   whole.radii[j]);
        }
    expect_human(FigureRig(other));
}

TEST(LimbRoles, AQuadruped) {
    const FigureRig rig(quadruped(), Vec3::UnitX());
    for (const char* name : {"root", "shoulders", "croup"}) expect_limb(rig, name, FLG_LIMB_TRUNK);
    expect_limb(rig, "head_0", FLG_LIMB_NECK);
    expect_limb(rig, "head_1", FLG_LIMB_HEAD);
    expect_limb(rig, "head_2", FLG_LIMB_HEAD);
    expect_limb(rig, "ear.L_0", FLG_LIMB_OTHER, 1);
    expect_limb(rig, "tail_2", FLG_LIMB_TAIL);
    expect_limb(rig, "front.L_2", FLG_LIMB_LEG, 1, 0);
    expect_limb(rig, "front.R_0", FLG_LIMB_LEG, -1, 0);
    expect_limb(rig, "hind.L_2", FLG_LIMB_LEG, 1, 1);
    expect_limb(rig, "hind.R_0", FLG_LIMB_LEG, -1, 1);
}

TEST(LimbRoles, SixAndEightLegs) {
    for (const uint32_t pairs : {3u, 4u}) {
        const FigureRig rig(spider(pairs), Vec3::UnitX());
        EXPECT_EQ(rig.rig().view.leg_count, 2 * pairs);
        for (uint32_t p = 0; p < pairs; ++p) {
            expect_limb(rig, "leg" + std::to_string(p) + ".L_1", FLG_LIMB_LEG, 1, p);
            expect_limb(rig, "leg" + std::to_string(p) + ".R_1", FLG_LIMB_LEG, -1, p);
        }
        expect_limb(rig, "head_0", FLG_LIMB_HEAD);
    }
}

TEST(LimbRoles, FromTheSideItLooksWhereItsHeadIs) {
    const FigureRig rig(side_view());
    EXPECT_TRUE(rig.frame.forward.isApprox(-Vec3::UnitX())) << rig.frame.forward.transpose();
    expect_limb(rig, "front.L_1", FLG_LIMB_LEG, 0, 0);
    expect_limb(rig, "hind.L_1", FLG_LIMB_LEG, 0, 1);
    expect_limb(rig, "head_1", FLG_LIMB_HEAD);
    expect_limb(rig, "tail_1", FLG_LIMB_TAIL);
}

TEST(LimbRoles, WhatHasNoLimbsHasNone) {
    Figure one;
    one.add("only", {1, 2, 3}, FLG_NO_INDEX);
    expect_limb(FigureRig(one), "only", FLG_LIMB_TRUNK);
    Figure worm;
    worm.add_path("worm", worm.add("root", {0, 0, 0}, FLG_NO_INDEX), {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    const FigureRig rig(worm);
    EXPECT_EQ(rig.rig().view.leg_count, 0u);
    EXPECT_EQ(rig.rig().view.arm_count, 0u);
}

TEST(LimbRoles, OtherTreesAreOther) {
    Figure two = human();
    two.add_path("stone", two.add("stone", {3, 0, 0}, FLG_NO_INDEX), {{3, 0.1, 0}});
    const FigureRig rig(two);
    expect_human(rig);
    EXPECT_EQ(rig.joint("stone").limb, FLG_LIMB_OTHER);
    EXPECT_EQ(rig.joint("stone_0").limb, FLG_LIMB_OTHER);
}

TEST(LimbRoles, JointsInOnePlaceAreNoTrouble) {
    Figure heap;
    heap.add_path("heap", heap.add("root", {0, 0, 0}, FLG_NO_INDEX, 0), std::vector<Vec3>(5, Vec3::Zero()), 0);
    const FigureRig rig(heap);
    for (const FlgRigJoint& joint : rig.joints) {
        EXPECT_NEAR(load_vec3(joint.limit_axis).norm(), 1, 1e-6);
        EXPECT_EQ(joint.capsule_radius, 0);
    }
}

}  // namespace
}  // namespace flg::test
