// SPDX-License-Identifier: MIT
#include "reference/literal_guide_flow.h"

namespace flg::reference {

namespace {

double polyline_length(const std::vector<Vec3>& points) {
    double length = 0.0;
    for (size_t i = 1; i < points.size(); ++i) length += (points[i] - points[i - 1]).norm();
    return length;
}

}  // namespace

LiteralFlow literal_guide_flow(const std::vector<Vec3>& curve, double alpha, double step_time, uint32_t steps,
                               bool redistribution) {
    LiteralFlow flow;
    flow.points = curve;
    flow.predicted_length = polyline_length(curve);
    const size_t count = curve.size();
    std::vector<Vec3> curvature(count, Vec3::Zero());  // kappa n
    std::vector<double> dual_length(count, 0.0);
    std::vector<double> tangential(count, 0.0);
    for (uint32_t step = 0; step < steps; ++step) {
        std::vector<Vec3>& points = flow.points;
        double integral_2 = 0.0;
        double integral_3 = 0.0;
        for (size_t i = 1; i + 1 < count; ++i) {
            const Vec3 before = points[i] - points[i - 1];
            const Vec3 after = points[i + 1] - points[i];
            dual_length[i] = 0.5 * (before.norm() + after.norm());
            // |t+ - t-| = 2 sin(angle / 2), the length of the segment that closes the gap at a corner offset by 1.
            curvature[i] = (after.normalized() - before.normalized()) / dual_length[i];
            const double kappa = curvature[i].norm();
            integral_2 += kappa * kappa * dual_length[i];
            integral_3 += kappa * kappa * kappa * dual_length[i];
        }
        const double force = integral_3 > 0.0 ? integral_2 / integral_3 : 0.0;  // F'
        const double length = polyline_length(points);
        const double length_rate = (alpha - 1.0) * integral_2;
        // Half the integrand of a point on each of its sides.
        double theta = 0.0;
        double half = 0.0;
        for (size_t i = 1; i + 1 < count; ++i) {
            const double kappa = curvature[i].norm();
            const double turning = kappa * kappa * (1.0 - alpha * kappa * force) * dual_length[i];  // kappa theta_n ds
            theta += half + 0.5 * turning + length_rate / length * (points[i] - points[i - 1]).norm();
            half = 0.5 * turning;
            if (redistribution) tangential[i] = theta;
        }
        std::vector<Vec3> moved = points;
        for (size_t i = 1; i + 1 < count; ++i) {
            const Vec3 tangent = (points[i + 1] - points[i - 1]).normalized();
            const double kappa = curvature[i].norm();
            moved[i] += step_time * ((1.0 - alpha * kappa * force) * curvature[i] + tangential[i] * tangent);
        }
        points.swap(moved);
        flow.time += step_time;
        flow.predicted_length += step_time * length_rate;
    }
    return flow;
}

}  // namespace flg::reference
