// SPDX-License-Identifier: MIT
// Faces of more than three corners as triangles.
#pragma once

#include "io/base/mesh_data.h"

namespace flg::io {

// Replaces the fans of concave polygons by triangulations that stay inside them. All indices must be sound.
void split_concave_polygons(MeshData& data);

}  // namespace flg::io
