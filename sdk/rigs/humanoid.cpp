// SPDX-License-Identifier: MIT
#include "rigs/humanoid.h"

#include <algorithm>
#include <array>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t none = FLG_NO_INDEX;

// Of one side, in the order of the names below.
enum SideBone { shoulder, upper_arm, lower_arm, hand, upper_leg, lower_leg, foot, toes, side_bones };

using SideNames = std::array<const char*, side_bones>;
struct Names {
    const char *hips, *neck, *head;
    SideNames left, right;
    std::array<const char*, 5> spine;  // those of fewer are the first ones, and the last
    uint32_t spine_count;
};

constexpr std::array<Names, 3> standards = {{
    {"hips",
     "neck",
     "head",
     {"leftShoulder", "leftUpperArm", "leftLowerArm", "leftHand", "leftUpperLeg", "leftLowerLeg", "leftFoot",
      "leftToes"},
     {"rightShoulder", "rightUpperArm", "rightLowerArm", "rightHand", "rightUpperLeg", "rightLowerLeg", "rightFoot",
      "rightToes"},
     {"spine", "chest", "upperChest"},
     3},
    {"Hips",
     "Neck",
     "Head",
     {"LeftShoulder", "LeftUpperArm", "LeftLowerArm", "LeftHand", "LeftUpperLeg", "LeftLowerLeg", "LeftFoot",
      "LeftToes"},
     {"RightShoulder", "RightUpperArm", "RightLowerArm", "RightHand", "RightUpperLeg", "RightLowerLeg", "RightFoot",
      "RightToes"},
     {"Spine", "Chest", "UpperChest"},
     3},
    {"pelvis",
     "neck_01",
     "head",
     {"clavicle_l", "upperarm_l", "lowerarm_l", "hand_l", "thigh_l", "calf_l", "foot_l", "ball_l"},
     {"clavicle_r", "upperarm_r", "lowerarm_r", "hand_r", "thigh_r", "calf_r", "foot_r", "ball_r"},
     {"spine_01", "spine_02", "spine_03", "spine_04", "spine_05"},
     5},
}};

struct Limb {
    uint32_t first, upper, middle, end;
};

Limb find_limb(const Rig& rig, FlgLimb limb, int32_t side) {
    const uint32_t first = rig.first(limb, side);
    const char* name = limb == FLG_LIMB_ARM ? "arm" : "leg";
    const Limb found{first, rig.find(first, FLG_LIMB_PLACE_UPPER), rig.find(first, FLG_LIMB_PLACE_MIDDLE),
                     rig.find(first, FLG_LIMB_PLACE_END)};
    if (found.upper == none || found.middle == none || found.end == none)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "no humanoid: its %s %s does not bend: it needs three joints; a larger detail gives it more",
                      side > 0 ? "left" : "right", name);
    return found;
}

void name_side(const Rig& rig, const Limb& arm, const Limb& leg, const SideNames& as, const char** names) {
    if (arm.upper != arm.first) names[rig.parent(arm.upper)] = as[shoulder];
    names[arm.upper] = as[upper_arm];
    names[arm.middle] = as[lower_arm];
    names[arm.end] = as[hand];
    names[leg.upper] = as[upper_leg];
    names[leg.middle] = as[lower_leg];
    names[leg.end] = as[foot];
    if (rig.next(leg.end) != none) names[rig.next(leg.end)] = as[toes];
}

}  // namespace

void name_humanoid(const Rig& rig, FlgRigStandard standard, const char** names) {
    const Names& as = standards[static_cast<size_t>(standard)];
    if (rig.view.leg_count == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no humanoid: it has no legs");
    if (rig.view.leg_count != 2)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no humanoid: it has %u leg%s", rig.view.leg_count,
                      rig.view.leg_count == 1 ? "" : "s");
    if (rig.first(FLG_LIMB_LEG, 1) == none || rig.first(FLG_LIMB_LEG, -1) == none)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no humanoid: its legs do not stand side by side");
    const Limb left_leg = find_limb(rig, FLG_LIMB_LEG, 1), right_leg = find_limb(rig, FLG_LIMB_LEG, -1);
    if (rig.first(FLG_LIMB_ARM, 1) == none || rig.first(FLG_LIMB_ARM, -1) == none)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no humanoid: it has no pair of arms");
    const Limb left_arm = find_limb(rig, FLG_LIMB_ARM, 1), right_arm = find_limb(rig, FLG_LIMB_ARM, -1);
    const uint32_t neck = rig.first(FLG_LIMB_NECK, 0), head = rig.first(FLG_LIMB_HEAD, 0);
    if (head == none) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no humanoid: it has no head");
    const uint32_t chest = rig.meet(left_arm.first, right_arm.first);
    const uint32_t legs = rig.meet(left_leg.first, right_leg.first), hips = rig.meet(rig.meet(legs, chest), head);
    if (rig.meet(legs, chest) == chest && legs != chest)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "no humanoid: its legs hang below its arms: joint %u, where the legs meet, has to be the root",
                      legs);
    if (hips == chest)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "no humanoid: its spine has no joint between hips and arms; a larger detail gives it more");

    std::fill_n(names, rig.count(), nullptr);
    uint32_t spine = 0;
    for (uint32_t j = chest; j != hips; j = rig.parent(j)) ++spine;
    uint32_t number = spine;  // of the joint, from the hips
    for (uint32_t j = chest; j != hips; j = rig.parent(j), --number) {
        if (number < as.spine_count) names[j] = as.spine[number - 1];
        if (number == spine) names[j] = as.spine[std::min(spine, as.spine_count) - 1];
    }
    names[hips] = as.hips;
    if (neck != none) names[neck] = as.neck;
    names[head] = as.head;
    name_side(rig, left_arm, left_leg, as.left, names);
    name_side(rig, right_arm, right_leg, as.right, names);
}

void pose_t(const Rig& rig, float* rotations) {
    const uint32_t arms[] = {rig.first(FLG_LIMB_ARM, 1), rig.first(FLG_LIMB_ARM, -1)};
    if (arms[0] == none || arms[1] == none)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "no T-pose: it has no pair of arms");
    for (uint32_t j = 0; j < rig.count(); ++j) store_quaternion(Quaternion::Identity(), rotations + 4 * j);
    for (const uint32_t first : arms) {
        const Vec3 aside = rig.joint(first).side * rig.left;
        Quaternion before = Quaternion::Identity();
        const uint32_t upper = rig.find(first, FLG_LIMB_PLACE_UPPER);
        for (uint32_t j = upper; j != none && rig.next(j) != none; j = rig.next(j)) {
            const Quaternion whole = Quaternion::FromTwoVectors(rig.direction(j, rig.next(j)), aside);
            store_quaternion((before.conjugate() * whole).normalized(), rotations + 4 * j);
            before = whole;
        }
    }
}

}  // namespace flg
