#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "surface_draw.glsl"
#include "skin.glsl"

layout(location = 0) in vec3 position;

void main() {
    gl_Position = view.clip_from_world * vec4(placed(moved(vertex_motion(), position)), 1.0);
}
