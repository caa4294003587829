// SPDX-License-Identifier: MIT
// From a host's arrays to a mesh that holds what mesh.h promises, with a report of what that took:
//   weld -> drop degenerate triangles -> join triangles at their edges, drop duplicates -> one winding -> one fan a
//   vertex -> drop unused vertices -> measure.
// What is kept keeps its order; copies of vertices come last. A mesh without defects is only copied and joined.
#pragma once

#include <optional>

#include "filigree/filigree_surface.h"
#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

struct RepairOptions {
    // Metres, finite, >= 0: vertices that lie so near to each other are one. None: each stays itself. Of welded
    // vertices the first one's position, and attributes, count.
    std::optional<float> weld_distance;
};

// What was found and done.
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

// Of vertices or triangles, from the input to the mesh and back. Empty where both are the same.
struct IndexMap {
    Buffer<uint32_t> of_input;         // no_index: dropped; of vertices that were split the first copy
    GrowingBuffer<uint32_t> to_input;  // of vertices that were welded the first
    bool is_identity() const { return to_input.size() == 0; }
};

struct RepairedMesh {
    explicit RepairedMesh(Memory* memory) : mesh(memory) {}

    Mesh mesh;
    MeshReport report;
    IndexMap vertices, triangles;
};

// The arrays of `input` and `repaired`, which is new, outlive the task. Columns other than the position are not read;
// with repaired.vertices they can be carried over. Memory beside the result: 12 bytes a triangle and 8 a vertex, twice
// as much for meshes with defects. Time: about 120 ns a triangle, 60 more to weld at distance 0. Fails: an empty mesh,
// or one of which nothing is left; positions not finite or above 1e30 in size; vertices that do not exist; a weld
// distance out of range; more than 2^31 corners or 1000 triangles at an edge.
Task<void> repair_mesh(Pace& pace, const FlgMeshView& input, RepairOptions options, RepairedMesh& repaired);

}  // namespace flg
