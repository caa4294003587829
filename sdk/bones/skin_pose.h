// SPDX-License-Identifier: MIT
// Poses of skins: joints turned about their places, as motions from rest; and poses between the keys of an animation.
// Vertices are moved by joints.
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

// Arrays as in FlgSkinView and flgSkinPose; null `rotations` and `translation`: none. Parents come first. A child's
// place is found from its parent's, not from the origin: what is far away from it is as exact.
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

// What moves one vertex: arrays as in FlgSkinView.
struct VertexBinding {
    const uint16_t* joints;  // 4
    const float* weights;    // 4, the largest first, their sum is about 1
};

// A motion: x goes to linear * x + translation.
struct VertexMotion {
    Eigen::Matrix3d linear;
    Vec3 translation;
};

// The mean of the joints' matrices, 12 a joint.
VertexMotion blend_matrices(const VertexBinding& binding, const float* matrices);

// The rigid motion between those of the joints, 8 numbers a joint.
VertexMotion blend_dual_quaternions(const VertexBinding& binding, const float* dual_quaternions);

// A normal as the motion turns it, of length 1. One that becomes zero stays as it was.
Vec3 turned_normal(const VertexMotion& motion, const Vec3& normal);

}  // namespace flg
