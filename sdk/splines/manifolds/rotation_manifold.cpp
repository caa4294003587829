// SPDX-License-Identifier: MIT
#include "splines/manifolds/rotation_manifold.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

using Mat3 = Eigen::Matrix3d;
using Mat4 = Eigen::Matrix4d;

constexpr int max_newton_rounds = 8;
// Radians. The turn that was this small led to the rotation up to its square.
constexpr double last_turn = 1e-9;
// Newton's method is for the neighbourhood: a turn by more than this is left to the quaternions.
constexpr double max_turn = 1.0;
constexpr int max_sweeps = 12;

// Cayley's rotation about `turn` by 2 atan(|turn| / 2).
Mat3 turned(const Vec3& turn) {
    const Vec3 t = 0.5 * turn;
    const double square = t.squaredNorm(), scale = 2 / (1 + square);
    Mat3 m = scale * t * t.transpose();
    m.diagonal().array() += (1 - square) / (1 + square);
    const Vec3 s = scale * t;
    m(0, 1) -= s.z(), m(1, 0) += s.z();
    m(0, 2) += s.y(), m(2, 0) -= s.y();
    m(1, 2) -= s.x(), m(2, 1) += s.x();
    return m;
}

// Solves h x = g by Cholesky; false unless h is positive definite.
bool solve(const Mat3& h, const Vec3& g, double scale, Vec3& x) {
    constexpr double relative_pivot = 1e-13;
    const double least = relative_pivot * scale;
    if (!(h(0, 0) > least)) return false;
    const double l10 = h(1, 0) / h(0, 0), l20 = h(2, 0) / h(0, 0);
    const double d1 = h(1, 1) - l10 * h(1, 0);
    if (!(d1 > least)) return false;
    const double m21 = h(2, 1) - l20 * h(1, 0), l21 = m21 / d1;
    const double d2 = h(2, 2) - l20 * h(2, 0) - l21 * m21;
    if (!(d2 > least)) return false;
    const double y1 = g[1] - l10 * g[0], y2 = g[2] - l20 * g[0] - l21 * y1;
    x[2] = y2 / d2;
    x[1] = y1 / d1 - l21 * x[2];
    x[0] = g[0] / h(0, 0) - l10 * x[1] - l20 * x[2];
    return true;
}

// The trace of A^T m as a function of the turn t that follows A, with b = A^T m: tr b + t g - t H t / 2. A quadratic
// form of the quaternion has no greatest value but the global one, so where Newton's method ends with H positive
// definite it is right.
bool newton(const Mat3& m, Mat3& a) {
    for (int round = 0; round < max_newton_rounds; ++round) {
        const Mat3 b = a.transpose() * m;
        const Vec3 g(b(2, 1) - b(1, 2), b(0, 2) - b(2, 0), b(1, 0) - b(0, 1));
        const double trace = b.trace();
        Mat3 h = -0.5 * (b + b.transpose());
        h.diagonal().array() += trace;
        Vec3 turn;
        if (!solve(h, g, std::abs(trace), turn)) return false;
        const double length = turn.norm();
        if (!(length <= max_turn)) return false;
        a = a * turned(turn);
        if (length <= last_turn) return true;
    }
    return false;
}

// Horn: the eigenvector with the greatest eigenvalue of a symmetric matrix of rank 4, here by Jacobi's rotations.
Mat3 by_quaternion(const Mat3& m) {
    const double xy = m(1, 0) + m(0, 1), yz = m(2, 1) + m(1, 2), zx = m(0, 2) + m(2, 0);
    const Vec3 g(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
    const double x = m(0, 0), y = m(1, 1), z = m(2, 2);
    Mat4 n;
    n << x + y + z, g.x(), g.y(), g.z(),  //
        g.x(), x - y - z, xy, zx,         //
        g.y(), xy, y - x - z, yz,         //
        g.z(), zx, yz, z - x - y;
    Mat4 vectors = Mat4::Identity();
    for (int sweep = 0; sweep < max_sweeps; ++sweep) {
        double rest = 0;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) rest = std::max(rest, std::abs(n(i, j)));
        }
        if (rest <= 1e-16 * n.diagonal().cwiseAbs().maxCoeff()) break;
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < i; ++j) {
                if (n(i, j) == 0) continue;
                const double ratio = (n(j, j) - n(i, i)) / (2 * n(i, j));
                const double t = (ratio < 0 ? -1 : 1) / (std::abs(ratio) + std::hypot(1.0, ratio));
                const double c = 1 / std::sqrt(1 + t * t), s = t * c;
                for (int k = 0; k < 4; ++k) {
                    const double p = n(k, i), q = n(k, j);
                    n(k, i) = c * p - s * q;
                    n(k, j) = s * p + c * q;
                }
                for (int k = 0; k < 4; ++k) {
                    const double p = n(i, k), q = n(j, k);
                    n(i, k) = c * p - s * q;
                    n(j, k) = s * p + c * q;
                    const double v = vectors(k, i), w = vectors(k, j);
                    vectors(k, i) = c * v - s * w;
                    vectors(k, j) = s * v + c * w;
                }
            }
        }
    }
    int best = 0;
    for (int i = 1; i < 4; ++i) {
        if (n(i, i) > n(best, best)) best = i;
    }
    return Eigen::Quaterniond(vectors(0, best), vectors(1, best), vectors(2, best), vectors(3, best))
        .normalized()
        .toRotationMatrix();
}

}  // namespace

