// SPDX-License-Identifier: MIT
#include "surfaces/mesh_repair_input.h"

#include <cmath>

#include "core/failure.h"
#include "surfaces/mesh_repair_compact.h"

namespace flg {

namespace {

constexpr float coordinate_max = 1e30f;

const FlgColumn& position_column(const FlgMeshView& input) {
    for (uint32_t i = 0; i < input.column_count; ++i) {
        if (input.columns[i].attribute == FLG_ATTRIBUTE_POSITION) return input.columns[i];
    }
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "none of the mesh's %u columns is FLG_ATTRIBUTE_POSITION",
                  input.column_count);
}

}  // namespace

ReadPositionsKernel::ReadPositionsKernel(const FlgMeshView& input, Mesh& mesh, Memory* memory)
    : column_(position_column(input)), vertex_count_(input.vertex_count), mesh_(mesh) {
    if (input.vertex_count == 0 || input.triangle_count == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the mesh is empty: it has %u vertices and %u triangles",
                      input.vertex_count, input.triangle_count);
    }
    if (input.vertex_count > mesh_corners_max || input.triangle_count > mesh_corners_max / 3) {
        throw Failure(FLG_ERROR_LIMIT, "the mesh has %u vertices and %u triangles, the limit is %u and %u",
                      input.vertex_count, input.triangle_count, mesh_corners_max, mesh_corners_max / 3);
    }
    mesh.positions = GrowingBuffer<Position>(vertex_count_, memory);
}

bool ReadPositionsKernel::run(uint32_t count) {
    const size_t stride = column_.stride == 0 ? 3 : column_.stride / sizeof(float);
    const uint32_t end = at_ + std::min(count, vertex_count_ - at_);
    for (; at_ < end; ++at_) {
        const float* position = column_.data + at_ * stride;
        for (uint32_t k = 0; k < 3; ++k) {
            if (!(std::abs(position[k]) <= coordinate_max)) {
                throw Failure(
                    FLG_ERROR_INVALID_ARGUMENT,
                    "vertex %u of the mesh is at (%g, %g, %g): coordinates must be finite and at most %g in size", at_,
                    double{position[0]}, double{position[1]}, double{position[2]}, double{coordinate_max});
            }
            mesh_.positions[at_][k] = position[k];
        }
    }
    return at_ == vertex_count_;
}

ReadTrianglesKernel::ReadTrianglesKernel(const FlgMeshView& input, const Buffer<uint32_t>& welded, Mesh& mesh,
                                         Memory* memory)
    : input_(input), welded_(welded), mesh_(mesh) {
    mesh.triangles = GrowingBuffer<Triple>(input.triangle_count, memory);
}

Triple ReadTrianglesKernel::read(uint32_t triangle) const {
    Triple corners;
    for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t vertex = input_.triangles[size_t{3} * triangle + k];
        if (vertex >= input_.vertex_count) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "triangle %u of the mesh names vertex %u; there are %u vertices",
                          triangle, vertex, input_.vertex_count);
        }
        corners[k] = welded_.empty() ? vertex : welded_[vertex];
    }
    return corners;
}

bool ReadTrianglesKernel::run(uint32_t count) {
    const uint32_t end = at_ + std::min(count, input_.triangle_count - at_);
    for (; at_ < end; ++at_) {
        const Triple corners = read(at_);
        mesh_.triangles[at_] = corners;
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) {
            mark_dropped(mesh_.triangles[at_]);
            ++degenerate_count_;
        }
    }
    return at_ == input_.triangle_count;
}

}  // namespace flg
