// SPDX-License-Identifier: MIT
// Capsules and limits: where they must be by closed forms, and alike on both sides.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "rigs/figures.h"
#include "rigs/limits.h"

namespace flg::test {
namespace {

const std::vector<Figure>& figures() {
    static const std::vector<Figure> all = {human(), quadruped(), spider(3), spider(4), side_view()};
    return all;
}

// A cone of two balls, 1 apart, and what the capsule in it must be.
struct Cone {
    double here, there;
    double start, end, radius;
};

TEST(Capsules, LieInTheHullOfTheBalls) {
    // As thick as the thinner ball, but at least half of the thicker one: then they end where the hull is that thick.
    for (const Cone& cone : {Cone{0.2, 0.2, 0, 1, 0.2}, Cone{0.3, 0.2, 0, 1, 0.2}, Cone{0.2, 0.3, 0, 1, 0.2},
                             Cone{0.4, 0.1, 0, 2.0 / 3, 0.2}, Cone{0.1, 0.4, 1.0 / 3, 1, 0.2},
                             Cone{0.2, 0, 0, 0.5, 0.1}, Cone{0, 0, 0, 1, 0}}) {
        Figure f;
        f.add("from", {0, 0, 0}, FLG_NO_INDEX, cone.here);
        f.add("to", {0, 0, 1}, 0, cone.there);
        const FigureRig rig(f);
        const FlgRigJoint& joint = rig.joint("from");
        EXPECT_NEAR(double{joint.capsule_start[2]}, cone.start, 1e-6);
        EXPECT_NEAR(double{joint.capsule_end[2]}, cone.end, 1e-6);
        EXPECT_NEAR(double{joint.capsule_radius}, cone.radius, 1e-6);
        EXPECT_EQ(rig.joint("to").capsule_radius, 0);
        // Balls between two whose radii differ evenly are in their hull.
        for (const double at : {cone.start, cone.end})
            EXPECT_LE(cone.radius, cone.here + at * (cone.there - cone.here) + 1e-12);
    }
}

TEST(Limits, ContainTheRestPose) {
    for (const Figure& figure : figures())
        for (const FlgRigJoint& joint : FigureRig(figure).joints) {
            EXPECT_LE(beyond_limit(joint, Quaternion::Identity()), 0);
            EXPECT_NEAR(load_vec3(joint.limit_axis).norm(), 1, 1e-6);
        }
}

TEST(Limits, LeftMirrorsRight) {
    for (const Figure& figure : {human(), quadruped(), spider(3)}) {
        const FigureRig rig(figure, Vec3::UnitX());
        for (uint32_t j = 0; j < figure.names.size(); ++j) {
            const size_t at = figure.names[j].find(".L");
            if (at == std::string::npos) continue;
            const FlgRigJoint& left = rig.joints[j];
            const FlgRigJoint& right = rig.joint(std::string(figure.names[j]).replace(at, 2, ".R"));
            EXPECT_EQ(left.place, right.place);
            EXPECT_EQ(left.limit_swing, right.limit_swing);
            EXPECT_EQ(left.limit_twist_min, right.limit_twist_min);
            EXPECT_EQ(left.limit_twist_max, right.limit_twist_max);
            EXPECT_EQ(left.capsule_radius, right.capsule_radius);
            EXPECT_EQ(left.capsule_start[0], -right.capsule_start[0]);
            // A bone's axis mirrors as it is, a hinge's as a turn does.
            const double sign = left.limit_swing == 0 ? -1 : 1;
            const Vec3 mirrored = sign * load_vec3(right.limit_axis).cwiseProduct(Vec3(-1, 1, 1));
            EXPECT_TRUE(load_vec3(left.limit_axis).isApprox(mirrored, 1e-6)) << figure.names[j];
        }
    }
}

// Where the joint after a hinge goes when it bends by 0.8.
Vec3 bent(const FigureRig& rig, const std::string& hinge) {
    const FlgRigJoint& joint = rig.joint(hinge);
    EXPECT_EQ(joint.limit_swing, 0);
    EXPECT_GE(joint.limit_twist_max, 0.8f);
    const Vec3 bone = rig.figure.at[joint.next] - rig.figure.at[rig.figure.find(hinge)];
    return turned(load_vec3(joint.limit_axis), 0.8) * bone - bone;
}

TEST(Limits, KneesBendBackAndElbowsForward) {
    const FigureRig person(human());
    for (const char* side : {"L", "R"}) {
        EXPECT_LT(bent(person, std::string("leg.") + side + "_1").z(), -0.2);
        EXPECT_GT(bent(person, std::string("arm.") + side + "_1").z(), 0.1);
    }
    const FigureRig animal(quadruped(), Vec3::UnitX());
    EXPECT_GT(bent(animal, "front.L_1").z(), 0.2);  // bent like that at rest
    EXPECT_LT(bent(animal, "hind.L_1").z(), -0.2);
    EXPECT_LT(bent(FigureRig(spider(4), Vec3::UnitX()), "leg0.L_1").x(), -0.2);  // towards the body
}

TEST(Limits, FoldedArmsHaveAnAxis) {
    Figure folded = human();
    for (const char* side : {"L", "R"}) {
        const std::string arm = std::string("arm.") + side + "_";
        folded.at[folded.find(arm + "2")] = folded.at[folded.find(arm + "0")];
        folded.at[folded.find(arm + "3")] = folded.at[folded.find(arm + "1")];
    }
    for (const FlgRigJoint& joint : FigureRig(folded).joints) EXPECT_NEAR(load_vec3(joint.limit_axis).norm(), 1, 1e-6);
}

TEST(Limits, HingesGoBackUntilTheyAreStraight) {
    const FigureRig animal(quadruped(), Vec3::UnitX());
    const FlgRigJoint& knee = animal.joint("hind.L_1");
    const Figure& f = animal.figure;
    const Vec3 before = f.at[f.find("hind.L_1")] - f.at[f.find("hind.L_0")];
    const Vec3 after = turned(load_vec3(knee.limit_axis), double{knee.limit_twist_min}) *
                       (f.at[f.find("hind.L_2")] - f.at[f.find("hind.L_1")]);
    EXPECT_NEAR(before.normalized().dot(after.normalized()), 1, 1e-6);
}

}  // namespace
}  // namespace flg::test
