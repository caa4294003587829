// SPDX-License-Identifier: MIT
// Obstacles of a host seen from another origin than their own: from where a curve is; or one of a mesh that has its
// own origin.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "splines/obstacles/obstacles.h"

namespace flg {

// An obstacle that is `shift` away. `obstacle` outlives it.
class PlacedObstacle final : public Obstacle {
public:
    PlacedObstacle(const Obstacle& obstacle, const Vec3& shift);
    double evaluate(const double* x, double* gradient, double* second) const override;

private:
    const Obstacle& obstacle_;
    Vec3 shift_;
};

class PlacedObstacles {
public:
    // Keeps `obstacles`, which are ready.
    PlacedObstacles(std::shared_ptr<const Obstacles> obstacles, const Origin& from, Memory* memory);
    const ObstacleSet& set() const { return set_ ? *set_ : *obstacles_->set; }

private:
    std::shared_ptr<const Obstacles> obstacles_;
    std::pmr::vector<PlacedObstacle> placed_;
    std::optional<ObstacleSet> set_;  // of these; none if the origin is theirs
};

}  // namespace flg
