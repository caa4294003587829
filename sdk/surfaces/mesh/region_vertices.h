// SPDX-License-Identifier: MIT
// The vertices of regions.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

enum class RegionRim { without, with };  // the corners of the triangles beyond the regions' borders

// Rising. Some ns a triangle within; a bit a vertex of the mesh.
Task<Buffer<uint32_t>> vertices_of(Pace& pace, const Mesh& mesh, const RegionSet& regions, RegionRim rim);

}  // namespace flg
