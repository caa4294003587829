// SPDX-License-Identifier: MIT
// Vertices moved by joints.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace flg {

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
