// SPDX-License-Identifier: MIT
// How far a rotation is beyond a joint's limits.
#pragma once

#include <algorithm>
#include <cmath>

#include "rigs/rig.h"

namespace flg::test {

// Radians; 0 or less: it is within them.
inline double beyond_limit(const FlgRigJoint& joint, const Quaternion& rotation) {
    const Vec3 axis = load_vec3(joint.limit_axis), swung = rotation * axis;
    const double swing = std::atan2(axis.cross(swung).norm(), axis.dot(swung));
    const double twist = std::remainder(2 * std::atan2(rotation.vec().dot(axis), rotation.w()), 2 * std::acos(-1.0));
    return std::max({swing - double{joint.limit_swing}, twist - double{joint.limit_twist_max},
                     double{joint.limit_twist_min} - twist});
}

}  // namespace flg::test
