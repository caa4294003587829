// SPDX-License-Identifier: MIT
// A surface as the device wants it: vertices that carry all of their look, indices, and the edges between regions. A
// vertex where several regions meet is there once a region, so that colours don't run into each other. Host only; no
// Vulkan here.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "filigree_renderer/renderer.h"

namespace flg::render {

// Mirrors the vertex input of shaders/surface.vert; the position is apart, for the shadow map.
struct SurfaceVertex {
    uint32_t normal;  // octahedral, 2 x snorm16
    uint32_t color;   // sRGB, 4 x unorm8
    uint32_t
        material;  // 4 x unorm8: metallic, roughness, whether the field is known, whether it is of the triangle's part
    union {
        float field;           // 0 where it isn't
        uint32_t other_color;  // of skins, which have no field: of the triangle's other part, as `color`
    };
};

constexpr uint32_t max_vertices = (1u << 24) - 1;  // indices of devices without fullDrawIndexUint32
constexpr uint32_t own_part = 0xff000000u;         // in a material's bits

// Mirrors the vertex input of shaders/border.vert.
struct BorderEdge {
    glm::vec3 from, to;
    uint32_t color;  // sRGB, 4 x unorm8
    float half_width_px;
};

struct SurfaceData {
    std::vector<glm::vec3> positions;
    std::vector<SurfaceVertex> vertices;
    std::vector<uint32_t> indices;
    std::vector<BorderEdge> borders;  // each edge once
    std::vector<uint32_t> copied;     // the vertices that the last ones are copies of
    std::vector<glm::vec2> uvs;       // of vertices, or none
    struct Run {
        uint32_t texture, index_count;  // of indices that follow those before
    };
    std::vector<Run> runs;  // with textures: all indices
    Box box;
    bool has_field = false;
    float field_low = 0.0f, field_high = 0.0f;  // what the colour map spans
};

// What the look has a vertex' material times; white without colours of vertices.
glm::vec3 vertex_color(const SurfaceLook& look, uint32_t vertex);

// Throws Error for a mesh, a look or a field that can't be used. `field`: one value a vertex, or empty.
SurfaceData prepare_surface(const FlgMeshView& mesh, const SurfaceLook& look, std::span<const float> field);

}  // namespace flg::render
