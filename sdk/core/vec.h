// SPDX-License-Identifier: MIT
// Vectors. Computation is in double, columns that hosts and GPUs see are in float.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace flg {

using Vec3 = Eigen::Vector3d;

inline Vec3 load_vec3(const float* p) {
    return Vec3(p[0], p[1], p[2]);
}

inline void store_vec3(const Vec3& v, float* p) {
    p[0] = static_cast<float>(v.x());
    p[1] = static_cast<float>(v.y());
    p[2] = static_cast<float>(v.z());
}

}  // namespace flg
