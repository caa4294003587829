// SPDX-License-Identifier: MIT
// Which triangle of a closed mesh is across each side of each other, and how that changes when sides are flipped.
#pragma once

#include <vector>

#include "core/vec.h"
#include "inflation/mesh_laplacian.h"

namespace flg {

// The triangle across each side: side k is opposite to corner k. By triangle.
using Across = std::array<uint32_t, 3>;

class MeshSides {
public:
    // Of a closed manifold. All outlive the kernel.
    MeshSides(uint32_t vertices, std::span<const TriangleVertices> triangles, std::span<Across> out, Memory* memory);

    // A unit is about 0.2 us.
    bool run(uint32_t count);

private:
    enum class Pass { clear, count, sum, scatter, match, done };

    std::span<const TriangleVertices> triangles_;
    std::span<Across> out_;
    Buffer<uint32_t> offsets_;  // by vertex, of the sides that begin there
    Buffer<uint32_t> sides_;    // 3 * triangle + side
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
