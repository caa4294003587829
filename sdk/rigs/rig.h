// SPDX-License-Identifier: MIT
// A rig as hosts hold it: joints with their limbs, in a frame.
#pragma once

#include "bones/skin_pose.h"
#include "filigree/filigree_rig.h"

namespace flg {

struct Rig {
    explicit Rig(const FlgRig& of)
        : view(of), up(load_vec3(of.up)), left(load_vec3(of.left)), forward(load_vec3(of.forward)) {}

    FlgRig view;
    Vec3 up, left, forward;

    uint32_t count() const { return view.joint_count; }
    Vec3 at(uint32_t j) const { return load_vec3(view.joint_positions + 3 * j); }
    uint32_t parent(uint32_t j) const { return view.joint_parents[j]; }
    const FlgRigJoint& joint(uint32_t j) const { return view.joints[j]; }
    bool begins(uint32_t j, FlgLimb limb) const { return joint(j).limb == limb && joint(j).index == 0; }

    // The first joint of a limb; FLG_NO_INDEX: there is none.
    uint32_t first(FlgLimb limb, int32_t side) const {
        for (uint32_t j = 0; j < count(); ++j)
            if (begins(j, limb) && joint(j).side == side) return j;
        return FLG_NO_INDEX;
    }
    // The next joint of the same limb.
    uint32_t next(uint32_t j) const {
        const uint32_t after = joint(j).next;
        const bool goes_on = after != FLG_NO_INDEX && after > j && joint(after).limb == joint(j).limb &&
                             joint(after).index == joint(j).index + 1;
        return goes_on ? after : FLG_NO_INDEX;
    }
    // Where a limb bends; FLG_NO_INDEX: nowhere there.
    uint32_t find(uint32_t first_of_limb, FlgLimbPlace place) const {
        uint32_t j = first_of_limb;
        while (j != FLG_NO_INDEX && joint(j).place != place) j = next(j);
        return j;
    }
    // Where the ways of two joints of one tree to the root meet.
    uint32_t meet(uint32_t a, uint32_t b) const {
        while (a != b) (a > b ? a : b) = parent(a > b ? a : b);
        return a;
    }
    Vec3 direction(uint32_t from, uint32_t to) const {
        const Vec3 way = at(to) - at(from);
        const double length = way.norm();
        return length > 0 ? Vec3(way / length) : Vec3(-up);
    }
};

inline Quaternion turned(const Vec3& axis, double angle) {
    return Quaternion(Eigen::AngleAxisd(angle, axis));
}

}  // namespace flg
