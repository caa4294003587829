// SPDX-License-Identifier: MIT
// Meshes whose answers are known, built with adjacency and ready to use.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <memory_resource>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "runtime/run_now.h"
#include "surfaces/mesh/adjacency.h"
#include "surfaces/mesh/mesh.h"

namespace flg::test {

inline Memory* test_memory() {
    return std::pmr::new_delete_resource();
}

struct Soup {
    std::vector<Position> positions;
    std::vector<Triple> triangles;
};

inline Mesh make_mesh(const Soup& soup) {
    Mesh mesh(test_memory());
    mesh.positions = GrowingBuffer<Position>(soup.positions.size(), test_memory());
    mesh.triangles = GrowingBuffer<Triple>(soup.triangles.size(), test_memory());
    mesh.regions = GrowingBuffer<uint32_t>(soup.triangles.size(), test_memory());
    std::copy(soup.positions.begin(), soup.positions.end(), mesh.positions.begin());
    std::copy(soup.triangles.begin(), soup.triangles.end(), mesh.triangles.begin());
    std::fill(mesh.regions.begin(), mesh.regions.end(), 0u);
    run_now(test_memory(), [&](Pace& pace) { return find_neighbours(pace, mesh); });
    return mesh;
}

inline Position to_position(const Vec3& p) {
    return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

// A grid of columns x rows cells over [0, width] x [0, height], mapped by `place`; diagonals alternate if `woven`.
// wrap_u joins the last column to the first.
inline Soup grid(uint32_t columns, uint32_t rows, const std::function<Vec3(double, double)>& place, bool wrap_u = false,
                 bool woven = false) {
    Soup soup;
    const uint32_t across = wrap_u ? columns : columns + 1;
    for (uint32_t j = 0; j <= rows; ++j) {
        for (uint32_t i = 0; i < across; ++i) {
            soup.positions.push_back(to_position(place(double(i) / columns, double(j) / rows)));
        }
    }
    for (uint32_t j = 0; j < rows; ++j) {
        for (uint32_t i = 0; i < columns; ++i) {
            const uint32_t right = (i + 1) % across;
            const uint32_t a = j * across + i, b = j * across + right, c = (j + 1) * across + right,
                           d = (j + 1) * across + i;
            if (woven && (i + j) % 2 == 1) {
                soup.triangles.push_back({a, b, d});
                soup.triangles.push_back({b, c, d});
            } else {
                soup.triangles.push_back({a, b, c});
                soup.triangles.push_back({a, c, d});
            }
        }
    }
    return soup;
}

// [0, 1]^2 in the plane z = 0; inner vertices moved by up to `jitter` cells.
inline Soup plane(uint32_t cells, double jitter = 0) {
    uint64_t vertex = 0;
    return grid(cells, cells, [&](double x, double y) {
        const bool inner = x > 0 && x < 1 && y > 0 && y < 1;
        const double dx = inner ? (2 * random_unit(1, vertex, 0) - 1) * jitter / cells : 0;
        const double dy = inner ? (2 * random_unit(1, vertex, 1) - 1) * jitter / cells : 0;
        ++vertex;
        return Vec3(x + dx, y + dy, 0);
    });
}

inline Soup stretched(Soup soup, const Vec3& factors) {
    for (Position& p : soup.positions) p = to_position(Vec3(p[0], p[1], p[2]).cwiseProduct(factors));
    return soup;
}

// An open cylinder about the z axis: radius 1, height 2.
inline Soup cylinder(uint32_t around, uint32_t up) {
    return grid(
        around, up,
        [](double u, double v) {
            const double angle = 2 * std::numbers::pi * u;
            return Vec3(std::cos(angle), std::sin(angle), 2 * v);
        },
        true);
}

inline Soup tetrahedron() {
    return {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
}

// The unit sphere: an icosahedron, each triangle split in four `levels` times, vertices moved onto the sphere.
inline Soup sphere(uint32_t levels) {
    const double g = std::numbers::phi;
    Soup soup;
    for (const Vec3& p :
         {Vec3(-1, g, 0), Vec3(1, g, 0), Vec3(-1, -g, 0), Vec3(1, -g, 0), Vec3(0, -1, g), Vec3(0, 1, g),
          Vec3(0, -1, -g), Vec3(0, 1, -g), Vec3(g, 0, -1), Vec3(g, 0, 1), Vec3(-g, 0, -1), Vec3(-g, 0, 1)}) {
        soup.positions.push_back(to_position(p.normalized()));
    }
    soup.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (uint32_t level = 0; level < levels; ++level) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [found, is_new] =
                middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<uint32_t>(soup.positions.size()));
            if (is_new) {
                const Vec3 sum = load_vec3(soup.positions[a].data()) + load_vec3(soup.positions[b].data());
                soup.positions.push_back(to_position(sum.normalized()));
            }
            return found->second;
        };
        std::vector<Triple> finer;
        for (const Triple& t : soup.triangles) {
            const uint32_t ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
            finer.insert(finer.end(), {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
        }
        soup.triangles = std::move(finer);
    }
    return soup;
}

// A torus about the z axis: radii 1 and 0.4.
inline Soup torus(uint32_t around, uint32_t tube) {
    Soup soup;
    const auto index = [&](uint32_t i, uint32_t j) { return (i % around) * tube + j % tube; };
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < tube; ++j) {
            const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / tube;
            const double r = 1 + 0.4 * std::cos(v);
            soup.positions.push_back(to_position({r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)}));
        }
    }
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < tube; ++j) {
            soup.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
            soup.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
        }
    }
    return soup;
}

}  // namespace flg::test
