// SPDX-License-Identifier: MIT
// The extent of what a file holds.
#pragma once

#include <algorithm>

#include "io/base/memory.h"

namespace flg::io {

// 0 if there are no points.
struct Box {
    float min[3] = {0, 0, 0};
    float max[3] = {0, 0, 0};

    template <class Info>
    void show(Info& info) const {
        std::copy_n(min, 3, info.box_min);
        std::copy_n(max, 3, info.box_max);
    }
};

inline Box box_of(const Vector<float>& positions) {
    Box box;
    if (positions.empty()) return box;
    std::copy_n(positions.data(), 3, box.min);
    std::copy_n(positions.data(), 3, box.max);
    for (size_t i = 0; i < positions.size(); ++i) {
        box.min[i % 3] = std::min(box.min[i % 3], positions[i]);
        box.max[i % 3] = std::max(box.max[i % 3], positions[i]);
    }
    return box;
}

}  // namespace flg::io
