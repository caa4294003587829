#version 450
// SPDX-License-Identifier: MIT
// A triangle over the whole picture, infinitely far away.

layout(location = 0) out vec2 out_at;

void main() {
    out_at = vec2((gl_VertexIndex << 1) & 2, gl_VertexIndex & 2) * 2.0 - 1.0;
    gl_Position = vec4(out_at, 0.0, 1.0);
}
