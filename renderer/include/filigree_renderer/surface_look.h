// SPDX-License-Identifier: MIT
// Appearance of a surface. Colours are linear RGB, 0 to 1.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "filigree_renderer/image.h"

namespace flg::render {

// How a texture goes on beyond its picture: from its other side, by its edge, mirrored.
enum class Wrap { repeat, clamp, mirror };

struct SurfaceTexture {
    Image image;
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool nearest = false;  // near by, texels are not blended
};

constexpr uint32_t no_texture = 0xffffffffu;

struct Material {
    glm::vec3 color{0.42f, 0.36f, 0.31f};
    float metallic = 0.0f;   // 0 = paint, clay, wood to 1 = bare metal
    float roughness = 0.5f;  // 0 = polished to 1 = matte
    // Lines between regions of this label and those of lower labels, in place of the look's: 0.5 to 64 pixels; 0 = the
    // look's lines.
    float border_width_px = 0.0f;
    glm::vec3 border_color{0.02f, 0.02f, 0.03f};
    uint32_t texture = no_texture;  // of the look's: its colour, times this material's
};

// Later fields are drawn over earlier ones.
struct SurfaceLook {
    // Its colour applies to surfaces without a COLOR column.
    Material material{};
    // By label: triangles with label i use regions[i % regions.size()]. Empty: labels are not shown.
    std::vector<Material> regions{};
    // What materials refer to. Seen where there are texture coordinates: a skin's own, else `corner_uvs`, 6 numbers a
    // triangle: 0 0 is a picture's upper left, 1 1 its lower right. They are read while the surface is uploaded;
    // coarser levels of pictures are made then.
    std::vector<SurfaceTexture> textures{};
    std::span<const float> corner_uvs{};
    // Times the materials' colours: 4 numbers a vertex, linear RGBA, 0 to 1 (the last does not count). Read by upload()
    // and update(). With these a mesh's COLOR column does not count.
    std::span<const float> vertex_colors{};

    // Whether the colour shows the field's values by field_color(); infinite values are grey.
    bool show_field = true;
    // Values that map to the first and last colour; equal: the least and the largest finite value.
    float field_low = 0.0f;
    float field_high = 0.0f;
    // Lines where the field is a whole multiple of this, in the field's unit; 0 = none. Lines closer than a few pixels
    // fade into a tint.
    float isoline_spacing = 0.0f;
    float isoline_width_px = 1.3f;  // 0.5 to 64
    glm::vec3 isoline_color{0.02f, 0.02f, 0.03f};

    // Lines along edges between triangles of different labels; 0 = none, else 0.5 to 64 pixels.
    float border_width_px = 0.0f;
    glm::vec3 border_color{0.02f, 0.02f, 0.03f};

    // Shading by vertex normals: the NORMAL column, else the mean of the surrounding triangles' normals, weighted by
    // angle. False: each triangle is flat.
    bool smooth = true;
    bool casts_shadow = true;
};

// The colour of a field's value between the lowest (0) and the highest (1); values outside get the ends' colours. Made
// in OKLab (Ottosson 2020): equal steps have equal lightness, from deep violet blue over green to light yellow, so it
// reads the same in grey.
glm::vec3 field_color(float t);

}  // namespace flg::render
