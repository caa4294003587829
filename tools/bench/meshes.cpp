// SPDX-License-Identifier: MIT
#include "bench/meshes.h"

#include <cmath>
#include <numbers>

namespace flg::bench {

namespace {

constexpr double kLongWayPerShort = 2.5;  // cells around the torus for each around its tube
constexpr double kTube = 0.4, kBump = 0.05, kShift = 0.3;

void add_point(MeshArrays& mesh, double u, double v, double height) {
    const double bump = height * std::sin(9 * u) * std::sin(7 * v + 2 * std::sin(3 * u));
    const double tube = kTube + bump, ring = 1 + tube * std::cos(v);
    for (const double x : {ring * std::cos(u), ring * std::sin(u), tube * std::sin(v)}) {
        mesh.positions.push_back(static_cast<float>(x));
    }
}

MeshArrays torus_with(uint32_t triangle_count, double height, double shift) {
    const auto across = static_cast<uint32_t>(std::sqrt(triangle_count / 2.0 / kLongWayPerShort));
    const uint32_t around = triangle_count / 2 / across;
    constexpr double turn = 2 * std::numbers::pi;
    MeshArrays mesh;
    mesh.positions.reserve(size_t{3} * around * across);
    mesh.triangles.reserve(size_t{6} * around * across);
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < across; ++j)
            add_point(mesh, turn * (i + shift * std::sin(j)) / around, turn * j / across, height);
    }
    const auto at = [&](uint32_t i, uint32_t j) { return i % around * across + j % across; };
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < across; ++j) {
            const uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            for (const uint32_t v : {a, b, c, a, c, d}) mesh.triangles.push_back(v);
        }
    }
    return mesh;
}

}  // namespace

FlgMeshView MeshArrays::view(FlgColumn& column) const {
    column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
    FlgMeshView view = flgMeshViewDefaults();
    view.vertex_count = static_cast<uint32_t>(positions.size() / 3);
    view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
    view.column_count = 1;
    view.columns = &column;
    view.triangles = triangles.data();
    return view;
}

MeshArrays bumpy_torus(uint32_t triangle_count) {
    return torus_with(triangle_count, kBump, kShift);
}

MeshArrays wavy_torus(uint32_t triangle_count, double height) {
    return torus_with(triangle_count, height, 0);
}

}  // namespace flg::bench
