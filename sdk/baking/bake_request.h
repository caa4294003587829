// SPDX-License-Identifier: MIT
// What flgTangleBake was asked for: checked as far as the surface need not be known, and copied.
#pragma once

#include <cstdint>

#include "surfaces/mesh/mesh.h"

namespace flg {

// The host's memory; null: not wanted.
struct BakedMaps {
    uint32_t* ids = nullptr;
    float* distances = nullptr;
    uint8_t* borders = nullptr;
    float* heights = nullptr;
    float* normals = nullptr;
    float* blends = nullptr;
};

struct BakeRequest {
    uint32_t size = 0;  // texels a side
    uint32_t padding = 0;
    float border_width = 0;  // metres
    uint32_t component_count = 0;
    uint32_t region_count = 0;  // with values
    uint32_t mesh_region = no_index;
    Buffer<Position> positions;  // of the mesh's vertices
    Buffer<float> corner_uvs;    // 6 per triangle of the mesh
    Buffer<uint32_t> labels;     // of the mesh's triangles; empty: all are drawn
    Buffer<float> region_values;
    BakedMaps maps;

    uint32_t triangle_count() const { return static_cast<uint32_t>(corner_uvs.size() / 6); }
    bool draws(uint32_t triangle) const { return labels.empty() || labels[triangle] == mesh_region; }
    bool wants_distances() const { return maps.distances || maps.borders || maps.blends; }
    bool wants_heights() const { return maps.heights || maps.normals; }
};

}  // namespace flg
