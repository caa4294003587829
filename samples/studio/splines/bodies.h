// SPDX-License-Identifier: MIT
// What motions move: the samples' bodies, each of length 1, and meshes of many copies.
#pragma once

#include <span>

#include "support/bodies.h"

namespace flg::studio::splines {

std::span<const char* const> body_names();
// Around its barycentre; its longest side is 1 metre.
const samples::Body& unit_body(int index);

}  // namespace flg::studio::splines
