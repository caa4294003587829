// SPDX-License-Identifier: MIT
// How far to go along a tangent of a constraint surface towards the point whose nearest point on it is sought:
// Algorithm 1 of Hofer, Pottmann: Energy-minimizing splines in manifolds (2004), a development of the cone of
// footpoints.
//
// Departures. The radius of the circle that touches the xi-axis in the origin and passes through (xi, eta) is
// (xi^2 + eta^2) / (2 eta), misprinted in the paper. With the signs of its d and kappa (6) would not be 1 / |d kappa -
// 1| where p lies inside of the circle; what it stands for, rho / |p - m| (Remark 3 and Fig. 4), is right on either
// side.
#pragma once

#include <algorithm>
#include <cmath>

namespace flg {

// Distances in the norm of the energy.
struct FootpointCone {
    double tangent;          // |p_T - x_c|, above 0
    double height;           // |p_T - p|
    double last_to_p;        // |x_- - p|
    double last_to_current;  // |x_- - x_c|
    double last_to_tangent;  // |x_- - p_T|
};

// The stepsize s, or 0 where the three points are too near to each other, or too nearly on one line, to tell a
// curvature.
inline double footpoint_stepsize(const FootpointCone& cone) {
    const double to_p = std::hypot(cone.tangent, cone.height);
    if (!(cone.last_to_current > 1e-9 * to_p)) return 0;
    const double square = cone.last_to_current * cone.last_to_current;
    const double along = (square + to_p * to_p - cone.last_to_p * cone.last_to_p) / (2 * to_p);
    const double across = std::sqrt(std::max(0.0, square - along * along));
    // p in the developed plane: (tangent, height); x_- on either side of the line to it.
    const double cosine = cone.tangent / to_p, sine = cone.height / to_p;
    double xi = 0, eta = 0, distortion = HUGE_VAL;
    for (const double side : {across, -across}) {
        const double x = along * cosine - side * sine, y = along * sine + side * cosine;
        const double error = std::abs(std::hypot(x - cone.tangent, y) - cone.last_to_tangent);
        if (error < distortion) {
            distortion = error;
            xi = x;
            eta = y;
        }
    }
    if (std::abs(eta) <= 1e-12 * cone.last_to_current) return 1;
    const double radius = (xi * xi + eta * eta) / (2 * eta);
    const double to_centre = std::hypot(cone.tangent, cone.height - radius);
    return to_centre > 0 ? std::abs(radius) / to_centre : 0;
}

}  // namespace flg
