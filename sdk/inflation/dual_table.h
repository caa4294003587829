// SPDX-License-Identifier: MIT
// Which crossed edges of a cube belong to one sheet of the surface in it: the patches of dual marching cubes (Nielson: Dual
// marching cubes, 2004), made at compile time. Corner i is at (i & 1, i >> 1 & 1, i >> 2). Edge 4 * axis + s + 2 * t goes along the
// axis from the corner at s of the axis after it and t of the one after that. A face with two opposite corners inside cuts off
// those outside: what is inside stays together.
#pragma once

#include <array>
#include <cstdint>

namespace flg {

constexpr uint32_t cube_corner(uint32_t axis, uint32_t along, uint32_t s, uint32_t t) {
    return (along << axis) | (s << ((axis + 1) % 3)) | (t << ((axis + 2) % 3));
}

struct DualCase {
    std::array<uint8_t, 12> patch;  // by edge; for those that are crossed
    uint8_t count;
};

// A face across `axis`, at its far end or not: its edges along the next axis at t = 0 and 1, then along the one after at s = 0 and 1.
constexpr std::array<uint32_t, 4> face_edges(uint32_t axis, uint32_t far) {
    const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    // Along u: s is of v, t of axis. Along v: s is of axis, t of u.
    return {4 * u + 0 + 2 * far, 4 * u + 1 + 2 * far, 4 * v + far + 0, 4 * v + far + 2};
}

constexpr std::array<DualCase, 256> make_dual_cases() {
    std::array<DualCase, 256> cases{};
    for (uint32_t inside = 0; inside < 256; ++inside) {
        std::array<uint8_t, 12> root{};
        for (uint8_t e = 0; e < 12; ++e) root[e] = e;
        const auto find = [&](uint32_t e) {
            while (root[e] != e) e = root[e];
            return static_cast<uint8_t>(e);
        };
        const auto join = [&](uint32_t a, uint32_t b) { root[find(a)] = find(b); };
        const auto is_inside = [&](uint32_t corner) { return (inside >> corner & 1) != 0; };
        for (uint32_t axis = 0; axis < 3; ++axis) {
            for (uint32_t far = 0; far < 2; ++far) {
                const auto edges = face_edges(axis, far);
                // Corners of the face by (u, v); at each, the edges along u (0 or 1) and along v (2 or 3).
                uint32_t crossed = 0, list[4] = {};
                const bool c00 = is_inside(cube_corner(axis, far, 0, 0)), c10 = is_inside(cube_corner(axis, far, 1, 0)),
                           c01 = is_inside(cube_corner(axis, far, 0, 1)), c11 = is_inside(cube_corner(axis, far, 1, 1));
                if (c00 != c10) list[crossed++] = edges[0];
                if (c01 != c11) list[crossed++] = edges[1];
                if (c00 != c01) list[crossed++] = edges[2];
                if (c10 != c11) list[crossed++] = edges[3];
                if (crossed == 2) join(list[0], list[1]);
                if (crossed < 4) continue;
                // Opposite corners: the two outside are cut off.
                if (c00) {
                    join(edges[0], edges[3]);  // around (1, 0)
                    join(edges[1], edges[2]);  // around (0, 1)
                } else {
                    join(edges[0], edges[2]);
                    join(edges[1], edges[3]);
                }
            }
        }
        DualCase& out = cases[inside];
        std::array<uint8_t, 12> number{};
        for (auto& n : number) n = 255;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            for (uint32_t s = 0; s < 2; ++s) {
                for (uint32_t t = 0; t < 2; ++t) {
                    const uint32_t edge = 4 * axis + s + 2 * t;
                    if (is_inside(cube_corner(axis, 0, s, t)) == is_inside(cube_corner(axis, 1, s, t))) continue;
                    uint8_t& patch = number[find(edge)];
                    if (patch == 255) patch = out.count++;
                    out.patch[edge] = patch;
                }
            }
        }
    }
    return cases;
}

inline constexpr std::array<DualCase, 256> dual_cases = make_dual_cases();

}  // namespace flg
