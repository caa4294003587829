// SPDX-License-Identifier: MIT
// Meshes of any size.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "filigree/filigree_surface.h"

namespace flg::slices {

struct Mesh {
    std::vector<float> positions;
    std::vector<uint32_t> triangles;
    FlgColumn column{};

    uint32_t vertex_count() const { return static_cast<uint32_t>(positions.size() / 3); }
    uint32_t triangle_count() const { return static_cast<uint32_t>(triangles.size() / 3); }
    void add_vertex(double x, double y, double z) {
        for (const double value : {x, y, z}) positions.push_back(static_cast<float>(value));
    }
    void add_triangle(uint32_t a, uint32_t b, uint32_t c) { triangles.insert(triangles.end(), {a, b, c}); }
    // Lasts as long as the mesh.
    FlgMeshView view() {
        column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
        FlgMeshView made = flgMeshViewDefaults();
        made.vertex_count = vertex_count();
        made.triangle_count = triangle_count();
        made.columns = &column;
        made.column_count = 1;
        made.triangles = triangles.data();
        return made;
    }
};

// A square of 1 m with waves, of some `size` triangles.
inline Mesh waves(uint32_t size) {
    Mesh mesh;
    const auto cells = static_cast<uint32_t>(std::lround(std::sqrt(size / 2.0)));
    const auto at = [&](uint32_t i) { return static_cast<double>(i) / cells; };
    for (uint32_t j = 0; j <= cells; ++j)
        for (uint32_t i = 0; i <= cells; ++i)
            mesh.add_vertex(at(i), at(j), 0.03 * std::sin(12 * at(i)) * std::cos(9 * at(j)));
    for (uint32_t j = 0; j < cells; ++j) {
        for (uint32_t i = 0; i < cells; ++i) {
            const uint32_t a = j * (cells + 1) + i, b = a + cells + 1;
            mesh.add_triangle(a, a + 1, b + 1);
            mesh.add_triangle(a, b + 1, b);
        }
    }
    return mesh;
}

// A closed surface: a ball with arms, of some `size` triangles.
inline Mesh ball(uint32_t size) {
    Mesh mesh;
    const auto across = static_cast<uint32_t>(std::lround(std::sqrt(size / 4.0))), around = 2 * across;
    const double pi = std::acos(-1.0);
    mesh.add_vertex(0, 0, -1);
    for (uint32_t j = 1; j < across; ++j) {
        for (uint32_t i = 0; i < around; ++i) {
            const double v = pi * (static_cast<double>(j) / across - 0.5), u = 2 * pi * i / around;
            const double out = 1 + 0.6 * std::pow(std::cos(v) * std::cos(2 * u), 8);
            mesh.add_vertex(out * std::cos(v) * std::cos(u), out * std::cos(v) * std::sin(u), out * std::sin(v));
        }
    }
    mesh.add_vertex(0, 0, 1);
    const uint32_t top = mesh.vertex_count() - 1;
    for (uint32_t i = 0; i < around; ++i) {
        const uint32_t next = (i + 1) % around;
        mesh.add_triangle(0, 1 + next, 1 + i);
        mesh.add_triangle(top, top - around + i, top - around + next);
        for (uint32_t j = 0; j + 2 < across; ++j) {
            const uint32_t row = 1 + j * around, above = row + around;
            mesh.add_triangle(row + i, row + next, above + next);
            mesh.add_triangle(row + i, above + next, above + i);
        }
    }
    return mesh;
}

// All triangles around one vertex.
inline Mesh fan(uint32_t size) {
    Mesh mesh;
    mesh.add_vertex(0, 0, 0);
    for (uint32_t i = 0; i < size; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / size;
        mesh.add_vertex(std::cos(angle), std::sin(angle), 0.01 * std::cos(7 * angle));
        mesh.add_triangle(0, 1 + i, 1 + (i + 1) % size);
    }
    return mesh;
}

// All triangles at one edge, each with a corner of its own.
inline Mesh book(uint32_t size) {
    Mesh mesh;
    mesh.add_vertex(0, 0, 0);
    mesh.add_vertex(0, 0, 1);
    for (uint32_t i = 0; i < size; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / size;
        mesh.add_vertex(std::cos(angle), std::sin(angle), 0.5);
        mesh.add_triangle(0, 1, 2 + i);
    }
    return mesh;
}

// Triangles that share no vertices, as exporters write them.
inline Mesh soup(uint32_t size) {
    const Mesh whole = waves(size);
    Mesh mesh;
    for (const uint32_t v : whole.triangles) {
        mesh.add_vertex(whole.positions[3 * v], whole.positions[3 * v + 1], whole.positions[3 * v + 2]);
        mesh.triangles.push_back(mesh.vertex_count() - 1);
    }
    return mesh;
}

inline FlgSurface make_surface(auto& host, Mesh mesh, bool with_provenance = false) {
    const FlgMeshView view = mesh.view();
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh = &view;
    desc.provenance = with_provenance;
    FlgSurface surface{};
    host.copy("flgSurfaceCreate", flgSurfaceCreate, &desc, &surface, host.job());
    host.made("flgSurfaceRelease", flgSurfaceRelease, surface);
    return surface;
}

}  // namespace flg::slices
