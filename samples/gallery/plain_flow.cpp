// SPDX-License-Identifier: MIT
// Minarcik, Fiser, Sykora, sec. 4.1, with theta_t = 0: Euler steps of d gamma / dt = kappa n on unevenly spaced points, by the second
// difference for such points. Nothing keeps the points apart: where the curve bends most they gather, and the step that
// is stable falls with the square of their smallest distance.
#include "gallery/plain_flow.h"

#include <algorithm>

#include "scenes/vector.h"

namespace flg::gallery {
namespace {

using scenes::Vector;

constexpr uint32_t kMostSteps = 20'000;
constexpr double kStableShare = 0.25;  // of the squared smallest distance

double polyline_length(const std::vector<Vector>& points) {
    double sum = 0.0;
    for (size_t i = 1; i < points.size(); ++i) sum += length(points[i] - points[i - 1]);
    return sum;
}

}  // namespace

scenes::Curve plain_flow(const scenes::Curve& curve, double length_share) {
    std::vector<Vector> points;
    for (const scenes::Point& p : curve.points) points.push_back(scenes::to_vector(p));
    const double wanted = length_share * polyline_length(points);
    // Points that have come this close take no smaller steps; they stay where they gathered.
    const double smallest = 0.05 * polyline_length(points) / static_cast<double>(points.size());
    for (uint32_t step = 0; step < kMostSteps && polyline_length(points) > wanted; ++step) {
        double nearest = polyline_length(points);
        for (size_t i = 1; i < points.size(); ++i) nearest = std::min(nearest, length(points[i] - points[i - 1]));
        const double time = kStableShare * std::max(nearest, smallest) * std::max(nearest, smallest);
        std::vector<Vector> moved = points;
        for (size_t i = 1; i + 1 < points.size(); ++i) {
            const Vector before = points[i] - points[i - 1], after = points[i + 1] - points[i];
            const double a = std::max(length(before), smallest), b = std::max(length(after), smallest);
            const Vector curvature = (2.0 / (a + b)) * ((1.0 / b) * after - (1.0 / a) * before);
            const Vector tangent = unit(points[i + 1] - points[i - 1]);
            moved[i] = points[i] + time * (curvature - dot(curvature, tangent) * tangent);
        }
        points = std::move(moved);
    }
    scenes::Curve flowed;
    for (const Vector& p : points) flowed.points.push_back(to_point(p));
    return flowed;
}

}  // namespace flg::gallery
