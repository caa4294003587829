// SPDX-License-Identifier: MIT
// The last step of a repair: the triangles get their vertices' final numbers and their regions, mates become neighbours,
// vertices get a corner.
#pragma once

#include "filigree/filigree_surface.h"
#include "surfaces/mesh_repair_compact.h"
#include "surfaces/mesh_repair_mates.h"

namespace flg {

// A unit is a vertex or a triangle: about 10 ns.
class FinishMeshKernel {
public:
    // Triangles lower than this share of their longest edge are counted as flat.
    static constexpr double flat_height = 1e-6;

    // The neighbours of the mesh are still mates. The last `copy_count` vertices are copies. All but `memory` outlive the kernel.
    FinishMeshKernel(const FlgMeshView& input, const IndexMap& vertices, const IndexMap& triangles, uint32_t copy_count,
                     Mesh& mesh, Memory* memory);
    bool run(uint32_t count);
    // After run() returned true.
    uint32_t flat_count() const { return flat_count_; }

private:
    uint32_t final_number(uint32_t vertex) const;
    void finish(uint32_t triangle);

    const uint32_t* regions_;  // of the input; null: all 0
    const IndexMap& vertices_;
    const IndexMap& triangles_;
    uint32_t input_vertices_;
    uint32_t first_copy_;  // its final number
    Mesh& mesh_;
    uint32_t vertices_done_ = 0;
    uint32_t triangles_done_ = 0;
    uint32_t flat_count_ = 0;
};

}  // namespace flg
