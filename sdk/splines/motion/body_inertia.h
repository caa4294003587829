// SPDX-License-Identifier: MIT
// What the motion of a rigid body depends on: its barycentre and its inertia (Hofer, Pottmann 2004, sec. 4.1).
//
// The squared distance of two positions is the sum of those of the body's feature points. It is
//     mass |c - d|^2 + 2 sum f_i^2 |a_i - b_i|^2
// with the barycentre at c and d, and the principal axes at a_i and b_i. The paper's (9) has 6 for the mass: the six
// points that stand for the body have its barycentre and its inertia matrix but weigh 6, so that (9) holds for 6
// feature points only.
//
// Bodies that are thin: where all points lie on a line, turning about it costs nothing, and no motion about it is
// better than another. Such a body gets a second f_i of 1/100 of the first; so does each that is thinner than that in
// two directions. Points that all lie in one place are no body: all f_i are made 1 metre, and turning costs the same
// about every axis.
#pragma once

#include <array>
#include <span>

#include "core/vec.h"

namespace flg {

struct BodyInertia {
    double mass = 6;                 // of all feature points; > 0
    Vec3 barycentre = Vec3::Zero();  // in the body's coordinates, metres
    Eigen::Matrix3d axes =
        Eigen::Matrix3d::Identity();   // columns, principal axes in the body's coordinates, right-handed
    double radius = 1;                 // the farthest point's distance from the barycentre, metres
    std::array<double, 3> f{1, 1, 1};  // half axes of the inertia ellipsoid, metres; 2 f_i^2 are eigenvalues of (8)
};

// Of feature points: 3 numbers each, and a mass each, or none: 1 each. At least one point; finite; masses at least 0,
// one above. The largest f_i comes first. Cost: some ns a point.
BodyInertia inertia_of_points(std::span<const double> points, std::span<const double> masses);

// Of a solid box of mass 6: its half sides are the f_i. The same as of the middles of its six faces. Sides at least 0,
// metres.
BodyInertia inertia_of_box(const Vec3& low, const Vec3& high);

}  // namespace flg
