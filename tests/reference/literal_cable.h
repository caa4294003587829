// SPDX-License-Identifier: MIT
// A hanging cable as beads joined by rods that give way, literally: all beads fall a little, rods and solids push back
// one after the other, many times, and what a round falls shrinks.
#pragma once

#include <vector>

#include "core/vec.h"
#include "splines/obstacles/obstacle.h"

namespace flg::reference {

// segments + 1 places, from the straight way between the ends. Solids may be null.
std::vector<Vec3> literal_cable(const ObstacleSet* solids, const Vec3& from, const Vec3& to, double length,
                                uint32_t segments, const Vec3& down, uint32_t rounds);

// The mean height of a chain's segments, over `down`.
double mean_height(const std::vector<Vec3>& places, const Vec3& down);

}  // namespace flg::reference
