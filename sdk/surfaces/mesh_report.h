// SPDX-License-Identifier: MIT
// What the repair of a mesh found and did.
#pragma once

#include "surfaces/mesh_measures.h"

namespace flg {

struct MeshReport {
    uint32_t welded_vertices = 0;       // joined to an earlier vertex at the same place
    uint32_t degenerate_triangles = 0;  // that name a vertex twice, once welded: dropped
    uint32_t duplicate_triangles = 0;   // with the vertices of an earlier one, in whichever order: dropped
    uint32_t crowded_edges = 0;         // of more than two triangles: joined in pairs, the rest apart
    uint32_t flipped_triangles = 0;     // wound otherwise than most of their component: turned over
    uint32_t cut_edges = 0;             // opened because both sides could not be kept (Moebius strips, crowded edges)
    uint32_t split_vertices = 0;        // copies made so that each vertex has a single fan
    uint32_t unused_vertices = 0;       // that no triangle left names: dropped
    uint32_t flat_triangles = 0;        // lower than 1e-6 of their longest edge: kept
    MeshTopology topology;              // of the result
};

}  // namespace flg
