// SPDX-License-Identifier: MIT
#include "surfaces/mesh_measures_normals.h"

#include <cmath>

namespace flg {

namespace {

// The normal of the corner's triangle, as long as the angle of the corner (radians).
Vec3 angle_normal(const Mesh& mesh, Corner corner) {
    const Vec3 origin = mesh.position(mesh.vertex_at(corner));
    const Vec3 a = mesh.position(mesh.vertex_at(next_corner(corner))) - origin;
    const Vec3 b = mesh.position(mesh.vertex_at(previous_corner(corner))) - origin;
    const Vec3 across = a.cross(b);
    const double size = across.norm();
    if (!(size > 0)) return Vec3::Zero();
    return across * (std::atan2(size, a.dot(b)) / size);
}

}  // namespace

Vec3 vertex_normal(const Mesh& mesh, uint32_t vertex) {
    const Corner first = mesh.corner_of_vertex[vertex];
    Vec3 sum = Vec3::Zero();
    for (Corner corner = first; corner != no_index;) {
        sum += angle_normal(mesh, corner);
        corner = mesh.turn(corner);
        if (corner == first) break;
    }
    return sum.stableNormalized();
}

Vec3 smooth_normal(const Mesh& mesh, const SurfacePoint& point) {
    const Triple& corners = mesh.triangles[point.triangle];
    const double weights[] = {1.0 - point.u - point.v, point.u, point.v};
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        if (weights[k] > 0) sum += weights[k] * vertex_normal(mesh, corners[k]);
    }
    return sum.stableNormalized();
}

VertexNormalsKernel::VertexNormalsKernel(const Mesh& mesh, Memory* memory)
    : mesh_(mesh), normals_(mesh.vertex_count(), memory) {}

bool VertexNormalsKernel::run(uint32_t count) {
    for (; at_ < mesh_.vertex_count(); --count) {
        if (count == 0) return false;
        const Corner first = mesh_.corner_of_vertex[at_];
        if (corner_ == no_index) corner_ = first;
        sum_ += angle_normal(mesh_, corner_);
        corner_ = mesh_.turn(corner_);
        if (corner_ == first || corner_ == no_index) {
            store_vec3(sum_.stableNormalized(), normals_[at_++].data());
            sum_ = Vec3::Zero();
            corner_ = no_index;
        }
    }
    return true;
}

}  // namespace flg
