// SPDX-License-Identifier: MIT
// Manifolds and splines for the tests behind the C ABI.
#pragma once

#include "api/surface_inputs.h"
#include "filigree/filigree_spline.h"

namespace flg::test {

inline FlgManifold shape_manifold(const Host& host, FlgManifoldShape kind, double radius = 1, double tube = 0.25,
                                  uint32_t ambient = 3) {
    FlgManifoldShapeDesc desc = flgManifoldShapeDefaults();
    desc.shape = kind;
    desc.radius = radius;
    desc.tube_radius = tube;
    desc.ambient = ambient;
    FlgManifold manifold{};
    EXPECT_EQ(flgManifoldCreateShape(host.context, &desc, &manifold), FLG_OK) << flgErrorGetMessage();
    return manifold;
}

inline FlgSurface mesh_surface(const Host& host, MeshArrays mesh) {
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    const FlgMeshView input = mesh.view();
    desc.mesh = &input;
    FlgSurface surface{};
    EXPECT_EQ(flgSurfaceCreate(host.context, &desc, &surface, nullptr), FLG_OK) << flgErrorGetMessage();
    return surface;
}

inline FlgManifold mesh_manifold(const Host& host, FlgSurface surface) {
    FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
    desc.surface = surface;
    FlgManifold manifold{};
    EXPECT_EQ(flgManifoldCreateFromSurface(host.context, &desc, &manifold, nullptr), FLG_OK) << flgErrorGetMessage();
    return manifold;
}
inline FlgManifold mesh_manifold(const Host& host, MeshArrays mesh) {
    return mesh_manifold(host, mesh_surface(host, std::move(mesh)));
}

inline FlgObstacles make_obstacles(const Host& host, const std::vector<FlgObstacle>& solids, uint32_t dimension = 3,
                                   double clearance = 0) {
    FlgObstaclesDesc desc = flgObstaclesDefaults();
    desc.dimension = dimension;
    desc.obstacles = solids.data();
    desc.obstacle_count = static_cast<uint32_t>(solids.size());
    desc.clearance = clearance;
    FlgObstacles out{};
    EXPECT_EQ(flgObstaclesCreate(host.context, &desc, &out, nullptr), FLG_OK) << flgErrorGetMessage();
    return out;
}

// Around the z-axis, closed, its normals outwards.
inline MeshArrays torus_mesh(uint32_t around, uint32_t across, double radius, double tube) {
    MeshArrays mesh;
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < across; ++j) {
            const double a = 2 * M_PI * i / around, b = 2 * M_PI * j / across, r = radius + tube * std::cos(b);
            mesh.add_vertex(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
        }
    }
    for (uint32_t i = 0; i < around; ++i) {
        for (uint32_t j = 0; j < across; ++j) {
            const uint32_t i2 = (i + 1) % around, j2 = (j + 1) % across;
            mesh.add_triangle(i * across + j, i2 * across + j, i2 * across + j2);
            mesh.add_triangle(i * across + j, i2 * across + j2, i * across + j2);
        }
    }
    return mesh;
}

// Points of a torus, winding about it.
inline std::vector<double> torus_points(uint32_t count, double radius, double tube) {
    std::vector<double> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double a = 2 * M_PI * i / count, b = 1.2 * std::sin(2.0 * i), r = radius + tube * std::cos(b);
        points.insert(points.end(), {r * std::cos(a), r * std::sin(a), tube * std::sin(b)});
    }
    return points;
}

inline FlgSplineDesc spline_desc(FlgManifold manifold, const std::vector<double>& points, uint32_t ambient = 3) {
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold;
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size() / ambient);
    return desc;
}

struct MadeSpline {
    FlgSpline spline{};
    FlgJob job{};
    FlgResult result = FLG_OK;
    std::string error;
    FlgSplineView view = flgSplineViewDefaults();

    Point node(uint32_t i) const {
        Point p{};
        for (uint32_t c = 0; c < view.ambient && c < 3; ++c) p[c] = view.nodes[size_t{view.ambient} * i + c];
        return p;
    }
};

inline MadeSpline make_spline(const Host& host, const FlgSplineDesc& desc, uint32_t budget_us = FLG_UNLIMITED) {
    MadeSpline made;
    EXPECT_EQ(flgSplineCreate(host.context, &desc, &made.spline, &made.job), FLG_OK) << flgErrorGetMessage();
    host.finish(budget_us);
    made.result = flgSplineGetView(host.context, made.spline, &made.view);
    if (made.result < 0) made.error = flgErrorGetMessage();
    return made;
}

}  // namespace flg::test
