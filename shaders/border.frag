#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "lighting.glsl"

layout(location = 0) in vec3 color;
layout(location = 0) out vec4 out_color;

void main() {
    // As if it were lit by the sky alone: lines read the same everywhere.
    out_color = vec4(tone_map(color * view.sky_color.rgb), 0.0);
}
