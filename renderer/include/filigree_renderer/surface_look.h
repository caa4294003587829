// SPDX-License-Identifier: MIT
// Appearance of a surface. Colours are linear RGB, 0 to 1.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace flg::render {

struct Material {
    glm::vec3 color{0.42f, 0.36f, 0.31f};
    float metallic = 0.0f;   // 0 = paint, clay, wood to 1 = bare metal
    float roughness = 0.5f;  // 0 = polished to 1 = matte
    // Lines between regions of this label and those of lower labels, in place of the look's: 0.5 to 64 pixels; 0 = the
    // look's lines.
    float border_width_px = 0.0f;
    glm::vec3 border_color{0.02f, 0.02f, 0.03f};
};

// Later fields are drawn over earlier ones.
struct SurfaceLook {
    // Its colour applies to surfaces without a COLOR column.
    Material material{};
    // By label: triangles with label i use regions[i % regions.size()]. Empty: labels are not shown.
    std::vector<Material> regions{};

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
