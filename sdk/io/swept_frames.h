// SPDX-License-Identifier: MIT
// Frames along one curve: what a cross section is placed by.
#pragma once

#include <vector>

#include "io/checked_view.h"
#include "io/vec3.h"

namespace flg::io {

struct SweptFrame {
    Vec3 position;
    Vec3 tangent;
    Vec3 normal;   // unit length, across the tangent
    double along;  // arc length from the first point
    size_t point;  // of the view
};

enum class Normals {
    followed,  // the view's, where it has any: they say how a ribbon lies
    carried    // rotation-minimizing: nothing round shows another, and following it could only twist the surface
};

// One frame a point, points repeated in a row only once; empty for a curve without length.
std::vector<SweptFrame> swept_frames(const CheckedView& view, uint32_t curve, Normals normals);

}  // namespace flg::io
