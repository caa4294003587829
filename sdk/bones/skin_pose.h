// SPDX-License-Identifier: MIT
// Poses of skins: joints turned about their places, as motions from rest; and poses between the keys of an animation.
#pragma once

#include <cstdint>
#include <span>

#include "core/vec.h"

namespace flg {

using Quaternion = Eigen::Quaterniond;

// From rest to a pose: x goes to rotation * x + translation.
struct JointMotion {
    Quaternion rotation;
    Vec3 translation;
};

// Arrays as in FlgSkinView and flgSkinPose; null `rotations` and `translation`: none. Parents come first. A child's place is
// found from its parent's, not from the origin: what is far away from it is as exact.
void pose_joints(const float* joint_positions, const uint32_t* joint_parents, const float* rotations,
                 const float* translation, std::span<JointMotion> out);

void store_matrix(const JointMotion& motion, float* out);           // 12: three rows
void store_dual_quaternion(const JointMotion& motion, float* out);  // 8: real, then dual part

// Of length 1, between two of length 1, `share` of 0 to 1 of the short way.
Quaternion turn_between(const Quaternion& from, const Quaternion& to, double share);

// x, y, z, w.
inline Quaternion load_quaternion(const float* q) {
    return Quaternion(q[3], q[0], q[1], q[2]).normalized();
}

inline void store_quaternion(const Quaternion& q, float* out) {
    out[0] = static_cast<float>(q.x());
    out[1] = static_cast<float>(q.y());
    out[2] = static_cast<float>(q.z());
    out[3] = static_cast<float>(q.w());
}

}  // namespace flg
