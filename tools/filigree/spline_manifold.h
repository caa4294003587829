// SPDX-License-Identifier: MIT
// What `filigree spline` takes for SURFACE: a shape by its name, a mesh, a cloud of points.
#pragma once

#include <memory>
#include <string>

#include "documents/mesh_surface.h"
#include "filigree/filigree_spline.h"

namespace flg::cli {

struct SplineManifold {
    FlgManifold handle = {};
    FlgManifoldView view = {};
    std::unique_ptr<MeshSurface> mesh;  // if it is one
    std::string name;
    bool is_space = false;  // of view.ambient dimensions: 2 of the plane among obstacles
};

struct SplineManifoldOptions {
    bool among_obstacles = false;  // a plane is R^2, and surfaces are refused
    double feature = 0;            // metres: the weight of the normals
    double smoothing_scale = 0;    // metres, of meshes and clouds
};

// sphere:R, torus:R,r, plane, space, implicit:NAME, or a file. Says in the report how far the smooth surface is from
// what it was made of. Throws InputError, UsageError.
SplineManifold make_spline_manifold(Session& session, const std::string& text, const SplineManifoldOptions& options,
                                    Report& report);

}  // namespace flg::cli
