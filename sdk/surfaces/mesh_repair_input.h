// SPDX-License-Identifier: MIT
// A host's arrays read into a mesh, and checked on the way.
#pragma once

#include "filigree/filigree_surface.h"
#include "surfaces/mesh.h"

namespace flg {

// The most corners a mesh may have.
constexpr uint32_t mesh_corners_max = uint32_t{1} << 31;

// Positions. A unit is a vertex: 2 ns.
class ReadPositionsKernel {
public:
    // The arrays of `input` and the mesh outlive the kernel. Fails: no vertices or triangles, or too many; no positions.
    ReadPositionsKernel(const FlgMeshView& input, Mesh& mesh, Memory* memory);
    // Fails: positions that are not finite or above 1e30 in size.
    bool run(uint32_t count);

private:
    const FlgColumn& column_;
    uint32_t vertex_count_;
    Mesh& mesh_;
    uint32_t at_ = 0;
};

// Triangles, with the vertices that theirs are welded to. Degenerate ones are marked as dropped (mesh_repair_compact.h).
// A unit is a triangle: 5 ns.
class ReadTrianglesKernel {
public:
    // The arrays of `input` and all else but `memory` outlive the kernel. `welded` is empty if nothing is.
    ReadTrianglesKernel(const FlgMeshView& input, const Buffer<uint32_t>& welded, Mesh& mesh, Memory* memory);
    // Fails: vertices that do not exist.
    bool run(uint32_t count);
    // After run() returned true.
    uint32_t degenerate_count() const { return degenerate_count_; }

private:
    Triple read(uint32_t triangle) const;

    const FlgMeshView& input_;
    const Buffer<uint32_t>& welded_;
    Mesh& mesh_;
    uint32_t at_ = 0;
    uint32_t degenerate_count_ = 0;
};

}  // namespace flg
