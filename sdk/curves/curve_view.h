// SPDX-License-Identifier: MIT
// One curve's points, as the kernels of this room read them.
#pragma once

#include <cstdint>

#include "core/vec.h"

namespace flg {

// Points as they lie in a curve set's POSITION column: three floats each, tightly packed, all finite. `count` >= 1.
struct CurveView {
    const float* positions = nullptr;
    uint32_t count = 0;
    bool closed = false;  // the last point is joined to the first

    const float* raw(uint32_t i) const { return positions + 3 * static_cast<size_t>(i); }
    Vec3 point(uint32_t i) const { return load_vec3(raw(i)); }
    // The point after i; the first one after the last.
    uint32_t following(uint32_t i) const { return i + 1 < count ? i + 1 : 0; }
    bool same_point(uint32_t i, uint32_t j) const {
        const float* a = raw(i);
        const float* b = raw(j);
        return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    }
};

}  // namespace flg
