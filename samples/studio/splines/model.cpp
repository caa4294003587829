// SPDX-License-Identifier: MIT
#include "splines/model.h"

#include <algorithm>

namespace flg::studio::splines {
namespace {

auto find(auto& items, uint32_t id) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const auto& item) { return item.id == id; });
    return found == items.end() ? nullptr : &*found;
}

}  // namespace

Curve* Document::curve(uint32_t id) {
    return find(curves, id);
}
Obstacle* Document::obstacle(uint32_t id) {
    return find(obstacles, id);
}
const Curve* Document::curve(uint32_t id) const {
    return find(curves, id);
}
const Motion* Document::motion(uint32_t id) const {
    return find(motions, id);
}
const Obstacle* Document::obstacle(uint32_t id) const {
    return find(obstacles, id);
}
Motion* Document::motion(uint32_t id) {
    return find(motions, id);
}

std::string next_name(const char* word, uint32_t number) {
    return word + (" " + std::to_string(number));
}

}  // namespace flg::studio::splines
