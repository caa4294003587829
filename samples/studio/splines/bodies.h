// SPDX-License-Identifier: MIT
// What motions move: the gallery's bodies, each of length 1, and meshes of many copies.
#pragma once

#include <span>

#include "gallery/bodies.h"

namespace flg::studio::splines {

std::span<const char* const> body_names();
// Around its barycentre; its longest side is 1 metre.
const gallery::Body& unit_body(int index);

}  // namespace flg::studio::splines
