// SPDX-License-Identifier: MIT
#pragma once

#include "scenes.h"

namespace flg::scenes {

std::vector<Curve> make_hair(uint32_t count);
std::vector<Curve> make_flow(uint32_t count);
std::vector<Curve> make_tree();
std::vector<Curve> make_icosahedron();
std::vector<Curve> make_tower();

}  // namespace flg::scenes
