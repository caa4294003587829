// SPDX-License-Identifier: MIT
#include "surfaces/mesh_measures.h"

#include "surfaces/mesh_measures_normals.h"

namespace flg {

TopologyKernel::TopologyKernel(const Mesh& mesh, Memory* memory)
    : mesh_(mesh), components_(mesh, memory), borders_(mesh, memory) {}

bool TopologyKernel::run(uint32_t count) {
    if (!components_done_) {
        components_done_ = components_.run(count);
        return false;
    }
    if (!borders_.run(count)) return false;
    topology_.components = components_.component_count();
    topology_.border_loops = borders_.loops().loop_count();
    topology_.border_edges = borders_.loops().vertex_count();
    // Inner edges have two triangles: 2 edges = 3 triangles + border edges.
    const int64_t triangles = mesh_.triangle_count();
    const int64_t edges = (3 * triangles + topology_.border_edges) / 2;
    topology_.euler_number = int64_t{mesh_.vertex_count()} - edges + triangles;
    // Of an orientable component: Euler number = 2 - 2 genus - loops.
    topology_.genus = static_cast<uint32_t>(
        (2 * int64_t{topology_.components} - topology_.border_loops - topology_.euler_number) / 2);
    return true;
}

ExtentKernel::ExtentKernel(const Mesh& mesh) : mesh_(mesh) {
    extent_.lower = extent_.upper = mesh.position(0);
}

bool ExtentKernel::run(uint32_t count) {
    for (; vertices_done_ < mesh_.vertex_count(); --count) {
        if (count == 0) return false;
        const Vec3 position = mesh_.position(vertices_done_++);
        extent_.lower = extent_.lower.cwiseMin(position);
        extent_.upper = extent_.upper.cwiseMax(position);
    }
    for (; triangles_done_ < mesh_.triangle_count(); --count) {
        if (count == 0) return false;
        extent_.area += vector_area(mesh_, triangles_done_++).norm();
    }
    return true;
}

}  // namespace flg
