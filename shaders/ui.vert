#version 450
// SPDX-License-Identifier: MIT
// Triangles in pixels of the target.

layout(push_constant) uniform Draw {
    vec2 per_pixel;  // 2 / size of the target
} draw;

layout(location = 0) in vec2 position_px;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;

layout(location = 0) out vec2 out_uv;
layout(location = 1) out vec4 out_color;

void main() {
    out_uv = uv;
    out_color = color;
    gl_Position = vec4(position_px * draw.per_pixel - 1.0, 0.0, 1.0);
}
