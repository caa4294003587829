#version 450
// SPDX-License-Identifier: MIT
// The last pass over the picture: what others stand in the way of is darkened, by the share of its light that comes
// from all around. The picture may be shown larger than it was drawn.
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "picture_place.glsl"

layout(set = 1, binding = 1) uniform sampler2D picture;
layout(set = 1, binding = 2) uniform sampler2D occlusion;  // open share, depth; of every second pixel

layout(location = 0) out vec4 out_color;

const float least_difference = 0.01;  // in depth over depth, from which on a neighbour counts less
const float least_depth = 1e-7;

// The mean of the square about the pixel, as far as it is of the same surface.
float open_share(ivec2 pixel) {
    ivec2 last = (draw.size + 1) / 2 - 1, from = (pixel >> 1) - (square / 2 - 1);
    float depth = depth_at(pixel), per_depth = 1.0 / max(depth, least_depth);
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < square * square; ++i) {
        vec2 there = texelFetch(occlusion, clamp(from + ivec2(i % square, i / square), ivec2(0), last), 0).xy;
        float weight = 1.0 / (least_difference + abs(there.y - depth) * per_depth);
        sum += weight * there.x;
        weights += weight;
    }
    return sum / weights;
}

void main() {
    vec2 at = (floor(gl_FragCoord.xy) - vec2(draw.out_corner) + 0.5) * vec2(draw.size) / vec2(draw.out_size);
    ivec2 pixel = min(ivec2(at), draw.size - 1);
    vec4 drawn;
    if (draw.size == draw.out_size) {
        drawn = texelFetch(picture, pixel, 0);
    } else {
        vec2 within = clamp(at, vec2(0.5), vec2(draw.size) - 0.5);
        drawn = texture(picture, within / vec2(textureSize(picture, 0)));
    }
    float hidden = drawn.a * (1.0 - open_share(pixel));
    // Half a step of 8-bit sRGB up or down, so that gradients show no bands: interleaved gradient noise (Jimenez 2014).
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
    vec3 dither = hidden > 0.0 ? noise * (2.0 / 255.0) * sqrt(drawn.rgb) : vec3(0.0);
    out_color = vec4(drawn.rgb * (1.0 - hidden) + dither, 1.0);
}
