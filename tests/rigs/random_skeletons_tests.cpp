// SPDX-License-Identifier: MIT
// Whatever a skeleton looks like, its rig keeps the rules: limbs are chains, directions have length 1, motions are
// rotations within the limits.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/failure.h"
#include "rigs/figures.h"
#include "rigs/humanoid.h"
#include "rigs/limits.h"
#include "rigs/rig_motion.h"

namespace flg::test {
namespace {

Figure random_figure(std::mt19937& random) {
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    Figure f;
    const auto count = std::uniform_int_distribution<uint32_t>(1, 60)(random);
    const bool is_flat = random() % 3 == 0, is_lattice = random() % 4 == 0;
    for (uint32_t j = 0; j < count; ++j) {
        const bool is_root = j == 0 || random() % 40 == 0;
        const uint32_t parent = is_root ? FLG_NO_INDEX : std::uniform_int_distribution<uint32_t>(0, j - 1)(random);
        Vec3 way;
        for (double& coordinate : way) coordinate = number(-1, 1);
        if (is_flat) way.z() = 0;
        if (is_lattice) way = way.array().round();  // joints in one place, straight and folded limbs
        f.add("joint", parent == FLG_NO_INDEX ? way : Vec3(f.at[parent] + way), parent, number(0, 1));
    }
    return f;
}

void expect_rules(const FigureRig& rig) {
    const auto count = static_cast<uint32_t>(rig.joints.size());
    for (uint32_t j = 0; j < count; ++j) {
        const FlgRigJoint& joint = rig.joints[j];
        EXPECT_TRUE(joint.next == FLG_NO_INDEX || rig.figure.parents[joint.next] == j);
        EXPECT_NEAR(load_vec3(joint.limit_axis).norm(), 1, 1e-6);
        EXPECT_LE(beyond_limit(joint, Quaternion::Identity()), 0);
        EXPECT_TRUE(std::isfinite(joint.capsule_radius));
        if (joint.limb == FLG_LIMB_OTHER || joint.limb == FLG_LIMB_HEAD || joint.index == 0) continue;
        const FlgRigJoint& before = rig.joints[rig.figure.parents[j]];
        EXPECT_EQ(before.limb, joint.limb);
        EXPECT_EQ(before.index + 1, joint.index);
    }
}

TEST(RandomSkeletons, KeepTheRules) {
    std::mt19937 random(7);
    for (int i = 0; i < 1000; ++i) {
        const Figure figure = random_figure(random);
        const FigureRig rig(figure, i % 2 == 0 ? Vec3::Zero() : Vec3(Vec3::UnitX()));
        expect_rules(rig);
        std::vector<const char*> names(figure.at.size());
        std::vector<float> rotations(4 * figure.at.size());
        const auto tried = [](auto run) {
            try {
                run();
            } catch (const Failure&) {
                return false;
            }
            return true;
        };
        tried([&] { name_humanoid(rig.rig(), FLG_RIG_STANDARD_VRM, names.data()); });
        tried([&] { pose_t(rig.rig(), rotations.data()); });
        for (const FlgRigMotion motion : {FLG_RIG_MOTION_WALK, FLG_RIG_MOTION_IDLE, FLG_RIG_MOTION_WAVE})
            for (const double phase : {0.0, 0.3, 0.7}) {
                MotionPose pose{rotations.data()};
                if (!tried([&] { sample_motion(rig.rig(), motion, phase, pose); })) continue;
                EXPECT_TRUE(pose.translation.allFinite() && pose.travel.allFinite());
                for (size_t j = 0; j < rig.joints.size(); ++j) {
                    const float* q = rotations.data() + 4 * j;
                    EXPECT_NEAR(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-5f);
                    EXPECT_LE(beyond_limit(rig.joints[j], load_quaternion(q)), 1e-5);
                }
            }
    }
}

}  // namespace
}  // namespace flg::test
