// SPDX-License-Identifier: MIT
#include "splines/manifolds/quadric_fit.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Heights are exact up to third derivatives, normals of neighbours are means of triangles' ones.
constexpr double normal_weight = 0.1, own_normal_weight = 0.01;
constexpr double through_weight = 1e4;
// Keeps what neighbours say nothing about near 0.
constexpr double ridge = 1e-6;
// Beyond these the surface is creased, or the neighbours are too far apart to tell: cosine of a neighbour's normal,
// slope of the fitted plane, and the part of the squared heights that is not explained.
constexpr double min_cosine = 0.5, max_slope = 0.35, max_unexplained = 0.25;
// Of the spacing, squared: heights below are noise anyway.
constexpr double flat_height = 1e-4;

// Of neighbours of a smooth fit; `square`: how far they are, in spacings.
double smooth_weight(double square) {
    const double closeness = std::max(0.0, 1 - square / (quadric_reach * quadric_reach));
    return closeness * closeness;
}

}  // namespace

QuadricFit::QuadricFit(const Vec3& place, const Vec3& normal, double spacing, QuadricKind kind)
    : place_(place), normal_(normal), per_spacing_(1 / spacing), kind_(kind) {
    u_ = normal.unitOrthogonal();
    v_ = normal.cross(u_);
    add_row({1, 0, 0, 0, 0, 0}, 0, kind == QuadricKind::through ? through_weight : 1);
    add_row({0, 1, 0, 0, 0, 0}, 0, own_normal_weight);
    add_row({0, 0, 1, 0, 0, 0}, 0, own_normal_weight);
    for (size_t i = 0; i < unknowns; ++i) matrix_[i * unknowns + i] += ridge;
}

void QuadricFit::add_row(const Row& row, double right, double weight) {
    for (size_t i = 0; i < unknowns; ++i) {
        const double scaled = weight * row[i];
        if (scaled == 0) continue;
        for (size_t j = 0; j <= i; ++j) matrix_[i * unknowns + j] += scaled * row[j];
        right_[i] += scaled * right;
    }
    squares_ += weight * right * right;
}

Vec3 QuadricFit::local(const Vec3& point) const {
    const Vec3 d = per_spacing_ * (point - place_);
    return Vec3(u_.dot(d), v_.dot(d), normal_.dot(d));
}

void QuadricFit::add_point(const Vec3& point) {
    const Vec3 p = local(point);
    const double u = p[0], v = p[1], square = p.squaredNorm();
    if (!(square > 0)) return;
    // Far ones count less: what is left out grows with the third power.
    const double weight = kind_ == QuadricKind::smooth ? smooth_weight(square) : 1 / (square * (0.25 + square));
    add_row({1, u, v, 0.5 * u * u, u * v, 0.5 * v * v}, p[2], weight);
    weights_ += weight;
}

void QuadricFit::add_normal(const Vec3& point, const Vec3& normal) {
    const double up = normal_.dot(normal);
    if (!(up > min_cosine)) {
        creased_ = kind_ != QuadricKind::smooth;
        return;
    }
    const Vec3 p = local(point);
    const double square = p.squaredNorm();
    const double weight = normal_weight * (kind_ == QuadricKind::smooth ? smooth_weight(square) : 1 / (0.25 + square));
    add_row({0, 1, 0, p[0], p[1], 0}, -u_.dot(normal) / up, weight);
    add_row({0, 0, 1, 0, p[0], p[1]}, -v_.dot(normal) / up, weight);
}

BentNormal QuadricFit::solve() const {
    BentNormal result;
    result.normal = normal_;
    // Cholesky's factorization; the ridge keeps it regular.
    std::array<double, unknowns* unknowns> l = matrix_;
    Row x = right_;
    for (size_t i = 0; i < unknowns; ++i) {
        for (size_t j = 0; j <= i; ++j) {
            double sum = l[i * unknowns + j];
            for (size_t k = 0; k < j; ++k) sum -= l[i * unknowns + k] * l[j * unknowns + k];
            l[i * unknowns + j] = i == j ? std::sqrt(std::max(sum, ridge * ridge)) : sum / l[j * unknowns + j];
        }
        for (size_t k = 0; k < i; ++k) x[i] -= l[i * unknowns + k] * x[k];
        x[i] /= l[i * unknowns + i];
    }
    for (size_t i = unknowns; i-- > 0;) {
        for (size_t k = i + 1; k < unknowns; ++k) x[i] -= l[k * unknowns + i] * x[k];
        x[i] /= l[i * unknowns + i];
    }
    const double mean = 0.5 * (x[3] + x[5]), half = 0.5 * (x[3] - x[5]);
    const double swing = std::sqrt(half * half + x[4] * x[4]);
    const double largest = std::abs(mean) + swing;
    result.curvature = largest * per_spacing_;
    if (creased_ || x[1] * x[1] + x[2] * x[2] > max_slope * max_slope) return result;

    // The part of the squares that the quadric explains is x . right.
    double unexplained = squares_;
    for (size_t i = 0; i < unknowns; ++i) unexplained -= x[i] * right_[i];
    const bool bad = unexplained > max_unexplained * squares_ + flat_height * weights_;
    if (bad && kind_ == QuadricKind::through) return result;
    result.height = kind_ == QuadricKind::through ? 0 : x[0] / per_spacing_;
    result.normal = (normal_ - x[1] * u_ - x[2] * v_).normalized();
    if (bad) return result;
    // Curvatures of a graph over its tangent plane; f counts the other way, so that outside is above.
    const double scale = -per_spacing_;
    Eigen::Matrix3d b = scale * (x[3] * u_ * u_.transpose() + x[4] * (u_ * v_.transpose() + v_ * u_.transpose()) +
                                 x[5] * v_ * v_.transpose());
    const Vec3& n = result.normal;
    const Vec3 bn = b * n;
    b += n.dot(bn) * n * n.transpose() - bn * n.transpose() - n * bn.transpose();
    // Along the normal, what makes spheres and cylinders come out exactly.
    b += scale * (mean < 0 ? mean - swing : mean + swing) * n * n.transpose();
    result.bend = {b(0, 0), b(0, 1), b(0, 2), b(1, 1), b(1, 2), b(2, 2)};
    return result;
}

}  // namespace flg
