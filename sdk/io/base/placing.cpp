// SPDX-License-Identifier: MIT
#include "io/base/placing.h"

#include <algorithm>

#include "io/base/box.h"

namespace flg::io {

void EdgeLoss::add(const float* a, const float* b) {
    // Six bits of each edge are left: the shape is as good as a drawing.
    constexpr double min_steps = 64;
    double square = 0;
    float size = 0;
    for (uint32_t k = 0; k < 3; ++k) {
        const double side = double{a[k]} - double{b[k]};
        square += side * side;
        size = std::max({size, std::abs(a[k]), std::abs(b[k])});
    }
    if (square == 0) {
        ++none_;
        return;
    }
    const double least = min_steps * double{float_step(size)};
    ++(square >= least * least ? kept_ : lost_);
}

Origin origin_near(const Vector<float>& positions, const Placing& placing) {
    const Box box = box_of(positions);
    Origin origin;
    for (size_t k = 0; k < 3; ++k)
        origin[k] = std::round(placing.stored ? (*placing.stored)[k] : 0.5 * (double{box.min[k]} + double{box.max[k]}));
    return origin;
}

}  // namespace flg::io
