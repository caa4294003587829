#version 450
// SPDX-License-Identifier: MIT
// As surface.vert, of a surface that follows joints.
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "packing.glsl"
#include "skin.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec2 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec4 material;  // metallic, roughness, whether the field is known
layout(location = 4) in float field;

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec3 out_color;
layout(location = 3) out vec3 out_material;
layout(location = 4) out float out_field;

void main() {
    Motion motion = vertex_motion();
    out_position = moved(motion, position);
    out_normal = turned_normal(motion, octahedral_normal(normal));
    out_color = linear_color(color.rgb);
    out_material = material.xyz;
    out_field = field;
    gl_Position = view.clip_from_world * vec4(out_position, 1.0);
}
