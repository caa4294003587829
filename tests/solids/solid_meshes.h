// SPDX-License-Identifier: MIT
// Closed meshes of known solids, for the tests.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "runtime/run_now.h"
#include "surfaces/repair/mesh_repair.h"

namespace flg::test {

inline Memory* test_memory() {
    return std::pmr::new_delete_resource();
}

struct Triangles {
    std::vector<float> positions;
    std::vector<uint32_t> corners;

    uint32_t add(const Vec3& at) {
        for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(at[k]));
        return static_cast<uint32_t>(positions.size() / 3) - 1;
    }
    uint32_t vertex_count() const { return static_cast<uint32_t>(positions.size() / 3); }
    Vec3 at(uint32_t v) const { return load_vec3(positions.data() + size_t{3} * v); }

    // The surface around a line of balls; radii between them are even.
    void add_tube(const Vec3& from, double from_radius, const Vec3& to, double to_radius, uint32_t around = 24,
                  uint32_t along = 24) {
        const Vec3 axis = (to - from).normalized(), u = axis.unitOrthogonal(), v = axis.cross(u);
        const double length = (to - from).norm();
        constexpr uint32_t cap = 8;
        std::vector<std::vector<uint32_t>> rings;
        const auto ring = [&](double height, double radius) {
            auto& out = rings.emplace_back();
            for (uint32_t i = 0; i < around; ++i) {
                const double angle = 2 * std::numbers::pi * i / around;
                out.push_back(add(from + height * axis + radius * (std::cos(angle) * u + std::sin(angle) * v)));
            }
        };
        const uint32_t bottom = add(from - from_radius * axis);
        for (uint32_t i = 1; i < cap; ++i) {
            const double angle = 0.5 * std::numbers::pi * i / cap;
            ring(-from_radius * std::cos(angle), from_radius * std::sin(angle));
        }
        for (uint32_t i = 0; i <= along; ++i)
            ring(length * i / along, std::lerp(from_radius, to_radius, static_cast<double>(i) / along));
        for (uint32_t i = cap; i-- > 1;) {
            const double angle = 0.5 * std::numbers::pi * i / cap;
            ring(length + to_radius * std::cos(angle), to_radius * std::sin(angle));
        }
        const uint32_t top = add(to + to_radius * axis);
        for (uint32_t i = 0; i < around; ++i) {
            const uint32_t next = (i + 1) % around;
            corners.insert(corners.end(), {bottom, rings.front()[next], rings.front()[i]});
            corners.insert(corners.end(), {top, rings.back()[i], rings.back()[next]});
            for (size_t r = 0; r + 1 < rings.size(); ++r) {
                corners.insert(corners.end(), {rings[r][i], rings[r][next], rings[r + 1][next]});
                corners.insert(corners.end(), {rings[r][i], rings[r + 1][next], rings[r + 1][i]});
            }
        }
    }
    void add_ball(const Vec3& at, double radius) {
        add_tube(at - Vec3(0, 1e-4 * radius, 0), radius, at, radius, 40, 1);
    }

    Triangles turned(const Eigen::Matrix3d& turn) const {
        Triangles out = *this;
        for (uint32_t v = 0; v < vertex_count(); ++v) {
            const Vec3 p = turn * at(v);
            for (int k = 0; k < 3; ++k) out.positions[3 * v + k] = static_cast<float>(p[k]);
        }
        return out;
    }
};

// Stands on two legs and holds its arms level, bent forward at the elbows. Faces +z.
inline Triangles solid_person() {
    Triangles t;
    t.add_tube({0, 0.95, 0}, 0.15, {0, 1.4, 0}, 0.17);
    t.add_tube({0, 1.4, 0}, 0.07, {0, 1.7, 0}, 0.1);
    for (const double side : {-1.0, 1.0}) {
        t.add_tube({side * 0.1, 0.95, 0}, 0.09, {side * 0.14, 0.1, 0}, 0.06);
        t.add_tube({side * 0.14, 0.06, 0}, 0.06, {side * 0.14, 0.05, 0.18}, 0.04);
        t.add_tube({side * 0.1, 1.42, 0}, 0.06, {side * 0.5, 1.42, 0}, 0.05);
        t.add_tube({side * 0.5, 1.42, 0}, 0.05, {side * 0.55, 1.42, 0.35}, 0.04);
    }
    return t;
}

// Stands on four legs and looks along -z.
inline Triangles solid_animal() {
    Triangles t;
    t.add_tube({0, 1, -0.5}, 0.28, {0, 1, 0.6}, 0.26);
    t.add_tube({0, 1.1, -0.6}, 0.14, {0, 1.5, -1.0}, 0.12);
    t.add_tube({0, 1.5, -1.0}, 0.15, {0, 1.45, -1.3}, 0.1);
    t.add_tube({0, 1.1, 0.7}, 0.06, {0, 0.8, 1.3}, 0.04);
    for (const double side : {-1.0, 1.0})
        for (const double along : {-0.5, 0.6})
            t.add_tube({side * 0.16, 0.9, along}, 0.1, {side * 0.18, 0.08, along}, 0.07);
    return t;
}

inline FlgMeshView view_of(const Triangles& triangles, FlgColumn& column) {
    column = {FLG_ATTRIBUTE_POSITION, 3, triangles.positions.data(), 0, 0};
    FlgMeshView view{};
    view.struct_size = sizeof view;
    view.vertex_count = triangles.vertex_count();
    view.triangle_count = static_cast<uint32_t>(triangles.corners.size() / 3);
    view.columns = &column;
    view.column_count = 1;
    view.triangles = triangles.corners.data();
    return view;
}

struct RepairedTriangles {
    explicit RepairedTriangles(const Triangles& triangles) : repaired(test_memory()) {
        FlgColumn column;
        const FlgMeshView view = view_of(triangles, column);
        run_now(test_memory(), [&](Pace& pace) { return repair_mesh(pace, view, {.weld_distance = 0.0f}, repaired); });
    }
    const Mesh& mesh() const { return repaired.mesh; }
    RepairedMesh repaired;
};

}  // namespace flg::test