bool nearest_rotation(const Mat3& m, const Mat3& start, Mat3& rotation) {
    const double size = m.cwiseAbs().maxCoeff();
    if (!(size > 0) || !std::isfinite(size)) return false;
    rotation = start;
    if (newton(m, rotation)) return true;
    rotation = by_quaternion(m / size);
    return true;
}

RotationManifold::RotationManifold(const std::array<double, 3>& f)
    : Manifold(9, 3, 0,
               2 * std::sqrt(2 * (f[0] * f[0] + f[1] * f[1] + f[2] * f[2] -
                                  std::min({f[0] * f[0], f[1] * f[1], f[2] * f[2]})))) {
    for (size_t i = 0; i < 3; ++i) {
        const double g = f[(i + 1) % 3], h = f[(i + 2) % 3];
        scale_[i] = std::sqrt(2.0) * f[i];
        stretch_[i] = 1 / std::sqrt(2 * (g * g + h * h));
    }
    order_ = {0, 1, 2};
    std::sort(order_.begin(), order_.end(), [&](int a, int b) { return f[a] != f[b] ? f[a] > f[b] : a < b; });
}

void RotationManifold::point_of(const Mat3& rotation, double* x) const {
    for (int i = 0; i < 3; ++i) Eigen::Map<Vec3>(x + 3 * i) = scale_[i] * rotation.col(i);
}

// The columns that have weight tell the third. For points near the manifold the columns are made orthogonal.
Mat3 RotationManifold::rotation_of(const double* x) const {
    const int i = order_[0], j = order_[1], k = order_[2];
    Mat3 a;
    const Vec3 first = Eigen::Map<const Vec3>(x + 3 * i).normalized();
    const Vec3 second = Eigen::Map<const Vec3>(x + 3 * j);
    a.col(i) = first;
    a.col(j) = (second - second.dot(first) * first).normalized();
    a.col(k) = a.col((k + 1) % 3).cross(a.col((k + 2) % 3));
    return a;
}

bool RotationManifold::project(double* x, double*) const {
    Mat3 m;
    for (int i = 0; i < 3; ++i) m.col(i) = scale_[i] * Eigen::Map<const Vec3>(x + 3 * i);
    Mat3 start = rotation_of(x);
    if (!start.allFinite() || !(std::abs(start.squaredNorm() - 3) < 1e-6)) start.setIdentity();
    Mat3 rotation;
    if (!nearest_rotation(m, start, rotation)) return false;
    point_of(rotation, x);
    return true;
}

void RotationManifold::tangent_basis(const double* x, double*, double* basis) const {
    const Mat3 a = rotation_of(x);
    std::fill_n(basis, 27, 0.0);
    // A turn about axis j takes axis j + 1 towards axis j + 2, and that one away from axis j + 1.
    for (int j = 0; j < 3; ++j) {
        const int p = (j + 1) % 3, q = (j + 2) % 3;
        Eigen::Map<Vec3>(basis + 9 * j + 3 * p) = scale_[p] * stretch_[j] * a.col(q);
        Eigen::Map<Vec3>(basis + 9 * j + 3 * q) = -scale_[q] * stretch_[j] * a.col(p);
    }
}

// With turns v and w that follow A, A (v^ w^ + w^ v^) / 2 is the second derivative, and its part normal to the manifold
// the form.
void RotationManifold::second_form(const double* x, double*, const double* basis, const double* force,
                                   double* form) const {
    const Mat3 a = rotation_of(x);
    Eigen::Matrix<double, 9, 1> normal = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(force);
    for (int j = 0; j < 3; ++j) {
        const Eigen::Map<const Eigen::Matrix<double, 9, 1>> tangent(basis + 9 * j);
        normal -= Eigen::Map<const Eigen::Matrix<double, 9, 1>>(force).dot(tangent) * tangent;
    }
    Mat3 g;
    for (int i = 0; i < 3; ++i) g.col(i) = scale_[i] * (a.transpose() * normal.segment<3>(3 * i));
    const double trace = g.trace();
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            const double along = 0.5 * (g(i, j) + g(j, i)) - (i == j ? trace : 0);
            form[3 * i + j] = along * stretch_[i] * stretch_[j];
        }
    }
}

}  // namespace flg
