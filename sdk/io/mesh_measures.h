// SPDX-License-Identifier: MIT
// What all formats' meshes are asked: extent, number of regions, and oddities.
#pragma once

#include "io/mesh_data.h"

namespace flg::io {

struct MeshMeasures {
    float box_min[3] = {0, 0, 0};
    float box_max[3] = {0, 0, 0};
    uint32_t region_count = 1;
};

// Adds warnings to `data` for what it finds odd.
MeshMeasures measure(MeshData& data);

}  // namespace flg::io
