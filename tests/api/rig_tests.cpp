// SPDX-License-Identifier: MIT
// Rigs at the ABI: what is found, what is refused, and that refusals write nothing.
#include "filigree/filigree_rig.h"

#include "api/host.h"

namespace flg::test {
namespace {

constexpr uint32_t joint_count = 15;

struct Person {
    std::vector<float> positions = {0,    1,    0, 0,     1.4f, 0, 0,     1.7f, 0, 0.2f,  1.3f, 0, 0.5f,  1.2f, 0,
                                    0.7f, 1,    0, -0.2f, 1.3f, 0, -0.5f, 1.2f, 0, -0.7f, 1,    0, 0.1f,  0.9f, 0,
                                    0.1f, 0.5f, 0, 0.1f,  0,    0, -0.1f, 0.9f, 0, -0.1f, 0.5f, 0, -0.1f, 0,    0};
    std::vector<float> radii = std::vector<float>(joint_count, 0.05f);
    std::vector<uint32_t> parents = {FLG_NO_INDEX, 0, 1, 1, 3, 4, 1, 6, 7, 0, 9, 10, 0, 12, 13};
    std::vector<FlgRigJoint> joints = std::vector<FlgRigJoint>(joint_count);
    FlgRig rig = flgRigDefaults();

    FlgRigFindDesc desc() const {
        FlgRigFindDesc desc = flgRigFindDefaults();
        desc.joint_count = joint_count;
        desc.joint_positions = positions.data();
        desc.joint_radii = radii.data();
        desc.joint_parents = parents.data();
        return desc;
    }
    void find() {
        const FlgRigFindDesc of = desc();
        ASSERT_EQ(flgRigFind(&of, joints.data(), &rig), FLG_OK) << flgErrorGetMessage();
    }
};

TEST(Rigs, APersonIsFoundNamedPosedAndMoved) {
    Person person;
    person.find();
    EXPECT_EQ(person.rig.leg_count, 2u);
    EXPECT_EQ(person.rig.arm_count, 2u);
    EXPECT_EQ(person.rig.joints, person.joints.data());
    EXPECT_EQ(person.rig.left[0], 1);
    EXPECT_EQ(person.rig.forward[2], 1);
    EXPECT_EQ(person.joints[5].limb, FLG_LIMB_ARM);
    std::vector<const char*> names(joint_count);
    ASSERT_EQ(flgRigGetNames(&person.rig, FLG_RIG_STANDARD_UNITY, names.data()), FLG_OK) << flgErrorGetMessage();
    EXPECT_STREQ(names[8], "RightHand");
    std::vector<float> rotations(4 * joint_count);
    ASSERT_EQ(flgRigGetTPose(&person.rig, rotations.data()), FLG_OK);
    float translation[3], travel[3];
    ASSERT_EQ(flgRigMotionSample(&person.rig, FLG_RIG_MOTION_WALK, 7.25f, rotations.data(), translation, travel),
              FLG_OK);
    EXPECT_GT(travel[2], 0.2f);
    // The same phase a cycle later, and without what is not asked for.
    std::vector<float> again(4 * joint_count);
    ASSERT_EQ(flgRigMotionSample(&person.rig, FLG_RIG_MOTION_WALK, 0.25f, again.data(), translation, nullptr), FLG_OK);
    EXPECT_EQ(rotations, again);
}

void expect_refused(FlgResult result, const std::string& words) {
    EXPECT_EQ(result, FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgErrorGetMessage()).find(words), std::string::npos) << flgErrorGetMessage();
}

TEST(Rigs, SkeletonsThatAreNoneAreRefused) {
    Person person;
    const auto refused = [&](auto change, const std::string& words) {
        FlgRigFindDesc desc = person.desc();
        change(desc);
        expect_refused(flgRigFind(&desc, person.joints.data(), &person.rig), words);
        EXPECT_EQ(person.rig.joint_count, 0u);
    };
    refused([](FlgRigFindDesc& d) { d.joint_count = 0; }, "desc.joint_count is 0, must be 1 to 1024");
    refused([](FlgRigFindDesc& d) { d.joint_count = 1025; }, "desc.joint_count is 1025");
    refused([](FlgRigFindDesc& d) { d.joint_positions = nullptr; }, "desc.joint_positions is null");
    refused([](FlgRigFindDesc& d) { d.joint_radii = nullptr; }, "desc.joint_radii is null");
    refused([](FlgRigFindDesc& d) { d.joint_parents = nullptr; }, "desc.joint_parents is null");
    refused([](FlgRigFindDesc& d) { d.up[1] = 0; }, "desc.up");
    refused([](FlgRigFindDesc& d) { d.left[1] = 1; }, "desc.left must not lie along desc.up");
    refused([](FlgRigFindDesc& d) { d.left[0] = NAN; }, "desc.left[0]");
    const std::vector<float> bad_radii(joint_count, -1.0f);
    refused([&](FlgRigFindDesc& d) { d.joint_radii = bad_radii.data(); }, "desc.joint_radii[0] is -1");
    const std::vector<uint32_t> loop(joint_count, 3);
    refused([&](FlgRigFindDesc& d) { d.joint_parents = loop.data(); }, "desc.joint_parents[0] is 3");
    std::vector<float> endless = person.positions;
    endless[4] = INFINITY;
    refused([&](FlgRigFindDesc& d) { d.joint_positions = endless.data(); }, "desc.joint_positions[4] is inf");
    const FlgRigFindDesc desc = person.desc();
    expect_refused(flgRigFind(&desc, nullptr, &person.rig), "out_joints is null");
    expect_refused(flgRigFind(&desc, person.joints.data(), nullptr), "out_rig is null");
    expect_refused(flgRigFind(nullptr, person.joints.data(), &person.rig), "desc is null");
}

TEST(Rigs, RigsThatAreNoneAreRefused) {
    Person person;
    person.find();
    std::vector<float> rotations(4 * joint_count, 7);
    const auto refused = [&](auto change, const std::string& words) {
        Person other = person;
        other.rig.joints = other.joints.data();
        change(other);
        expect_refused(flgRigGetTPose(&other.rig, rotations.data()), words);
        EXPECT_EQ(rotations, std::vector<float>(4 * joint_count, 7));
    };
    refused([](Person& p) { p.rig.joints = nullptr; }, "rig.joints is null");
    refused([](Person& p) { p.joints[2].side = 2; }, "rig.joints[2]: side must be");
    refused([](Person& p) { p.joints[2].next = 1; }, "rig.joints[2].next is 1");
    refused([](Person& p) { p.joints[2].limit_axis[0] = 5; }, "rig.joints[2]: limit_axis");
    refused([](Person& p) { p.joints[2].limit_twist_min = 1; }, "rig.joints[2]: limit_twist_min");
    refused([](Person& p) { p.joints[2].limit_swing = -1; }, "rig.joints[2]: limit_swing");
    refused([](Person& p) { p.rig.forward[2] = -1; }, "rig.left, rig.up and rig.forward");
    expect_refused(flgRigGetTPose(&person.rig, nullptr), "out_rotations is null");
}

TEST(Rigs, MotionsWithoutLimbsAreRefused) {
    Person person;
    person.find();
    std::vector<float> rotations(4 * joint_count, 7);
    float moved[3] = {7, 7, 7};
    const auto none = static_cast<FlgRigMotion>(9);
    expect_refused(flgRigMotionSample(&person.rig, none, 0, rotations.data(), moved, nullptr), "motion is 9");
    expect_refused(flgRigMotionSample(&person.rig, FLG_RIG_MOTION_IDLE, NAN, rotations.data(), moved, nullptr),
                   "phase");
    for (FlgRigJoint& joint : person.joints) joint.limb = FLG_LIMB_TRUNK;
    expect_refused(flgRigMotionSample(&person.rig, FLG_RIG_MOTION_WALK, 0, rotations.data(), moved, nullptr),
                   "no walk");
    EXPECT_EQ(rotations, std::vector<float>(4 * joint_count, 7));
    EXPECT_EQ(moved[0], 7);
}

TEST(Rigs, LimbsOfTwoTreesAreRefused) {
    Person person;
    person.find();
    person.parents[12] = FLG_NO_INDEX;
    person.joints[0].next = 1;
    std::vector<const char*> names(joint_count);
    expect_refused(flgRigGetNames(&person.rig, FLG_RIG_STANDARD_VRM, names.data()), "another tree");
}

}  // namespace
}  // namespace flg::test
