// SPDX-License-Identifier: MIT
// Which vertices an edit touched, for what is kept beside the mesh and must follow it (geodesic blocks and graphs): only
// those that were there before; added ones are known by their index. The same lists hold after it was taken back.
#pragma once

#include "surfaces/mesh_edit.h"

namespace flg {

struct TouchedVertices {
    explicit TouchedVertices(Memory* memory) : changed(memory), facing(memory) {}

    std::pmr::deque<uint32_t> changed;  // of changed triangles, moved corners among the changes
    std::pmr::deque<uint32_t> facing;   // of others that share an edge with a changed one, opposite to that edge
};

class TouchedVertexSearch {
public:
    // After the edit, before any other. All must outlive the run. Memory while it runs: a bit a vertex.
    TouchedVertexSearch(const Mesh& mesh, const MeshEdit& edit, TouchedVertices& out, Memory* memory);

    // Spends `count` units of about 50 ns; true when done. 64 vertices take one, a word that was overwritten and a triangle
    // that was added take two, a unit for a vertex that moved six times as long.
    bool run(uint32_t count);

private:
    enum class Pass { clear, changed, facing, done };

    size_t size_of(Pass pass) const;
    void visit(uint32_t triangle);
    void visit_around(uint32_t vertex);
    void touch(uint32_t vertex, std::pmr::deque<uint32_t>& list);

    const Mesh& mesh_;
    const MeshEdit& edit_;
    TouchedVertices& out_;
    Buffer<uint64_t> touched_;
    Pass pass_ = Pass::clear;
    size_t at_ = 0;
};

}  // namespace flg
