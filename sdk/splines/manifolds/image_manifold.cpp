// SPDX-License-Identifier: MIT
#include "splines/manifolds/image_manifold.h"

#include <algorithm>
#include <array>

#include "core/vec.h"

namespace flg {

namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;

// Of the size: a correction that is longer is none.
constexpr double max_correction = 0.02;

}  // namespace

ImageManifold::ImageManifold(const Hypersurface& surface, double weight)
    : Manifold(6, 2, surface.hint_size(), surface.size()), surface_(surface), weight_(weight) {}

void ImageManifold::lift(const double* place, double* hint, double* x) const {
    double value = 0;
    Vec3 gradient;
    if (!surface_.evaluate(place, hint, &value, gradient.data(), nullptr)) gradient = Vec3::UnitZ();
    const Vec3 normal = weight_ * gradient.normalized();
    for (int i = 0; i < 3; ++i) {
        x[i] = place[i];
        x[3 + i] = normal[i];
    }
}

bool ImageManifold::project(double* x, double* hint) const {
    const Vec6 from = Eigen::Map<const Vec6>(x);
    Vec3 place = from.head<3>();
    if (!surface_.project(place.data(), hint)) return false;
    Vec6 lifted;
    lift(place.data(), hint, lifted.data());
    if (weight_ > 0) {
        Eigen::Matrix<double, 6, 2> basis;
        tangent_basis(lifted.data(), hint, basis.data());
        const Vec6 along = basis * (basis.transpose() * (from - lifted));
        if (along.head<3>().norm() <= max_correction * size()) {
            Vec3 corrected = place + along.head<3>();
            if (surface_.project(corrected.data(), hint)) place = corrected;
            lift(place.data(), hint, lifted.data());
        }
    }
    std::copy_n(lifted.data(), 6, x);
    return true;
}

// Along a tangent b the normal changes by the tangential part of F'' b over |F'|.
void ImageManifold::tangent_basis(const double* x, double* hint, double* basis) const {
    Eigen::Matrix<double, 3, 2> flat;
    surface_.tangent_basis(x, hint, flat.data());
    double value = 0;
    Vec3 gradient = Vec3::UnitZ();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    if (!surface_.evaluate(x, hint, &value, gradient.data(), second.data())) second.setZero();
    const double length = gradient.norm();
    const Vec3 normal = gradient / length;
    Eigen::Map<Eigen::Matrix<double, 6, 2>> lifted(basis);
    for (int j = 0; j < 2; ++j) {
        const Vec3 turned = second * flat.col(j) / length;
        lifted.col(j).head<3>() = flat.col(j);
        lifted.col(j).tail<3>() = weight_ * (turned - normal.dot(turned) * normal);
    }
    lifted.col(0).normalize();
    lifted.col(1) -= lifted.col(0).dot(lifted.col(1)) * lifted.col(0);
    lifted.col(1).normalize();
}

}  // namespace flg
