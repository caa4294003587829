// SPDX-License-Identifier: MIT
// The connected components of a mesh: vertices that triangles join, found by a union-find whose roots are the least
// vertices (paths are halved as they are walked).
#pragma once

#include "surfaces/mesh.h"

namespace flg {

// A unit is a vertex or a triangle: about 10 ns. Memory: 4 bytes a vertex, the result.
class ComponentsKernel {
public:
    // Outlives the kernel.
    ComponentsKernel(const Mesh& mesh, Memory* memory);
    bool run(uint32_t count);

    // After run() returned true.
    uint32_t component_count() const { return component_count_; }
    // Of each vertex: 0 for that of vertex 0, and on by their least vertices.
    Buffer<uint32_t> take() { return std::move(labels_); }

private:
    enum class Pass { single, join, label, done };
    uint32_t root_of(uint32_t vertex);
    void join(uint32_t a, uint32_t b);
    void label(uint32_t vertex);

    const Mesh& mesh_;
    Buffer<uint32_t> labels_;  // until labelled: a lesser vertex of the same component, or the vertex itself
    Pass pass_ = Pass::single;
    uint32_t at_ = 0;
    uint32_t component_count_ = 0;
};

}  // namespace flg
