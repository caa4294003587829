// SPDX-License-Identifier: MIT
// Curves for the tests of cutting: straight lines in the plane, random walks; and a mesh that is cut along them.
#pragma once

#include <set>

#include "surfaces/cut_meshes.h"
#include "surfaces/cutting/cut_curves.h"
#include "surfaces/cutting/cut_regions.h"

namespace flg::test {

inline void add_curve(SurfaceCurves& curves, const std::vector<SurfacePoint>& points, bool closed = false) {
    curves.points.insert(curves.points.end(), points.begin(), points.end());
    curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
    curves.closed.push_back(closed);
    curves.values.push_back(0);
}

// The corners of the triangle in the plane z = 0.
inline double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b - a).cross(c - a).z();
}

// Of a point in the plane z = 0, in a triangle; clamped to it.
inline SurfacePoint in_triangle(const Mesh& mesh, uint32_t triangle, const Vec3& p) {
    const auto [a, b, c] = mesh.triangles[triangle];
    const Vec3 x = mesh.position(a), y = mesh.position(b), z = mesh.position(c);
    const double area = turn(x, y, z);
    const double u = std::clamp(turn(x, p, z) / area, 0.0, 1.0), v = std::clamp(turn(x, y, p) / area, 0.0, 1.0 - u);
    return {triangle, static_cast<float>(u), static_cast<float>(v)};
}

inline uint32_t triangle_at(const Mesh& mesh, const Vec3& p) {
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        const Vec3 x = mesh.position(a), y = mesh.position(b), z = mesh.position(c);
        if (turn(x, y, p) >= 0 && turn(y, z, p) >= 0 && turn(z, x, p) >= 0) return t;
    }
    return no_index;
}

// The straight way from a to b in a mesh of the plane z = 0, without b itself. It must not meet a vertex.
inline std::vector<SurfacePoint> straight(const Mesh& mesh, const Vec3& a, const Vec3& b) {
    uint32_t triangle = triangle_at(mesh, a);
    std::vector<SurfacePoint> points = {in_triangle(mesh, triangle, a)};
    uint32_t from = no_index;
    while (triangle != triangle_at(mesh, b)) {
        for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
            const Vec3 x = mesh.position(mesh.vertex_at(corner)),
                       y = mesh.position(mesh.vertex_at(next_corner(corner)));
            const uint32_t next = mesh.neighbour_at(corner);
            if (next == no_index || next == from || turn(a, b, x) > 0 || turn(a, b, y) < 0) continue;
            const double t = turn(a, b, x) / (turn(a, b, x) - turn(a, b, y));
            points.push_back(point_on_edge(mesh.opposite(corner), static_cast<float>(1 - t)));
            from = std::exchange(triangle, next);
            break;
        }
    }
    return points;
}

struct CurveCase {
    explicit CurveCase(const Soup& soup) : mesh(make_mesh(soup)) {
        columns.push_back(make_column(mesh, [](const Vec3& p) { return p.x() - 2 * p.y() + p.z(); }));
    }
    void add_line(std::vector<Vec3> corners, bool closed = false) {
        std::vector<SurfacePoint> points;
        if (closed) corners.push_back(corners[0]);
        for (size_t i = 0; i + 1 < corners.size(); ++i) {
            const std::vector<SurfacePoint> part = straight(mesh, corners[i], corners[i + 1]);
            points.insert(points.end(), part.begin(), part.end());
        }
        if (!closed) points.push_back(in_triangle(mesh, triangle_at(mesh, corners.back()), corners.back()));
        add_curve(curves, points, closed);
    }
    void run(uint32_t first_label = 1, bool haltingly = false) {
        run_now(
            test_memory(), [&](Pace& pace) { return embed_curves(pace, mesh, columns, curves, edit, out); }, haltingly);
        run_now(
            test_memory(), [&](Pace& pace) { return divide_regions(pace, mesh, out.edges, first_label, edit, parts); },
            haltingly);
    }

    Mesh mesh;
    MeshColumns columns{test_memory()};
    SurfaceCurves curves{test_memory()};
    MeshEdit edit{test_memory()};
    EmbeddedCurves out{test_memory()};
    std::pmr::deque<RegionPart> parts;
};

inline std::set<std::pair<uint32_t, uint32_t>> edges_of(const Mesh& mesh) {
    std::set<std::pair<uint32_t, uint32_t>> edges;
    for (Corner corner = 0; corner < 3 * mesh.triangle_count(); ++corner) {
        edges.insert(std::minmax(mesh.vertex_at(corner), mesh.vertex_at(next_corner(corner))));
    }
    return edges;
}

// Each curve is a chain of edges of the mesh, and exactly those edges are named.
inline void expect_chains(const CurveCase& cut) {
    ASSERT_EQ(cut.out.offsets.size(), cut.curves.curve_count() + 1);
    std::set<std::pair<uint32_t, uint32_t>> chained, named;
    for (uint32_t c = 0; c < cut.curves.curve_count(); ++c) {
        const uint32_t first = cut.out.offsets[c], end = cut.out.offsets[c + 1];
        ASSERT_LT(first, end);
        for (uint32_t i = first; i + 1 < end; ++i) {
            chained.insert(std::minmax(cut.out.vertices[i], cut.out.vertices[i + 1]));
        }
        if (cut.curves.closed[c] && end - first > 1) {
            chained.insert(std::minmax(cut.out.vertices[end - 1], cut.out.vertices[first]));
        }
    }
    for (Corner corner : cut.out.edges) {
        named.insert(std::minmax(cut.mesh.vertex_at(corner), cut.mesh.vertex_at(next_corner(corner))));
    }
    const auto edges = edges_of(cut.mesh);
    for (const auto& edge : chained) EXPECT_TRUE(edges.contains(edge)) << edge.first << "-" << edge.second;
    EXPECT_EQ(chained, named);
}

// A walk from triangle to triangle: across edges, through vertices, sometimes with a corner inside.
inline std::vector<SurfacePoint> random_walk(const Mesh& mesh, uint64_t seed, uint64_t walk, uint32_t length) {
    uint64_t draw = 0;
    const auto below = [&](uint32_t count) { return random_below(seed, walk, draw++, count); };
    const auto unit = [&] { return static_cast<float>(random_unit(seed, walk, draw++)); };
    uint32_t triangle = below(mesh.triangle_count());
    const float start = unit();
    std::vector<SurfacePoint> points = {{triangle, start * 0.5f, unit() * 0.5f}};
    for (uint32_t i = 0; i < length; ++i) {
        const Corner corner = 3 * triangle + below(3);
        const uint32_t kind = below(8);
        if (kind == 0) {
            points.push_back({triangle, 0.3f * unit(), 0.7f * unit()});
        } else if (kind == 1) {
            // To a vertex, then into any triangle there.
            Corner next = corner;
            for (uint32_t turns = below(6); turns > 0 && mesh.turn(next) != no_index; --turns) next = mesh.turn(next);
            points.push_back(point_on_edge(next, 0));
            triangle = triangle_of(next);
        } else {
            const Corner across = mesh.opposite(corner);
            const float t = kind == 2 ? 0.02f * unit() : unit();
            if (across == no_index) continue;
            points.push_back(point_on_edge(across, t));
            triangle = triangle_of(across);
        }
    }
    points.push_back({triangle, 0.4f, 0.3f});
    return points;
}

}  // namespace flg::test
