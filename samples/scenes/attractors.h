// SPDX-License-Identifier: MIT
#pragma once

#include "scenes.h"

namespace flg::scenes {

// `count` points on an attractor, one time step apart.
std::vector<Point> follow(const Attractor& attractor, uint32_t count);

}  // namespace flg::scenes
