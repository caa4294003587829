// SPDX-License-Identifier: MIT
#include "splines/motion/body_inertia.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr double min_share = 1e-2;
// Of the size of the coordinates: points nearer to each other than this are in one place.
constexpr double rounding = 1e-12;

// No two of the f_i may be near 0.
void thicken(std::array<double, 3>& f, double coordinates) {
    const double largest = *std::max_element(f.begin(), f.end());
    if (!(largest > rounding * coordinates)) {
        f = {1, 1, 1};
        return;
    }
    std::array<size_t, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return f[a] != f[b] ? f[a] > f[b] : a < b; });
    f[order[1]] = std::max(f[order[1]], min_share * largest);
}

}  // namespace

BodyInertia inertia_of_points(std::span<const double> points, std::span<const double> masses) {
    const size_t count = points.size() / 3;
    const auto at = [&](size_t i) { return Vec3(points[3 * i], points[3 * i + 1], points[3 * i + 2]); };
    BodyInertia body;
    body.mass = 0;
    double coordinates = 0;
    const Vec3 first = at(0);  // sums of differences lose nothing to a far origin
    for (size_t i = 0; i < count; ++i) {
        const double mass = masses.empty() ? 1 : masses[i];
        body.mass += mass;
        body.barycentre += mass * (at(i) - first);
        coordinates = std::max(coordinates, at(i).cwiseAbs().maxCoeff());
    }
    body.barycentre = first + body.barycentre / body.mass;
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
    body.radius = 0;
    for (size_t i = 0; i < count; ++i) {
        const Vec3 arm = at(i) - body.barycentre;
        body.radius = std::max(body.radius, arm.norm());
        inertia += (masses.empty() ? 1 : masses[i]) * arm * arm.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
    for (int i = 0; i < 3; ++i) {
        body.axes.col(i) = solver.eigenvectors().col(2 - i);
        const double eigenvalue = std::max(solver.eigenvalues()[2 - i], 0.0);
        // A plane of points has no thickness beyond rounding.
        body.f[i] = eigenvalue > 1e-15 * solver.eigenvalues()[2] ? std::sqrt(0.5 * eigenvalue) : 0;
    }
    if (body.axes.determinant() < 0) body.axes.col(2) *= -1;
    thicken(body.f, coordinates * std::sqrt(body.mass));
    return body;
}

BodyInertia inertia_of_box(const Vec3& low, const Vec3& high) {
    BodyInertia body;
    body.barycentre = 0.5 * (low + high);
    body.radius = 0.5 * (high - low).norm();
    for (int i = 0; i < 3; ++i) body.f[i] = 0.5 * std::abs(high[i] - low[i]);
    thicken(body.f, std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()));
    return body;
}

}  // namespace flg
