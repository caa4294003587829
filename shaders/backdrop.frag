#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "lighting.glsl"

// A gradient like a studio's paper roll, and on the floor of it the scene's shadow.

layout(location = 0) in vec2 at;  // -1..1, y down
layout(location = 0) out vec4 out_color;

const float ground_spread = 3.0;      // texels between the taps of the shadow's filter
const float shadow_darkness = 0.55;
const float vignette = 0.16;          // how much darker the corners are
const float fade_begin = 1.5;         // where the floor begins to melt into the gradient, radii of the scene
const float fade_end = 6.0;

float floor_light(vec3 position) {
    // Most of the floor lies outside the map: no need to look.
    vec2 clip = abs((view.shadow_from_world * vec4(position, 1.0)).xy);
    float reach = 4.0 * ground_spread * view.sun_color.w;
    if (max(clip.x, clip.y) > 1.0 + reach) return 1.0;
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 shift = vec2(float(i & 1) - 0.5, float(i >> 1) - 0.5) * 2.0 * ground_spread * view.sun_direction.w;
        lit += 0.25 * sunlight(position + vec3(shift.x, 0.0, shift.y), vec3(0.0), ground_spread);
    }
    return lit;
}

void main() {
    vec3 ray = normalize(view.ray_forward.xyz + at.x * view.ray_right.xyz - at.y * view.ray_up.xyz);
    float height = 0.5 - 0.5 * at.y;
    vec3 color = mix(view.background_bottom.rgb, view.background_top.rgb, smoothstep(0.15, 1.0, height));

    float above = view.eye.y - view.ray_right.w;
    if (view.ray_up.w > 0.0 && ray.y < -1e-4 && above > 0.0) {
        vec3 hit = view.eye.xyz + ray * (above / -ray.y);
        float away = length(hit - view.scene_center.xyz) / view.ray_forward.w;
        float presence = 1.0 - smoothstep(fade_begin, fade_end, away);
        if (presence > 0.0) color *= 1.0 - shadow_darkness * presence * (1.0 - floor_light(hit));
    }
    color *= 1.0 - vignette * 0.5 * dot(at, at);
    vec3 shown = tone_map(color);
    // Half a step of 8-bit sRGB up or down, so that the gradient shows no bands: interleaved gradient noise (Jimenez 2014).
    vec2 pixel = floor((at + 1.0) / vec2(view.background_top.w, view.background_bottom.w)) + 0.5;  // of the viewport
    float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
    out_color = vec4(shown + noise * (2.0 / 255.0) * sqrt(shown), 1.0);
}
