#version 450
// SPDX-License-Identifier: MIT
// Colours are sRGB values all the way: neither the texture nor the picture is decoded.

layout(set = 0, binding = 0) uniform sampler2D image;

layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 color;
layout(location = 0) out vec4 out_color;

void main() {
    out_color = color * texture(image, uv);
}
