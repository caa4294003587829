// SPDX-License-Identifier: MIT
#include "rigs/joint_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg {

namespace {

constexpr double deep_within = 0.5;                   // share of a radius
constexpr double short_end = 0.2;                     // share of the limb that a hand or foot is
constexpr double thinnest = 0.5;                      // share of a bone's larger radius that its capsule has at least
constexpr double bent_knee = 0.15, bent_elbow = 0.3;  // radians at rest that say how a hinge turns
constexpr double folded = 3.1;                        // radians from which a limb's bones say no plane
constexpr double sideways = 0.5;                      // cosine between a leg and the left from which it lies to a side
constexpr double furthest_bend = 2.4;                 // radians of a hinge from straight
constexpr double least_bend = 0.3;  // radians that a hinge may bend further, however it is bent at rest

struct Cone {
    double swing, twist;
};
constexpr double free_turn = std::numbers::pi;
constexpr Cone root_cone = {free_turn, free_turn}, trunk_cone = {0.35, 0.35}, neck_cone = {0.5, 0.6},
               head_cone = {0.6, 0.9}, tail_cone = {0.5, 0.3}, other_cone = {0.3, 0.3};
constexpr Cone shoulder_cone = {2.6, 1.6}, hand_cone = {1.0, 0.6}, hip_cone = {1.3, 0.6}, foot_cone = {1.0, 0.5};
constexpr Cone between_cone = {0.35, 0.3};  // of arms and legs, where they neither begin, bend nor end

Cone cone_of(const FlgRigJoint& joint, bool is_root) {
    if (is_root) return root_cone;
    switch (joint.limb) {
        case FLG_LIMB_TRUNK: return trunk_cone;
        case FLG_LIMB_NECK: return neck_cone;
        case FLG_LIMB_HEAD: return joint.index == 0 ? head_cone : other_cone;
        case FLG_LIMB_TAIL: return tail_cone;
        case FLG_LIMB_ARM:
            if (joint.place == FLG_LIMB_PLACE_UPPER) return shoulder_cone;
            return joint.place == FLG_LIMB_PLACE_END ? hand_cone : between_cone;
        case FLG_LIMB_LEG:
            if (joint.place == FLG_LIMB_PLACE_UPPER) return hip_cone;
            return joint.place == FLG_LIMB_PLACE_END ? foot_cone : between_cone;
        default: return other_cone;
    }
}

class LimitFinder {
public:
    LimitFinder(const RigSkeleton& skeleton, const RigFrame& frame, std::span<FlgRigJoint> joints)
        : skeleton_(skeleton), frame_(frame), joints_(joints) {
        for (const FlgRigJoint& joint : joints)
            if (joint.limb == FLG_LIMB_LEG) leg_pairs_ = std::max(leg_pairs_, joint.pair + 1);
    }

    void find() {
        const auto count = static_cast<uint32_t>(joints_.size());
        for (uint32_t j = 0; j < count; ++j)
            if (bends(j) && joints_[j].index == 0) set_places(j);
        for (uint32_t j = 0; j < count; ++j) {
            set_capsule(j);
            const Cone cone = cone_of(joints_[j], skeleton_.parents[j] == FLG_NO_INDEX);
            store_vec3(bone_axis(j), joints_[j].limit_axis);
            joints_[j].limit_swing = static_cast<float>(cone.swing);
            joints_[j].limit_twist_min = static_cast<float>(-cone.twist);
            joints_[j].limit_twist_max = static_cast<float>(cone.twist);
        }
        for (uint32_t j = 0; j < count; ++j)
            if (bends(j) && joints_[j].index == 0) set_hinge(j);
    }

private:
    bool bends(uint32_t j) const { return joints_[j].limb == FLG_LIMB_ARM || joints_[j].limb == FLG_LIMB_LEG; }
    double bone(uint32_t j) const { return (skeleton_.at[j] - skeleton_.at[skeleton_.parents[j]]).norm(); }

    void set_places(uint32_t first) {
        uint32_t tip = first;
        double length = 0;  // from the upper joint to the tip
        while (joints_[tip].next != FLG_NO_INDEX) {
            tip = joints_[tip].next;
            length += bone(tip);
        }
        uint32_t upper = first;
        const auto joints_after = [&](uint32_t j) { return joints_[tip].index - joints_[j].index; };
        while (joints_after(upper) >= 3 && bone(upper) < deep_within * skeleton_.radii[skeleton_.parents[upper]]) {
            upper = joints_[upper].next;
            length -= bone(upper);
        }
        if (upper == tip) return;
        uint32_t end = tip;
        if (joints_after(upper) >= 3 && bone(tip) < short_end * length) {
            end = skeleton_.parents[tip];
            length -= bone(tip);
        }
        joints_[upper].place = FLG_LIMB_PLACE_UPPER;
        joints_[end].place = FLG_LIMB_PLACE_END;
        uint32_t middle = FLG_NO_INDEX;
        double before = 0, nearest = INFINITY;
        for (uint32_t j = joints_[upper].next; j != end; j = joints_[j].next) {
            before += bone(j);
            if (std::abs(before - length / 2) >= nearest) continue;
            nearest = std::abs(before - length / 2);
            middle = j;
        }
        if (middle != FLG_NO_INDEX) joints_[middle].place = FLG_LIMB_PLACE_MIDDLE;
    }

