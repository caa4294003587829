// SPDX-License-Identifier: MIT
#include "surfaces/cut_strip.h"

#include <limits>

namespace flg {

void Strip::triangulate(const Mesh& mesh, uint32_t region, Pieces& pieces) const {
    constexpr float never = std::numeric_limits<float>::infinity();
    size_t l = 0, r = 0;
    uint32_t below = Pieces::outer_edge | first_edge;  // what lies under the rung from left[l] to right[r]
    const auto above = [&] {
        const bool last = l + 1 == left.size() && r + 1 == right.size();
        return last ? Pieces::outer_edge | last_edge : pieces.size() + 1;
    };
    const auto outer = [](const Point& point) { return Pieces::outer_edge | point.edge; };

    if (left[0].vertex == right[0].vertex) {
        l = r = 1;
        const uint32_t next = above();
        pieces.add({left[0].vertex, right[1].vertex, left[1].vertex}, {outer(right[1]), next, outer(left[1])}, region);
        below = pieces.size() - 1;
    }
    while (l + 1 < left.size() || r + 1 < right.size()) {
        const Point &a = left[l], &b = right[r];
        const float next_left = l + 1 < left.size() ? left[l + 1].value : never;
        const float next_right = r + 1 < right.size() ? right[r + 1].value : never;
        if (next_left == next_right && left[l + 1].vertex == right[r + 1].vertex) {
            pieces.add({a.vertex, b.vertex, left[l + 1].vertex}, {below, outer(right[r + 1]), outer(left[l + 1])},
                       region);
            return;
        }
        bool climb_left = next_left < next_right;
        if (next_left == next_right) {
            const Vec3 falling = mesh.position(left[l + 1].vertex) - mesh.position(b.vertex);
            const Vec3 rising = mesh.position(right[r + 1].vertex) - mesh.position(a.vertex);
            climb_left = falling.squaredNorm() <= rising.squaredNorm();
        }
        climb_left ? ++l : ++r;
        const uint32_t next = above();
        if (climb_left) {
            pieces.add({a.vertex, b.vertex, left[l].vertex}, {below, next, outer(left[l])}, region);
        } else {
            pieces.add({a.vertex, b.vertex, right[r].vertex}, {below, outer(right[r]), next}, region);
        }
        below = pieces.size() - 1;
    }
}

void fan_last_piece(Pieces& pieces, uint32_t edge, uint32_t first, uint32_t count, int step) {
    if (count == 0) return;
    const uint32_t changed = pieces.size() - 1;
    const Triple corners = pieces.triangles.back(), across = pieces.neighbours.back();
    const uint32_t region = pieces.regions.back(), outer = Pieces::outer_edge | edge;
    const uint32_t k = across[0] == outer ? 0 : across[1] == outer ? 1 : 2;
    const uint32_t end = corners[(k + 1) % 3], apex = corners[(k + 2) % 3];
    uint32_t point = first;
    pieces.triangles.back() = {corners[k], point, apex};
    pieces.neighbours.back() = {outer, changed + 1, across[(k + 2) % 3]};
    for (uint32_t i = 1; i <= count; ++i) {
        const uint32_t here = point;
        point = i == count ? end : point + static_cast<uint32_t>(step);
        pieces.add({here, point, apex}, {outer, i == count ? across[(k + 1) % 3] : changed + i + 1, changed + i - 1},
                   region);
    }
    // The piece across the far side now meets the last one.
    const uint32_t far = across[(k + 1) % 3];
    if (far >= Pieces::outer_edge) return;
    for (uint32_t& neighbour : pieces.neighbours[far]) {
        if (neighbour == changed) neighbour = changed + count;
    }
}

}  // namespace flg
