// SPDX-License-Identifier: MIT
// What a mesh is as a whole: components, borders, Euler number and genus; bounding box and area.
#pragma once

#include "surfaces/mesh_measures_borders.h"
#include "surfaces/mesh_measures_components.h"

namespace flg {

struct MeshTopology {
    uint32_t components = 0;
    uint32_t border_loops = 0;
    uint32_t border_edges = 0;
    int64_t euler_number = 0;  // vertices - edges + triangles
    uint32_t genus = 0;        // handles, of all components together
};

// A unit is as those of ComponentsKernel and BordersKernel, which it runs.
class TopologyKernel {
public:
    // Outlives the kernel.
    TopologyKernel(const Mesh& mesh, Memory* memory);
    bool run(uint32_t count);
    // After run() returned true.
    const MeshTopology& topology() const { return topology_; }

private:
    const Mesh& mesh_;
    ComponentsKernel components_;
    BordersKernel borders_;
    bool components_done_ = false;
    MeshTopology topology_;
};

struct MeshExtent {
    Vec3 lower, upper;  // metres, corners of the bounding box
    double area = 0;    // square metres
};

// A unit is a vertex or a triangle: about 10 ns. Sums have a fixed order.
class ExtentKernel {
public:
    // Outlives the kernel; with one vertex at least.
    explicit ExtentKernel(const Mesh& mesh);
    bool run(uint32_t count);
    // After run() returned true.
    const MeshExtent& extent() const { return extent_; }

private:
    const Mesh& mesh_;
    MeshExtent extent_;
    uint32_t vertices_done_ = 0;
    uint32_t triangles_done_ = 0;
};

}  // namespace flg
