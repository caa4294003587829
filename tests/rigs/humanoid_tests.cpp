// SPDX-License-Identifier: MIT
// Names of humanoids, why something is none, and T-poses.
#include <gtest/gtest.h>

#include <map>

#include "core/failure.h"
#include "rigs/figures.h"
#include "rigs/humanoid.h"

namespace flg::test {
namespace {

std::map<std::string, std::string> names_of(const Figure& figure, FlgRigStandard standard) {
    const FigureRig rig(figure);
    std::vector<const char*> names(figure.at.size(), "not set");
    name_humanoid(rig.rig(), standard, names.data());
    std::map<std::string, std::string> found;
    for (uint32_t j = 0; j < names.size(); ++j)
        if (names[j]) found[figure.names[j]] = names[j];
    return found;
}

std::string refusal(const Figure& figure) {
    try {
        names_of(figure, FLG_RIG_STANDARD_VRM);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "";
}

TEST(Humanoid, NamesOfVrm) {
    const std::map<std::string, std::string> expected = {{"hips", "hips"},
                                                         {"spine_0", "spine"},
                                                         {"spine_1", "chest"},
                                                         {"head_0", "neck"},
                                                         {"head_1", "head"},
                                                         {"arm.L_0", "leftUpperArm"},
                                                         {"arm.L_1", "leftLowerArm"},
                                                         {"arm.L_2", "leftHand"},
                                                         {"arm.R_0", "rightUpperArm"},
                                                         {"arm.R_1", "rightLowerArm"},
                                                         {"arm.R_2", "rightHand"},
                                                         {"leg.L_0", "leftUpperLeg"},
                                                         {"leg.L_1", "leftLowerLeg"},
                                                         {"leg.L_2", "leftFoot"},
                                                         {"leg.L_3", "leftToes"},
                                                         {"leg.R_0", "rightUpperLeg"},
                                                         {"leg.R_1", "rightLowerLeg"},
                                                         {"leg.R_2", "rightFoot"},
                                                         {"leg.R_3", "rightToes"}};
    EXPECT_EQ(names_of(human(), FLG_RIG_STANDARD_VRM), expected);
}

TEST(Humanoid, NamesOfUnityAndUnreal) {
    auto unity = names_of(human(), FLG_RIG_STANDARD_UNITY);
    EXPECT_EQ(unity["hips"], "Hips");
    EXPECT_EQ(unity["leg.R_1"], "RightLowerLeg");
    auto unreal = names_of(human(), FLG_RIG_STANDARD_UNREAL);
    EXPECT_EQ(unreal["hips"], "pelvis");
    EXPECT_EQ(unreal["spine_1"], "spine_02");
    EXPECT_EQ(unreal["arm.L_0"], "upperarm_l");
    EXPECT_EQ(unreal["leg.R_3"], "ball_r");
}

TEST(Humanoid, LongSpinesNameTheFirstJointsAndTheLast) {
    Figure tall = human();
    const uint32_t first = tall.find("spine_0");
    // Two more between them.
    Figure f;
    std::vector<uint32_t> numbers(tall.at.size());
    for (uint32_t j = 0; j < tall.at.size(); ++j) {
        uint32_t parent = tall.parents[j] == FLG_NO_INDEX ? FLG_NO_INDEX : numbers[tall.parents[j]];
        if (tall.names[j] == "spine_1") parent = f.add_path("more", numbers[first], {{0, 1.28, 0}, {0, 1.36, 0}}, 0.15);
        numbers[j] = f.add(tall.names[j], tall.at[j], parent, tall.radii[j]);
    }
    auto names = names_of(f, FLG_RIG_STANDARD_UNITY);
    EXPECT_EQ(names["spine_0"], "Spine");
    EXPECT_EQ(names["more_0"], "Chest");
    EXPECT_EQ(names.count("more_1"), 0u);
    EXPECT_EQ(names["spine_1"], "UpperChest");
    EXPECT_EQ(names_of(f, FLG_RIG_STANDARD_UNREAL)["spine_1"], "spine_04");
}

// Without what begins so.
Figure without(const Figure& whole, const std::string& prefix) {
    Figure f;
    std::vector<uint32_t> numbers(whole.at.size(), FLG_NO_INDEX);
    for (uint32_t j = 0; j < whole.at.size(); ++j) {
        if (whole.names[j].starts_with(prefix)) continue;
        const uint32_t parent = whole.parents[j];
        numbers[j] =
            f.add(whole.names[j], whole.at[j], parent == FLG_NO_INDEX ? parent : numbers[parent], whole.radii[j]);
    }
    return f;
}

TEST(Humanoid, SaysWhatIsMissing) {
    EXPECT_EQ(refusal(human()), "");
    EXPECT_EQ(refusal(quadruped()), "no humanoid: it has 4 legs");
    EXPECT_EQ(refusal(spider(3)), "no humanoid: it has 6 legs");
    EXPECT_EQ(refusal(side_view()), "no humanoid: its legs do not stand side by side");
    EXPECT_EQ(refusal(without(human(), "leg.R")), "no humanoid: it has 1 leg");
    EXPECT_EQ(refusal(without(human(), "arm")), "no humanoid: it has no pair of arms");
    EXPECT_EQ(refusal(without(human(), "head")), "no humanoid: it has no head");
    Figure stiff = human();
    stiff = without(without(stiff, "leg.L_3"), "leg.L_2");
    EXPECT_NE(refusal(stiff), "");
}

// The same skeleton from the chest on: engines would turn the legs with the spine.
TEST(Humanoid, SaysThatItsHipsAreToBeTheRoot) {
    Figure f;
    const uint32_t chest = f.add("chest", {0, 1.45, 0}, FLG_NO_INDEX, 0.15);
    const uint32_t spine = f.add("spine", {0, 1.2, 0}, chest, 0.15), hips = f.add("hips", {0, 1, 0}, spine, 0.15);
    f.add_path("head", chest, {{0, 1.55, 0}, {0, 1.7, 0}}, 0.08);
    f.add_pair("arm", chest, {{0.2, 1.4, 0}, {0.45, 1.25, 0}, {0.65, 1.05, 0}, {0.7, 1.0, 0}}, 0.04);
    f.add_pair("leg", hips, {{0.12, 0.95, 0}, {0.12, 0.5, 0.02}, {0.12, 0.08, 0}, {0.12, 0.02, 0.12}}, 0.06);
    EXPECT_EQ(refusal(f),
              "no humanoid: its legs hang below its arms: joint 2, where the legs meet, has to be the root");
}

TEST(Humanoid, InATPoseArmsAreLevelAndTheRestStays) {
    const FigureRig rig(human());
    const uint32_t count = rig.rig().count();
    std::vector<float> rotations(4 * count);
    pose_t(rig.rig(), rotations.data());
    std::vector<JointMotion> motions(count);
    pose_joints(rig.positions.data(), rig.figure.parents.data(), rotations.data(), nullptr, motions);
    const auto posed = [&](const std::string& name) {
        const uint32_t j = rig.figure.find(name);
        return Vec3(motions[j].rotation * rig.figure.at[j] + motions[j].translation);
    };
    for (const char* side : {"L", "R"}) {
        const std::string arm = std::string("arm.") + side + "_";
        const double sign = side[0] == 'L' ? 1 : -1;
        EXPECT_TRUE(posed(arm + "0").isApprox(rig.figure.at[rig.figure.find(arm + "0")], 1e-6));
        for (int i = 1; i < 4; ++i) {
            const Vec3 way = posed(arm + std::to_string(i)) - posed(arm + std::to_string(i - 1));
            EXPECT_NEAR(way.normalized().x(), sign, 1e-6);
        }
    }
    EXPECT_TRUE(posed("leg.L_3").isApprox(rig.figure.at[rig.figure.find("leg.L_3")], 1e-6));
    // A palm that faces the hips of a hanging arm faces down: what pointed inwards at right angles to it does.
    const Quaternion hand = motions[rig.figure.find("arm.L_2")].rotation;
    const Vec3 bone =
        (rig.figure.at[rig.figure.find("arm.L_3")] - rig.figure.at[rig.figure.find("arm.L_2")]).normalized();
    const Vec3 palm = bone.cross(Vec3::UnitZ());
    EXPECT_NEAR((hand * palm).y(), -1, 1e-6) << (hand * palm).transpose();
}

}  // namespace
}  // namespace flg::test
