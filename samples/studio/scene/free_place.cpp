// SPDX-License-Identifier: MIT
#include "scene/free_place.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace flg::studio {
namespace {

constexpr float kAbsurd = 8.0f;  // times the usual size of the others, or a share of it: a file in other units
constexpr float kGap = 0.2f;     // between things, of their width
constexpr int kRings = 200;
constexpr float kRow = 2.5f;  // half of the longest row, of the widths of two things
// To the right first, then to the left, behind, in front.
constexpr float kTurns[] = {0.0f, 0.5f, 0.125f, 0.375f, 0.25f, 0.875f, 0.625f, 0.75f};

float breadth(const render::Box& box) {
    return std::max(box.max.x - box.min.x, box.max.z - box.min.z);
}

bool meets(const render::Box& a, const render::Box& b, float gap) {
    return a.min.x < b.max.x + gap && b.min.x < a.max.x + gap && a.min.z < b.max.z + gap && b.min.z < a.max.z + gap;
}

}  // namespace

render::Placement free_place(const render::Box& own, std::span<const render::Box> others) {
    std::vector<float> sizes;
    render::Box all;
    for (const render::Box& other : others) {
        if (other.empty()) continue;
        all.add(other);
        sizes.push_back(other.diagonal());
    }
    render::Placement place;
    if (own.empty() || sizes.empty()) return place;
    std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2), sizes.end());
    const float usual = sizes[sizes.size() / 2], size = own.diagonal();
    const bool is_absurd = size > kAbsurd * usual || size * kAbsurd < usual;
    if (is_absurd && size > 0.0f && usual > 0.0f) place.scale = usual / size;
    const render::Box box = place.box(own);
    const float width = std::max(breadth(box), 1e-6f), gap = kGap * width;
    const glm::vec3 from = all.center();
    for (int i = 0; i < 2 * kRings; ++i) {
        // A row first, in which none hides another; once that is long, all around.
        const bool is_row = i < kRings;
        const float away = 0.25f * width * static_cast<float>(i % kRings);
        if (is_row && away > kRow * (width + usual)) continue;
        for (const float turn : std::span(kTurns).first(is_row ? 2 : std::size(kTurns))) {
            const float angle = 6.2831853f * turn;
            glm::vec3 middle = from + away * glm::vec3(std::cos(angle), 0.0f, -std::sin(angle));
            middle.y = all.min.y + 0.5f * (box.max.y - box.min.y);
            const glm::vec3 move = middle - place.scale * own.center();
            const render::Box put = {move + place.scale * own.min, move + place.scale * own.max};
            const bool is_free = std::none_of(others.begin(), others.end(), [&](const render::Box& other) {
                return !other.empty() && meets(put, other, gap);
            });
            if (!is_free) continue;
            place.at = move;
            return place;
        }
    }
    // Farther than the rings: beside all of it.
    place.at = glm::vec3(all.max.x + gap - place.scale * own.min.x, all.min.y - place.scale * own.min.y,
                         from.z - place.scale * own.center().z);
    return place;
}

}  // namespace flg::studio
