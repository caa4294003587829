#version 450
// SPDX-License-Identifier: MIT
// As surface.vert, of a surface that follows joints.
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "packing.glsl"
#include "surface_draw.glsl"
#include "skin.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 material;  // metallic, roughness, 0, whether the vertex is of the triangle's part
layout(location = 4) in vec4 other_color;  // of the triangle's other part

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec4 out_color_and_field;
layout(location = 3) out vec4 out_material;
#ifdef TEXTURED
layout(location = 7) in vec2 uv;
layout(location = 4) out vec2 out_uv;
#else
layout(location = 4) flat out vec3 out_other_color;
#endif

void main() {
    Motion motion = vertex_motion();
    out_position = placed(moved(motion, position));
    out_normal = placed_direction(turned_normal(motion, octahedral_normal(normal)));
    out_color_and_field = vec4(linear_color(color.rgb), 0.0);
    out_material = material;
#ifdef TEXTURED
    out_uv = uv;
#else
    out_other_color = linear_color(other_color.rgb);
#endif
    gl_Position = view.clip_from_world * vec4(out_position, 1.0);
}
