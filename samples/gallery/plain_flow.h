// SPDX-License-Identifier: MIT
// The paper's flow without its tangential velocity, to show what that is for (Fig. 13 and 15).
#pragma once

#include "scenes/scenes.h"

namespace flg::gallery {

// Moves the points of an open curve along its normals only, by d gamma / dt = kappa n, until its length has fallen to
// `length_share` of what it was; the ends stay.
scenes::Curve plain_flow(const scenes::Curve& curve, double length_share);

}  // namespace flg::gallery
