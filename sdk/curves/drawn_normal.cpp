// SPDX-License-Identifier: MIT
#include "curves/drawn_normal.h"

#include <cmath>

namespace flg {

namespace {

constexpr double along_cosine = 0.95;  // an axis nearer to the direction gives no normal

Vec3 across(const Vec3& axis, const Vec3& tangent) {
    return (axis - axis.dot(tangent) * tangent).normalized();
}

}  // namespace

Vec3 turned_by(const float* quaternion, const Vec3& v) {
    const Vec3 axis(quaternion[0], quaternion[1], quaternion[2]);
    const double w = quaternion[3];
    const double size_sq = axis.squaredNorm() + w * w;
    if (!(size_sq > 0)) return Vec3::Zero();
    return v + (2.0 / size_sq) * axis.cross(axis.cross(v) + w * v);
}

Vec3 drawn_normal(const float* orientation, const Vec3& tangent) {
    const Vec3 up = orientation ? turned_by(orientation, Vec3::UnitY()) : Vec3::Zero();
    if (!up.isZero(0)) {
        const bool along = std::abs(up.dot(tangent)) >= along_cosine;
        return across(along ? turned_by(orientation, Vec3::UnitX()) : up, tangent);
    }
    int furthest = 0;
    tangent.cwiseAbs().minCoeff(&furthest);
    return across(Vec3::Unit(furthest), tangent);
}

}  // namespace flg
