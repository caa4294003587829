// SPDX-License-Identifier: MIT
#include "splines/mesh_creases.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Of the largest one: a smaller eigenvalue is that of a direction along the crease.
constexpr double least_spread = 0.05;
// A crease is a knife if its middle normal leans against its sides' by more than 75 degrees: 1 / cosine.
constexpr double sharpest = 3.9;

}  // namespace

// The middle c = place - rho u of what touches all planes n_i . (x - place) = 0 from below has n_i . u = 1, along the
// normals' span; the surface then has the normal u / |u|.
bool CreaseRounding::round(double length, double radius, OrientedSample& sample) const {
    if (convex_ == concave_) return false;
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    solver.computeDirect(planes_);
    const Vec3 spread = solver.eigenvalues();
    Vec3 middle = Vec3::Zero();
    Eigen::Matrix3d across = Eigen::Matrix3d::Zero();
    int rank = 0;
    for (int i = 0; i < 3; ++i) {
        if (!(spread[i] > least_spread * spread[2])) continue;
        const Vec3 axis = solver.eigenvectors().col(i);
        middle += axis * (axis.dot(sum_) / spread[i]);
        across += axis * axis.transpose();
        ++rank;
    }
    const double lean = middle.norm();
    if (rank < 2 || !(lean > 1) || lean > sharpest) return false;
    const double tangent = std::sqrt((lean * lean - 1) / (rank - 1));
    const double rho = length / std::max(1.0, tangent);
    const double side = convex_ ? 1 : -1;
    const Vec3 normal = middle / lean, at = place_ - side * rho * (lean - 1) * normal;
    const Eigen::Matrix3d bend = side / rho * across;
    sample = {{at.x(), at.y(), at.z()},
              {normal.x(), normal.y(), normal.z()},
              {bend(0, 0), bend(0, 1), bend(0, 2), bend(1, 1), bend(1, 2), bend(2, 2)},
              radius};
    return true;
}

}  // namespace flg
