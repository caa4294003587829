// SPDX-License-Identifier: MIT
#include "splines/obstacles/placed_obstacles.h"

#include <utility>

namespace flg {

namespace {

Obstacle::Place moved(Obstacle::Place place, const Vec3& shift) {
    for (uint32_t c = 0; c < Obstacle::max_dimension; ++c) place[c] += shift[c];
    return place;
}

}  // namespace

PlacedObstacle::PlacedObstacle(const Obstacle& obstacle, const Vec3& shift)
    : Obstacle(obstacle.dimension(), {moved(obstacle.box().lower, shift), moved(obstacle.box().upper, shift)},
               obstacle.bounded(), obstacle.core_depth(), obstacle.reach()),
      obstacle_(obstacle),
      shift_(shift) {
    set_core(moved(obstacle.core(), shift));
}

double PlacedObstacle::evaluate(const double* x, double* gradient, double* second) const {
    double own[max_dimension];
    for (uint32_t c = 0; c < dimension(); ++c) own[c] = x[c] - shift_[c];
    return obstacle_.evaluate(own, gradient, second);
}

PlacedObstacles::PlacedObstacles(std::shared_ptr<const Obstacles> obstacles, const Origin& from, Memory* memory)
    : obstacles_(std::move(obstacles)), placed_(memory) {
    if (obstacles_->origin == from) return;
    const Vec3 shift = origin_shift(obstacles_->origin, from);
    placed_.reserve(obstacles_->solids.size());
    std::pmr::vector<const Obstacle*> pointers(memory);
    for (const auto& solid : obstacles_->solids) pointers.push_back(&placed_.emplace_back(*solid, shift));
    set_.emplace(pointers, obstacles_->clearance, memory);
}

}  // namespace flg
