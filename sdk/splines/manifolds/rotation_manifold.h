// SPDX-License-Identifier: MIT
// The rotations of a rigid body as a surface of dimension 3 in R^9 (Hofer, Pottmann 2004, sec. 4.1; Horn, Closed form
// solution of absolute orientation using unit quaternions, 1987).
//
// A point is the three columns of the rotation A, each times the square root of 2 and the body's f_i (body_inertia.h):
// then the Euclidean metric of R^9 is the rotational part of the metric (9). Two bodies' rotations between the same two
// positions differ, the barycentre's path does not: it moves as a point in space, apart from this.
//
// Invariants
// - The basis of tangents turns with the body: it is the rotation about each principal axis, at unit length. It is
//   orthogonal as it stands because the axes are principal ones, and smooth everywhere.
// - A column whose f_i is 0 is all zeros; the two others tell the rotation.
#pragma once

#include <array>

#include "core/vec.h"
#include "splines/manifolds/manifold.h"

namespace flg {

class RotationManifold final : public Manifold {
public:
    // f_1, f_2, f_3: half the axes of the body's inertia ellipsoid, metres, at least 0; at most one of them is 0, and
    // not one is so large that its square is not finite.
    explicit RotationManifold(const std::array<double, 3>& f);

    void point_of(const Eigen::Matrix3d& rotation, double* x) const;
    // Of a point on the manifold.
    Eigen::Matrix3d rotation_of(const double* x) const;

    // To the nearest point; where several are nearest, to one of them. Only the origin, and what is not finite, has
    // none. Some 0.2 us near the manifold, 1 us anywhere.
    bool project(double* x, double* hint) const override;
    void tangent_basis(const double* x, double* hint, double* basis) const override;
    void second_form(const double* x, double* hint, const double* basis, const double* force,
                     double* form) const override;

private:
    std::array<double, 3> scale_;    // of the columns
    std::array<double, 3> stretch_;  // 1 / length of the velocity of a turn about axis i at one radian a second
    std::array<int, 3> order_;       // the columns, the largest first
};

// From `start`, a rotation: the rotation A with the greatest trace of A^T m. where the columns of m are those of an
// affine map, weighted, the one nearest to it, whatever the sign of its determinant. False if m is 0 or not finite.
bool nearest_rotation(const Eigen::Matrix3d& m, const Eigen::Matrix3d& start, Eigen::Matrix3d& rotation);

}  // namespace flg
