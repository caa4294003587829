#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "lighting.glsl"

// A gradient like a studio's paper roll, and on the floor of it a pool of light and the scene's shadow. The shadow is
// sharp where it touches what casts it and softer further away: Percentage-Closer Soft Shadows (Fernando, 2005), with
// taps on Vogel's spiral.

layout(location = 0) in vec2 at;  // -1..1, y down
layout(location = 0) out vec4 out_color;

const float shadow_darkness = 0.64;
const float sun_tangent = 0.022;       // of half the angle that the sun seems to have
const float least_penumbra = 2.0;      // texels
const int blocker_taps = 10, light_taps = 16;
const float vignette = 0.16;           // how much darker the corners are
const float pool_light = 0.14;         // by how much the floor is brighter about the scene
const float pool_end = 4.0;            // where that ends, radii of the scene
const float fade_begin = 1.5;          // where the floor begins to melt into the gradient, radii of the scene
const float fade_end = 6.0;

float floor_light(vec3 position) {
    if (view.sun_color.w == 0.0) return 1.0;
    vec3 there = shadow_place(position, vec3(0.0), 0.0);
    mat3 rows = transpose(mat3(view.shadow_from_world));
    vec2 per_metre = 0.5 * vec2(length(rows[0]), length(rows[1]));
    vec2 least = least_penumbra * view.sun_direction.w * per_metre;
    vec2 search = max(sun_tangent * there.z * view.scene_center.w * per_metre, least);
    // Most of the floor lies outside the map: no need to look.
    if (any(greaterThan(abs(there.xy - 0.5), vec2(0.5) + search))) return 1.0;
    float blocked = 0.0, gap = 0.0;
    for (int i = 0; i < blocker_taps; ++i) {
        float depth = texture(shadow_depths, there.xy + search * spiral(i, blocker_taps)).x;
        if (depth >= there.z) continue;
        blocked += 1.0;
        gap += there.z - depth;
    }
    if (blocked == 0.0) return 1.0;
    vec2 penumbra = max(sun_tangent * gap / blocked * view.scene_center.w * per_metre, least);
    float lit = 0.0;
    for (int i = 0; i < light_taps; ++i)
        lit += texture(shadow_map, there + vec3(penumbra * spiral(i, light_taps), 0.0));
    return lit / float(light_taps);
}

void main() {
    vec3 ray = normalize(view.ray_forward.xyz + at.x * view.ray_right.xyz - at.y * view.ray_up.xyz);
    float height = 0.5 - 0.5 * at.y;
    vec3 color = mix(view.background_bottom.rgb, view.background_top.rgb, smoothstep(0.15, 1.0, height));

    float open = 0.0;  // share of the light on it that others can stand in the way of
    float above = view.eye.y - view.ray_right.w;
    if (view.ray_up.w > 0.0 && ray.y < -1e-4 && above > 0.0) {
        vec3 hit = view.eye.xyz + ray * (above / -ray.y);
        float away = length(hit - view.scene_center.xyz) / view.ray_forward.w;
        float presence = 1.0 - smoothstep(fade_begin, fade_end, away);
        color *= 1.0 + pool_light * (1.0 - smoothstep(0.0, pool_end, away));
        if (presence > 0.0) color *= 1.0 - shadow_darkness * presence * (1.0 - floor_light(hit));
        open = presence;
    }
    color *= 1.0 - vignette * 0.5 * dot(at, at);
    vec3 shown = tone_map(color);
    // Half a step of 8-bit sRGB up or down, so that the gradient shows no bands: interleaved gradient noise (Jimenez
    // 2014).
    vec2 pixel = floor((at + 1.0) / vec2(view.background_top.w, view.background_bottom.w)) + 0.5;  // of the viewport
    float noise = fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
    out_color = vec4(shown + noise * (2.0 / 255.0) * sqrt(shown), open);
}
