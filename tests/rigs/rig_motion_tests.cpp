// SPDX-License-Identifier: MIT
// Test motions: without a seam, within the limits, and standing feet stay where they stand.
#include <gtest/gtest.h>

#include <cmath>

#include "core/failure.h"
#include "rigs/figures.h"
#include "rigs/limits.h"
#include "rigs/rig_motion.h"

namespace flg::test {
namespace {

constexpr uint32_t steps = 240;

struct Sampled {
    std::vector<float> rotations;
    Vec3 translation, travel;
    std::vector<JointMotion> motions;
};

Sampled sampled(const FigureRig& rig, FlgRigMotion motion, double phase) {
    Sampled out;
    const uint32_t count = rig.rig().count();
    out.rotations.resize(4 * count);
    MotionPose pose{out.rotations.data()};
    sample_motion(rig.rig(), motion, phase, pose);
    out.translation = pose.translation;
    out.travel = pose.travel;
    float moved[3];
    store_vec3(pose.translation, moved);
    out.motions.resize(count);
    pose_joints(rig.positions.data(), rig.figure.parents.data(), out.rotations.data(), moved, out.motions);
    return out;
}

std::vector<Figure> walkers() {
    return {human(), quadruped(), spider(3), spider(4), side_view()};
}

TEST(RigMotions, EndWhereTheyBegin) {
    for (const Figure& figure : walkers())
        for (const FlgRigMotion motion : {FLG_RIG_MOTION_WALK, FLG_RIG_MOTION_IDLE, FLG_RIG_MOTION_WAVE}) {
            const FigureRig rig(figure);
            const Sampled first = sampled(rig, motion, 0), last = sampled(rig, motion, 1 - 1e-9);
            for (size_t i = 0; i < first.rotations.size(); ++i)
                EXPECT_NEAR(first.rotations[i], last.rotations[i], 1e-6f);
            EXPECT_LT((first.translation - last.translation).norm(), 1e-6);
        }
}

TEST(RigMotions, StayWithinTheLimits) {
    for (const Figure& figure : walkers()) {
        const FigureRig rig(figure);
        for (const FlgRigMotion motion : {FLG_RIG_MOTION_WALK, FLG_RIG_MOTION_IDLE, FLG_RIG_MOTION_WAVE})
            for (uint32_t i = 0; i < steps; ++i) {
                const Sampled pose = sampled(rig, motion, static_cast<double>(i) / steps);
                for (uint32_t j = 0; j < rig.joints.size(); ++j)
                    EXPECT_LE(beyond_limit(rig.joints[j], load_quaternion(pose.rotations.data() + 4 * j)), 1e-6)
                        << rig.figure.names[j] << " of " << figure.names[0] << " motion " << motion << " step " << i;
            }
    }
}

// Feet that stand move back as fast as the ground does: over a cycle each is still, in the world, for a good part of
// it, at one height.
TEST(RigMotions, StandingFeetDoNotSlide) {
    for (const Figure& figure : walkers()) {
        const FigureRig rig(figure);
        const Vec3 travel = sampled(rig, FLG_RIG_MOTION_WALK, 0).travel;
        EXPECT_GT(travel.dot(rig.frame.forward), 0.05) << figure.names[0];
        for (uint32_t j = 0; j < rig.joints.size(); ++j) {
            if (rig.joints[j].limb != FLG_LIMB_LEG || rig.joints[j].place != FLG_LIMB_PLACE_END) continue;
            const auto foot_at = [&](double phase) {
                const Sampled pose = sampled(rig, FLG_RIG_MOTION_WALK, phase - std::floor(phase));
                const Vec3 at = pose.motions[j].rotation * rig.figure.at[j] + pose.motions[j].translation;
                return Vec3(at + phase * travel);
            };
            uint32_t standing = 0;
            double lifted = 0;
            for (uint32_t i = 0; i < steps; ++i) {
                const double phase = static_cast<double>(i) / steps;
                const Vec3 here = foot_at(phase), later = foot_at(phase + 1.0 / steps);
                standing += (later - here).norm() <= 1e-4 * travel.norm();
                lifted = std::max(lifted, here.y() - rig.figure.at[j].y());
            }
            EXPECT_GE(standing, steps * 11 / 20) << rig.figure.names[j];
            EXPECT_GT(lifted, 0.02) << rig.figure.names[j];
        }
    }
}

TEST(RigMotions, FeetOfTwoLegsTakeTurnsAndThoseOfManyMakeTwoSets) {
    const auto ahead = [](const FigureRig& rig, const std::string& name) {
        const uint32_t j = rig.figure.find(name);
        const Sampled pose = sampled(rig, FLG_RIG_MOTION_WALK, 0.1);
        const Vec3 moved = pose.motions[j].rotation * rig.figure.at[j] + pose.motions[j].translation - rig.figure.at[j];
        return moved.z();
    };
    const FigureRig person(human());
    EXPECT_GT(ahead(person, "leg.L_2"), 0.05);
    EXPECT_LT(ahead(person, "leg.R_2"), -0.05);
    const FigureRig insect(spider(3), Vec3::UnitX());
    for (const char* name : {"leg0.L_2", "leg1.R_2", "leg2.L_2"}) EXPECT_GT(ahead(insect, name), 0.02) << name;
    for (const char* name : {"leg0.R_2", "leg1.L_2", "leg2.R_2"}) EXPECT_LT(ahead(insect, name), -0.02) << name;
}

TEST(RigMotions, IdleStandsAndWaveLiftsTheRightHand) {
    const FigureRig person(human());
    double lowest = 1e9, highest = -1e9;
    for (uint32_t i = 0; i < steps; ++i) {
        const Sampled idle = sampled(person, FLG_RIG_MOTION_IDLE, static_cast<double>(i) / steps);
        for (const char* name : {"leg.L_2", "leg.R_3", "hips"}) {
            const uint32_t j = person.figure.find(name);
            const Vec3 at = idle.motions[j].rotation * person.figure.at[j] + idle.motions[j].translation;
            EXPECT_LT((at - person.figure.at[j]).norm(), 1e-6) << name;
        }
        const uint32_t hand = person.figure.find("arm.R_2");
        const Sampled wave = sampled(person, FLG_RIG_MOTION_WAVE, static_cast<double>(i) / steps);
        const Vec3 at = wave.motions[hand].rotation * person.figure.at[hand] + wave.motions[hand].translation;
        lowest = std::min(lowest, at.y());
        highest = std::max(highest, at.y());
    }
    EXPECT_LT(lowest, 0.9);   // hanging
    EXPECT_GT(highest, 1.6);  // above the shoulder by more than the forearm
}

// A model at rest with level arms, as engines ask for, does not stand there like that.
TEST(RigMotions, LevelArmsHangDownInEveryMotion) {
    Figure level = human();
    for (const std::string side : {".L", ".R"}) {
        const Vec3 shoulder = level.at[level.find("arm" + side + "_0")];
        for (int i = 1; i <= 3; ++i)
            level.at[level.find("arm" + side + "_" + std::to_string(i))] =
                shoulder + Vec3(0.25 * i * (shoulder.x() > 0 ? 1 : -1), 0, 0);
    }
    const FigureRig person(level);
    for (const FlgRigMotion motion : {FLG_RIG_MOTION_WALK, FLG_RIG_MOTION_IDLE, FLG_RIG_MOTION_WAVE})
        for (uint32_t i = 0; i < steps; ++i) {
            const Sampled pose = sampled(person, motion, static_cast<double>(i) / steps);
            const auto height = [&](const std::string& name) {
                const uint32_t j = person.figure.find(name);
                return (pose.motions[j].rotation * person.figure.at[j] + pose.motions[j].translation).y();
            };
            EXPECT_LT(height("arm.L_2"), height("arm.L_0") - 0.3) << motion << " step " << i;
            const bool is_waving = motion == FLG_RIG_MOTION_WAVE && i > 0;
            EXPECT_LT(height("arm.R_2"), is_waving ? 3 : height("arm.R_0") - 0.3) << motion;
        }
}

TEST(RigMotions, LegsThatCannotStepGiveNumbersAllTheSame) {
    // Without a length, and lying flat.
    for (const Vec3& foot : {Vec3(0.3, 0, 0), Vec3(1, 0, 0)}) {
        Figure f;
        f.add_pair("leg", f.add("root", {0, 0.1, 0}, FLG_NO_INDEX, 0.01),
                   {{0.3, 0, 0}, (foot + Vec3(0.3, 0, 0)) / 2, foot}, 0.01);
        const FigureRig rig(f);
        EXPECT_EQ(rig.rig().view.leg_count, 2u);
        for (uint32_t i = 0; i < 10; ++i) {
            const Sampled pose = sampled(rig, FLG_RIG_MOTION_WALK, 0.1 * i);
            EXPECT_TRUE(pose.translation.allFinite());
            for (size_t j = 0; j < rig.joints.size(); ++j) {
                const float* q = pose.rotations.data() + 4 * j;
                EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-5f);
            }
        }
    }
}

TEST(RigMotions, LimbsWithoutAnEndAreNone) {
    FigureRig rig(human());
    for (FlgRigJoint& joint : rig.joints)
        if (joint.place == FLG_LIMB_PLACE_END) joint.place = FLG_LIMB_PLACE_NONE;
    EXPECT_THROW(sampled(rig, FLG_RIG_MOTION_WALK, 0.2), Failure);
    EXPECT_THROW(sampled(rig, FLG_RIG_MOTION_WAVE, 0.2), Failure);
}

TEST(RigMotions, WhatHasNoLegsDoesNotWalk) {
    Figure worm;
    worm.add_path("worm", worm.add("root", {0, 0, 0}, FLG_NO_INDEX), {{1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
    const FigureRig rig(worm);
    EXPECT_THROW(sampled(rig, FLG_RIG_MOTION_WALK, 0), Failure);
    EXPECT_THROW(sampled(rig, FLG_RIG_MOTION_WAVE, 0), Failure);
    EXPECT_NO_THROW(sampled(rig, FLG_RIG_MOTION_IDLE, 0));
}

}  // namespace
}  // namespace flg::test
