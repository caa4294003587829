// SPDX-License-Identifier: MIT
// Finer meshes: each triangle becomes four, by new vertices on its edges.
//   midpoint  New vertices lie half-way; the surface stays as it is.
//   loop      Loop: Smooth subdivision surfaces based on triangles (1987): old vertices move too, towards a surface
//             that is smooth; borders become cubic B-splines, by themselves (Hoppe et al.: Piecewise smooth surface
//             reconstruction, 1994).
// Columns follow the same rule as positions; the four parts keep their triangle's region. All weights are positive:
// values stay within those around them.
// Numbering: old vertices keep their index, triangle t becomes 4 t + k at its corner k, and 4 t + 3 in the middle.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh_growth.h"

namespace flg {

enum class RefineRule { midpoint, loop };

// Replaces the mesh by the one that is `levels` finer, columns likewise. Both outlive the task. About 100 ns a triangle
// of the finer mesh, and 3 ns a component of the columns. Fails before anything is changed: more than 2^31 corners.
Task<void> refine_mesh(Pace& pace, Mesh& mesh, MeshColumns& columns, RefineRule rule, uint32_t levels);

}  // namespace flg
