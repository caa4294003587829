// SPDX-License-Identifier: MIT
// What is so of closed manifold meshes, checked the slow way.
#pragma once

#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/vec.h"
#include "inflation/mesh_laplacian.h"

namespace flg::test {

struct ClosedMesh {
    std::string fault;  // empty: each side twice, in opposite directions, and each vertex has one ring of triangles
    int euler = 0;
    uint32_t components = 0;
    double volume = 0, area = 0;  // of positions
    double min_angle = 180, mean_least_angle = 0;
};

template <class Positions>
ClosedMesh check_closed(const Positions& positions, std::span<const TriangleVertices> triangles) {
    ClosedMesh mesh;
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> sides;
    std::vector<std::map<uint32_t, uint32_t>> links(positions.size());
    std::vector<uint32_t> root(positions.size());
    for (uint32_t i = 0; i < root.size(); ++i) root[i] = i;
    const auto find = [&](uint32_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (const TriangleVertices& t : triangles) {
        const auto at = [&](uint32_t k) { return Vec3(positions[t[k]][0], positions[t[k]][1], positions[t[k]][2]); };
        mesh.volume += at(0).dot(at(1).cross(at(2))) / 6;
        mesh.area += (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
        double least = 180;
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
            if (a >= positions.size() || a == b) mesh.fault = "a triangle names no vertex, or one twice";
            if (!mesh.fault.empty()) return mesh;
            if (++sides[{a, b}] != 1) mesh.fault = "a side twice in one direction";
            if (!links[a].emplace(b, c).second) mesh.fault = "a vertex with two triangles at one side";
            root[find(a)] = find(b);
            const Vec3 ab = at((k + 1) % 3) - at(k), ac = at((k + 2) % 3) - at(k);
            least = std::min(least, std::atan2(ab.cross(ac).norm(), ab.dot(ac)) * 180 / 3.14159265358979);
        }
        mesh.min_angle = std::min(mesh.min_angle, least);
        mesh.mean_least_angle += least / static_cast<double>(triangles.size());
    }
    for (const auto& [side, count] : sides)
        if (!sides.contains({side.second, side.first})) mesh.fault = "a side without the other direction";
    for (const auto& link : links) {
        if (link.empty()) {
            mesh.fault = "a vertex without triangles";
            continue;
        }
        size_t steps = 0;
        uint32_t here = link.begin()->first;
        do {
            const auto next = link.find(here);
            if (next == link.end()) break;
            here = next->second;
            ++steps;
        } while (here != link.begin()->first && steps <= link.size());
        if (steps != link.size()) mesh.fault = "a vertex with several rings of triangles";
    }
    mesh.euler =
        static_cast<int>(positions.size()) - static_cast<int>(sides.size() / 2) + static_cast<int>(triangles.size());
    for (uint32_t i = 0; i < root.size(); ++i) mesh.components += find(i) == i;
    return mesh;
}

}  // namespace flg::test
