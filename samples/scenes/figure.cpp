// SPDX-License-Identifier: MIT
// A cat of blocks: the outside of a set of cubes, closed and manifold, which Loop's subdivision makes round.
#include <map>

#include "scenes.h"

namespace flg::scenes {
namespace {

constexpr float kCube = 0.1f;  // metres

using Cell = std::array<int, 3>;

// Cubes from `low` up to before `high`.
struct Block {
    Cell low, high;
};

constexpr Block kBlocks[] = {
    {{0, 2, 0}, {5, 4, 3}},                                                                             // body
    {{0, 0, 0}, {1, 2, 1}},  {{0, 0, 2}, {1, 2, 3}},   {{4, 0, 0}, {5, 2, 1}}, {{4, 0, 2}, {5, 2, 3}},  // legs
    {{4, 4, 0}, {6, 5, 3}},                                                                             // neck
    {{4, 5, 0}, {7, 7, 3}},                                                                             // head
    {{7, 5, 1}, {8, 6, 2}},                                                                             // muzzle
    {{5, 7, 0}, {6, 8, 1}},  {{5, 7, 2}, {6, 8, 3}},                                                    // ears
    {{-1, 3, 1}, {0, 4, 2}}, {{-2, 3, 1}, {-1, 7, 2}},                                                  // tail
};

bool inside(const Cell& cell) {
    for (const Block& block : kBlocks) {
        bool within = true;
        for (int axis = 0; axis < 3; ++axis)
            within = within && block.low[axis] <= cell[axis] && cell[axis] < block.high[axis];
        if (within) return true;
    }
    return false;
}

}  // namespace

Mesh make_figure() {
    Mesh mesh;
    std::map<Cell, uint32_t> corners;
    const auto corner = [&](const Cell& at) {
        const auto [place, is_new] = corners.try_emplace(at, static_cast<uint32_t>(mesh.vertices.size()));
        if (is_new) {
            mesh.vertices.push_back({kCube * static_cast<float>(at[0]), kCube * static_cast<float>(at[1]),
                                     kCube * static_cast<float>(at[2])});
        }
        return place->second;
    };
    for (int x = -2; x < 8; ++x) {
        for (int y = 0; y < 8; ++y) {
            for (int z = 0; z < 3; ++z) {
                if (!inside({x, y, z})) continue;
                for (int face = 0; face < 6; ++face) {
                    const int axis = face / 2, up = face % 2;
                    Cell beyond = {x, y, z};
                    beyond[axis] += up == 1 ? 1 : -1;
                    if (inside(beyond)) continue;
                    Cell at = {x, y, z};
                    at[axis] += up;
                    Cell side = at, far = at, other = at;
                    side[(axis + 1) % 3] += 1, far[(axis + 1) % 3] += 1, far[(axis + 2) % 3] += 1,
                        other[(axis + 2) % 3] += 1;
                    const uint32_t a = corner(at), b = corner(up == 1 ? side : other), c = corner(far),
                                   d = corner(up == 1 ? other : side);
                    // The diagonal changes from square to square, so that no direction is preferred.
                    if ((x + y + z) % 2 == 0) {
                        mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
                    } else {
                        mesh.triangles.insert(mesh.triangles.end(), {{b, c, d}, {b, d, a}});
                    }
                }
            }
        }
    }
    return mesh;
}

}  // namespace flg::scenes
