// SPDX-License-Identifier: MIT
// Sorkine, Alexa: As-rigid-as-possible surface modeling, 2007, as it is written: rotations by singular value
// decomposition, positions by a system from which fixed vertices are eliminated.
#pragma once

#include <Eigen/Sparse>
#include <array>
#include <map>
#include <vector>

#include "core/vec.h"

namespace flg::reference {

class LiteralArap {
public:
    LiteralArap(std::vector<Vec3> rest, const std::vector<std::array<uint32_t, 3>>& triangles);
    void fix(uint32_t vertex, const Vec3& at) { fixed_[vertex] = at; }
    // One local step and one global step.
    const std::vector<Vec3>& iterate();

private:
    std::vector<Vec3> rest_, at_;
    std::vector<std::map<uint32_t, double>> weights_;
    std::map<uint32_t, Vec3> fixed_;
};

}  // namespace flg::reference
