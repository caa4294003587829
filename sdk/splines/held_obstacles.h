// SPDX-License-Identifier: MIT
// Obstacles as hosts hold them.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "runtime/product.h"
#include "splines/obstacle_grid.h"

namespace flg {

class HeldObstacles final : public Product {
public:
    explicit HeldObstacles(Memory* memory) : solids(memory) {}

    std::pmr::vector<std::shared_ptr<const Obstacle>> solids;
    std::optional<ObstacleSet> set;  // of these
};

}  // namespace flg
