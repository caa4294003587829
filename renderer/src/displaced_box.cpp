// SPDX-License-Identifier: MIT
#include "displaced_box.h"

#include <algorithm>
#include <cmath>

namespace flg::render {

void DisplacedBox::add(glm::vec3 position, glm::vec3 displacement, float reach) {
    for (int i = 0; i < box_count; ++i) {
        const glm::vec3 p = position + static_cast<float>(i - furthest) * displacement;
        boxes_[i].add({p - reach, p + reach});
    }
    largest_displacement_ = std::max(largest_displacement_, glm::length(displacement));
}

Box DisplacedBox::at(float offset) const {
    if (boxes_[0].empty()) return {};
    const float inside = std::clamp(offset, -float{furthest}, float{furthest});
    const float place = inside + float{furthest};
    const int first = std::min(static_cast<int>(place), box_count - 2);
    const float along = place - static_cast<float>(first);
    const float further = std::abs(offset - inside) * largest_displacement_;
    return {glm::mix(boxes_[first].min, boxes_[first + 1].min, along) - further,
            glm::mix(boxes_[first].max, boxes_[first + 1].max, along) + further};
}

}  // namespace flg::render
