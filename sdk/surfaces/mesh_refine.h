// SPDX-License-Identifier: MIT
// Finer meshes: each triangle becomes four, by new vertices on its edges.
//   midpoint  New vertices lie half-way; the surface stays as it is.
//   loop      Loop: Smooth subdivision surfaces based on triangles (1987): old vertices move too, towards a surface that is
//             smooth; borders become cubic B-splines, by themselves (Hoppe et al.: Piecewise smooth surface
//             reconstruction, 1994).
// Columns follow the same rule as positions; the four parts keep their triangle's region.
// Numbering: old vertices keep their index, triangle t becomes 4 t + k at its corner k, and 4 t + 3 in the middle.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh_growth.h"
#include "surfaces/mesh_refine_values.h"

namespace flg {

// The triangles of the finer mesh with their neighbours and regions, and room for its vertices' positions. A unit is a
// triangle: about 30 ns.
class RefineTrianglesKernel {
public:
    // Both outlive the kernel; `fine` is new.
    RefineTrianglesKernel(const Mesh& coarse, Mesh& fine, Memory* memory);
    bool run(uint32_t count);

private:
    void make_room();
    void split(uint32_t triangle);

    const Mesh& coarse_;
    Mesh& fine_;
    Memory* memory_;
    uint32_t border_edges_ = 0;
    uint32_t counted_ = 0;
    uint32_t at_ = 0;
    uint32_t next_vertex_ = 0;
};

// Replaces the mesh by the one that is `levels` finer, columns likewise. Both outlive the task.
// Fails before anything is changed: more than 2^31 corners.
Task<void> refine_mesh(Pace& pace, Mesh& mesh, MeshColumns& columns, RefineRule rule, uint32_t levels);

}  // namespace flg
