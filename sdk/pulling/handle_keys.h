// SPDX-License-Identifier: MIT
// Handles over time: each passes through its keys, smoothly. Between two keys it follows the cubic that has their
// positions and velocities (Hermite). A key's velocity is that of the parabola through it and its neighbours, and at
// most three times that of the slower way to them: so where a handle rests it rests all the time, and does not swing
// out before. Before the first key and after the last it is where that one is, and both begin and end at rest.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace flg {

// Where a handle is; at least one key, with three coordinates each, at times that rise.
std::array<float, 3> handle_at(std::span<const double> times, const float* positions, double time);

}  // namespace flg