    Vec3 bone_axis(uint32_t j) const {
        const uint32_t parent = skeleton_.parents[j], next = joints_[j].next;
        Vec3 way = Vec3::Zero();
        if (next != FLG_NO_INDEX) way = skeleton_.at[next] - skeleton_.at[j];
        if (way.norm() == 0 && parent != FLG_NO_INDEX) way = skeleton_.at[j] - skeleton_.at[parent];
        return way.norm() > 0 ? Vec3(way.normalized()) : frame_.up;
    }

    void set_capsule(uint32_t j) {
        FlgRigJoint& joint = joints_[j];
        const Vec3& from = skeleton_.at[j];
        store_vec3(from, joint.capsule_start);
        store_vec3(from, joint.capsule_end);
        if (joint.next == FLG_NO_INDEX) return;
        const Vec3& to = skeleton_.at[joint.next];
        const double here = skeleton_.radii[j], there = skeleton_.radii[joint.next];
        const double radius = std::max(std::min(here, there), thinnest * std::max(here, there));
        joint.capsule_radius = static_cast<float>(radius);
        // Along the bone the hull is at least as thick as the mean of its balls' radii: so it is, here.
        const double share = here == there ? 0 : std::clamp((radius - here) / (there - here), 0.0, 1.0);
        store_vec3(there < here ? from : Vec3(from + share * (to - from)), joint.capsule_start);
        store_vec3(there < here ? Vec3(from + share * (to - from)) : to, joint.capsule_end);
    }

    void set_hinge(uint32_t first) {
        uint32_t upper = first, middle = FLG_NO_INDEX, end = FLG_NO_INDEX;
        for (uint32_t j = first; j != FLG_NO_INDEX; j = joints_[j].next) {
            if (joints_[j].place == FLG_LIMB_PLACE_UPPER) upper = j;
            if (joints_[j].place == FLG_LIMB_PLACE_MIDDLE) middle = j;
            if (joints_[j].place == FLG_LIMB_PLACE_END) end = j;
        }
        if (middle == FLG_NO_INDEX) return;
        const Vec3 before = skeleton_.at[middle] - skeleton_.at[upper],
                   after = skeleton_.at[end] - skeleton_.at[middle];
        const Vec3 along = (skeleton_.at[end] - skeleton_.at[upper]).stableNormalized();
        const bool is_leg = joints_[first].limb == FLG_LIMB_LEG;
        const Vec3 normal = before.cross(after);
        const double bend = std::atan2(normal.norm(), before.dot(after));
        Vec3 axis;
        if (!is_leg && bend > bent_elbow && bend < folded) {
            axis = normal.normalized();
        } else if (is_leg) {
            const bool lies = std::abs(along.dot(frame_.left)) > sideways;
            axis = lies ? along.cross(frame_.up) : Vec3(frame_.left - frame_.left.dot(along) * along);
            axis = unit_or(axis, frame_.left);
            // Knees of hind legs point to the front, elbows of front legs to the back, those beside the body up.
            const bool turns_back = !lies && (leg_pairs_ == 1 || joints_[first].pair > 0);
            const double about = bend_about(axis, before, after);
            if (std::abs(about) > bent_knee ? about < 0 : !turns_back) axis = -axis;
        } else {
            axis = unit_or(along.cross(frame_.forward), frame_.left);
        }
        const double bent = std::max(0.0, bend_about(axis, before, after));
        FlgRigJoint& joint = joints_[middle];
        store_vec3(axis, joint.limit_axis);
        joint.limit_swing = 0;
        joint.limit_twist_min = static_cast<float>(-bent);
        joint.limit_twist_max = static_cast<float>(std::max(furthest_bend - bent, least_bend));
    }

    static Vec3 unit_or(const Vec3& v, const Vec3& other) {
        constexpr double vanishes = 1e-3;
        return v.norm() > vanishes ? Vec3(v.normalized()) : other;
    }
    // The angle from one to the other, seen along the axis.
    static double bend_about(const Vec3& axis, const Vec3& from, const Vec3& to) {
        const Vec3 a = from - axis.dot(from) * axis, b = to - axis.dot(to) * axis;
        return std::atan2(axis.dot(a.cross(b)), a.dot(b));
    }

    const RigSkeleton& skeleton_;
    const RigFrame& frame_;
    std::span<FlgRigJoint> joints_;
    uint32_t leg_pairs_ = 0;
};

}  // namespace

void set_limits(const RigSkeleton& skeleton, const RigFrame& frame, std::span<FlgRigJoint> joints) {
    LimitFinder(skeleton, frame, joints).find();
}

Quaternion within_limits(const FlgRigJoint& joint, const Quaternion& rotation) {
    const Vec3 axis = load_vec3(joint.limit_axis).normalized();
    const double about = rotation.vec().dot(axis);
    const double low = joint.limit_twist_min, high = joint.limit_twist_max, most = joint.limit_swing;
    const double twist = std::remainder(2 * std::atan2(about, rotation.w()), 2 * std::numbers::pi);
    const Quaternion swing = rotation * Quaternion(Eigen::AngleAxisd(-twist, axis));
    const Vec3 swung = swing * axis, normal = axis.cross(swung);
    const double angle = std::atan2(normal.norm(), axis.dot(swung));
    if (twist >= low && twist <= high && angle <= most) return rotation;
    const Quaternion twisted(Eigen::AngleAxisd(std::clamp(twist, low, high), axis));
    if (angle <= most) return (swing * twisted).normalized();
    return most == 0 ? twisted : Quaternion(Eigen::AngleAxisd(most, normal.normalized())) * twisted;
}

}  // namespace flg
