// SPDX-License-Identifier: MIT
#include "tangles/region_outline.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace flg::studio {
namespace {

// A side of a triangle: 3 * triangle + k, from its corner k to the next one.
using Side = uint32_t;

Side next_side(Side side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

class Walk {
public:
    Walk(const FlgSurfaceView& surface, const Regions& leaves) : surface_(surface) {
        inside_.assign(leaves.empty() ? 0 : leaves.back() + 1, 0);
        for (const uint32_t leaf : leaves) inside_[leaf] = 1;
    }
    bool is_inside(uint32_t triangle) const {
        const uint32_t label = surface_.mesh->regions != nullptr ? surface_.mesh->regions[triangle] : 0;
        return label < inside_.size() && inside_[label] != 0;
    }
    bool is_border(Side side) const {
        const uint32_t across = surface_.neighbours[side];
        return across == FLG_NO_INDEX || !is_inside(across);
    }
    uint32_t vertex(Side side) const { return surface_.mesh->triangles[side]; }
    glm::vec3 place(Side side) const {
        const float* p = surface_.mesh->columns[0].data + size_t{3} * vertex(side);
        return {p[0], p[1], p[2]};
    }
    // The border's next side: about the side's end, within the regions.
    Side next(Side side) const {
        const uint32_t end = vertex(next_side(side));
        for (side = next_side(side); !is_border(side);) {
            side = 3 * surface_.neighbours[side];
            while (vertex(side) != end) ++side;
        }
        return side;
    }
    glm::vec3 area_vector(uint32_t triangle) const {
        const glm::vec3 a = place(3 * triangle);
        return 0.5f * glm::cross(place(3 * triangle + 1) - a, place(3 * triangle + 2) - a);
    }

private:
    const FlgSurfaceView& surface_;
    std::vector<uint8_t> inside_;
};

BorderLoop walk_loop(const Walk& walk, Side first, std::unordered_set<Side>& passed) {
    BorderLoop loop;
    glm::vec3 before(0.0f);
    for (Side side = first; passed.insert(side).second; side = walk.next(side)) {
        const glm::vec3 here = walk.area_vector(side / 3);
        loop.points.push_back(walk.place(side));
        loop.normals.push_back(before + here);
        before = here;
    }
    loop.normals[0] += before;
    const size_t n = loop.points.size();
    for (size_t i = 0; i < n; ++i) {
        loop.shares.push_back(loop.length);
        loop.length += glm::distance(loop.points[i], loop.points[(i + 1) % n]);
        const float size = glm::length(loop.normals[i]);
        loop.normals[i] = size > 0.0f ? loop.normals[i] / size : glm::vec3(0.0f, 1.0f, 0.0f);
    }
    for (float& share : loop.shares) share = loop.length > 0.0f ? share / loop.length : 0.0f;
    return loop;
}

}  // namespace

float Outline::size() const {
    return std::sqrt(area / static_cast<float>(std::max(leaf_count, 1u)));
}

float Outline::breadth() const {
    return perimeter > 0.0f ? std::min(size(), 2.0f * area / perimeter) : 0.5f * size();
}

Outline trace_outline(const FlgSurfaceView& surface, const Regions& leaves) {
    Outline outline;
    outline.leaf_count = static_cast<uint32_t>(leaves.size());
    const Walk walk(surface, leaves);
    std::unordered_set<Side> passed;
    bool is_first = true;
    for (uint32_t t = 0; t < surface.mesh->triangle_count; ++t) {
        if (!walk.is_inside(t)) continue;
        outline.area += glm::length(walk.area_vector(t));
        for (Side side = 3 * t; side < 3 * t + 3; ++side) {
            const glm::vec3 place = walk.place(side);
            if (is_first || place.y > outline.top_place.y) {
                const uint32_t k = side % 3;
                outline.top = {t, k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f};
                outline.top_place = place;
                is_first = false;
            }
            if (walk.is_border(side) && !passed.contains(side)) outline.loops.push_back(walk_loop(walk, side, passed));
        }
    }
    for (const BorderLoop& loop : outline.loops) outline.perimeter += loop.length;
    return outline;
}

}  // namespace flg::studio
