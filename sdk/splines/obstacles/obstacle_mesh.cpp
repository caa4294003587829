// SPDX-License-Identifier: MIT
#include "splines/obstacles/obstacle_mesh.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double sampling_error = 1;              // cells, generously: so far off is the spline at most
constexpr double min_layer = 4, smooth_from = 3;  // cells: nearer to the mesh the distance's crease is felt

double checked_depth(const SampledDistance& distance) {
    if (!(distance.deepest > 0)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a distance that is to be a solid's has no sign");
    }
    return 0.5 * distance.deepest;
}

double checked_epsilon(const SampledDistance& distance, double epsilon) {
    const double least = min_layer * distance.grid.spacing;
    if (!(epsilon >= least && epsilon < distance.reach)) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a layer has epsilon %g, it must be %g at least and less than %g",
                      epsilon, least, distance.reach);
    }
    return epsilon;
}

Obstacle::Box wider(Obstacle::Box box, double by) {
    for (double& x : box.lower) x -= by;
    for (double& x : box.upper) x += by;
    return box;
}

// Of x, which lies outside of the box.
double from_box(const Obstacle::Box& box, const double* x, double* gradient, double* second) {
    double to[3], square = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        to[k] = x[k] - std::clamp(x[k], box.lower[k], box.upper[k]);
        square += to[k] * to[k];
    }
    const double away = std::sqrt(square);
    for (uint32_t k = 0; k < 3 && gradient != nullptr; ++k) gradient[k] = to[k] / away;
    for (uint32_t i = 0; i < 9 && second != nullptr; ++i) {
        const double a = to[i / 3], b = to[i % 3];
        second[i] = a == 0 || b == 0 ? 0 : ((i % 4 == 0 ? 1 : 0) - a * b / square) / away;
    }
    return away;
}

}  // namespace

MeshObstacle::MeshObstacle(const SampledDistance& distance, TriangleSolid triangles)
    : Obstacle(3, wider(distance.box, 0.1 * distance.grid.spacing), true, checked_depth(distance), distance.reach),
      distance_(distance),
      triangles_(std::move(triangles)) {}

double MeshObstacle::evaluate(const double* x, double* gradient, double* second) const {
    double value = 0;
    if (distance_.evaluate(x, &value, gradient, second)) return value;
    return from_box(distance_.box, x, gradient, second);
}

double MeshObstacle::evaluate_exactly(const double* x, double* gradient, double* second, double exact_below) const {
    double sampled = 0;
    if (!distance_.evaluate(x, &sampled, nullptr, nullptr)) return from_box(distance_.box, x, gradient, second);
    const double error = sampling_error * distance_.grid.spacing;
    // Where that will do.
    if (sampled > exact_below + 4 * error && gradient == nullptr && second == nullptr) return sampled - error;
    TriangleSolid::Nearest nearest = triangles_.nearest(x, std::abs(sampled) + error);
    if (nearest.triangle == no_index) nearest = triangles_.nearest(x, std::numeric_limits<double>::infinity());
    const bool inside = std::abs(sampled) > error ? sampled < 0 : triangles_.holds(x);
    const double value = inside ? -nearest.away : nearest.away;
    const Vec3 outwards = nearest.away > 0 ? Vec3(nearest.foot.to / value) : triangles_.normal(nearest.triangle);
    if (gradient != nullptr) std::copy_n(outwards.data(), 3, gradient);
    if (second == nullptr) return value;
    Eigen::Map<Eigen::Matrix3d> form(second);
    form.setZero();
    if (nearest.foot.on == TriangleFoot::On::face || !(nearest.away > 0)) return value;
    form = Eigen::Matrix3d::Identity() - outwards * outwards.transpose();
    if (nearest.foot.on == TriangleFoot::On::edge) {
        const Vec3 way = triangles_.way(nearest.triangle, nearest.foot.k);
        form -= way * way.transpose();
    }
    form /= value;
    return value;
}

LayerObstacle::LayerObstacle(const SampledDistance& distance, double epsilon)
    : Obstacle(3, wider(distance.box, epsilon), false, checked_epsilon(distance, epsilon),
               epsilon - smooth_from * distance.grid.spacing),
      distance_(distance),
      epsilon_(epsilon) {}

double LayerObstacle::evaluate(const double* x, double* gradient, double* second) const {
    double value = 0;
    if (!distance_.evaluate(x, &value, gradient, second)) value = from_box(distance_.box, x, gradient, second);
    for (uint32_t k = 0; k < 3 && gradient != nullptr; ++k) gradient[k] = -gradient[k];
    for (uint32_t k = 0; k < 9 && second != nullptr; ++k) second[k] = -second[k];
    return epsilon_ - value;
}

}  // namespace flg
