// SPDX-License-Identifier: MIT
// How a surface looks. Colours are linear RGB, 0 to 1.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace flg::render {

struct Material {
    glm::vec3 color{0.42f, 0.36f, 0.31f};
    float metallic = 0.0f;   // 0 = paint, clay, wood to 1 = bare metal
    float roughness = 0.5f;  // 0 = polished to 1 = matte
    // Of the lines between regions of this label and those of lower labels, in place of the look's: 0.5 to 64 pixels; 0 = the
    // look's lines.
    float border_width_px = 0.0f;
    glm::vec3 border_color{0.02f, 0.02f, 0.03f};
};

// What comes further down goes over what comes further up.
struct SurfaceLook {
    // Its colour is that of surfaces without a COLOR column.
    Material material{};
    // By label: triangles with the label i have regions[i % regions.size()]. Empty: labels don't show.
    std::vector<Material> regions{};

    // Whether the colour shows the field's values, where they are finite, by field_color(); infinite ones are grey.
    bool show_field = true;
    // The values that get the map's first and last colour; equal: the least and the largest of the finite values.
    float field_low = 0.0f;
    float field_high = 0.0f;
    // Lines where the field is a whole multiple of this, in the field's unit; 0 = none. Where they would be nearer to each
    // other than a few pixels they fade into a tint.
    float isoline_spacing = 0.0f;
    float isoline_width_px = 1.3f;  // 0.5 to 64
    glm::vec3 isoline_color{0.02f, 0.02f, 0.03f};

    // Lines along edges between triangles of different labels; 0 = none, else 0.5 to 64 pixels.
    float border_width_px = 0.0f;
    glm::vec3 border_color{0.02f, 0.02f, 0.03f};

    // Shading by normals of the vertices: of the NORMAL column, else the mean of the triangles' around, by their angles.
    // False: each triangle is flat.
    bool smooth = true;
    bool casts_shadow = true;
};

// The colour of a field's value on its way from the lowest (0) to the highest (1); values outside get the ends' colours.
// Made in OKLab (Ottosson 2020): equal steps are of equal lightness, deep violet blue over green to light yellow, so that
// it reads the same in grey.
glm::vec3 field_color(float t);

}  // namespace flg::render
