// SPDX-License-Identifier: MIT
// The first normal of the moving frame of a curve that was drawn. It needs the curve's first direction and how the
// controller was held there, so that a stroke has the same while it is drawn and ever after.
#pragma once

#include "core/vec.h"

namespace flg {

// `v` turned by a quaternion x y z w of any length; zero if that is zero.
Vec3 turned_by(const float* quaternion, const Vec3& v);

// The controller's y axis, or its x axis where the curve goes along that; without an orientation (null, or zero) the
// coordinate axis furthest from the curve's direction. Unit, across the unit tangent.
Vec3 drawn_normal(const float* orientation, const Vec3& tangent);

}  // namespace flg
