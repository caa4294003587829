// SPDX-License-Identifier: MIT
// From a host's arrays to a mesh that holds what mesh.h promises, with a report of what that took:
//   weld -> drop degenerate triangles -> join triangles at their edges (mesh_repair_pairing.h), drop duplicates -> one
//   winding (mesh_repair_winding.h) -> one fan a vertex (mesh_repair_fans.h) -> drop unused vertices -> measure.
// What is kept keeps its order; copies of vertices come last. A mesh without defects is only copied and joined.
#pragma once

#include <optional>

#include "filigree/filigree_surface.h"
#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh_repair_compact.h"
#include "surfaces/mesh_report.h"

namespace flg {

struct RepairOptions {
    // Metres, finite, >= 0: vertices that lie so near to each other are one (mesh_repair_weld.h). None: each stays itself.
    // Of welded vertices the first one's position, and attributes, count.
    std::optional<float> weld_distance;
};

struct RepairedMesh {
    explicit RepairedMesh(Memory* memory) : mesh(memory) {}

    Mesh mesh;
    MeshReport report;
    IndexMap vertices, triangles;
};

// The arrays of `input` and `repaired`, which is new, outlive the task. Columns other than the position are not read; with
// repaired.vertices they can be carried over. Memory beside the result: 12 bytes a triangle and 8 a vertex, twice as much
// for meshes with defects. Time: about 120 ns a triangle, 60 more to weld at distance 0.
// Fails: an empty mesh, or one of which nothing is left; positions not finite or above 1e30 in size; vertices that do not
// exist; a weld distance out of range; more than 2^31 corners or 1000 triangles at an edge.
Task<void> repair_mesh(Pace& pace, const FlgMeshView& input, RepairOptions options, RepairedMesh& repaired);

}  // namespace flg
