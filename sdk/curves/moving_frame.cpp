// SPDX-License-Identifier: MIT
#include "curves/moving_frame.h"

#include <Eigen/Geometry>
#include <cmath>

namespace flg {

double angle_about(const Vec3& axis, const Vec3& from, const Vec3& to) {
    return std::atan2(axis.dot(from.cross(to)), from.dot(to));
}

Vec3 turned_about(const Vec3& axis, const Vec3& vector, double angle_rad) {
    return std::cos(angle_rad) * vector + std::sin(angle_rad) * axis.cross(vector);
}

}  // namespace flg
