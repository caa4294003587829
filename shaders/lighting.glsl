// SPDX-License-Identifier: MIT
// Sun with soft shadows, what is left of the environment where others stand in its way, tone mapping.

layout(set = 0, binding = 1) uniform sampler2DShadow shadow_map;
layout(set = 0, binding = 2) uniform sampler2D shadow_depths;

const float inverse_pi = 0.3183;
const float golden_angle = 2.39996323;
const float shadow_spread = 1.6;  // texels between the taps of the shadow's filter

// Where to look in the shadow map. Points are moved off their own surface by the texels the filter reaches over.
vec3 shadow_place(vec3 position, vec3 normal, float spread) {
    vec3 moved = position + normal * (view.sun_direction.w * (1.0 + spread));
    vec4 clip = view.shadow_from_world * vec4(moved, 1.0);
    return vec3(clip.xy * 0.5 + 0.5, clamp(clip.z, 0.0, 1.0) - 0.0005);
}

const vec2 near_taps[] = {vec2(-0.94, -0.40), vec2(0.95, -0.77), vec2(-0.09, 0.93), vec2(0.34, 0.29)};
const int far_taps = 8;
const float lamp_tangent = 0.1;  // of half the angle that the lamp seems to have from a curve

// Vogel's: `count` places spread evenly over a disc of radius 1.
vec2 spiral(int i, int count) {
    float angle = golden_angle * float(i) + 6.2831853 * view.turn.x;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(angle), sin(angle));
}

// How much of the lamp stands behind what shades a place, `gap` before it in the map's depth: a strand covers little of
// it from far away, or else its shadow would be a dark fleck on another one. From where half is covered on, so that
// this begins with nothing at a shadow's edge. Only what is nearer to the lamp than half way counts: never the curve
// itself.
float covered(vec3 at, float gap) {
    mat3 rows = transpose(mat3(view.shadow_from_world));
    vec2 reach = lamp_tangent * gap * view.scene_center.w * 0.5 * vec2(length(rows[0]), length(rows[1]));
    float open = 0.0;
    for (int i = 0; i < far_taps; ++i)
        open += texture(shadow_map, at + vec3(reach * spiral(i, far_taps), -0.5 * gap));
    return clamp(1.0 - 2.0 * open / float(far_taps), 0.0, 1.0);
}

// Share of the sun that reaches a point of a curve; `spread` in texels between the taps.
float sunlight(vec3 position, vec3 normal, float spread) {
    if (view.sun_color.w == 0.0) return 1.0;
    vec3 at = shadow_place(position, normal, spread);
    float reach = spread * view.sun_color.w;
    float lit = 0.0;
    for (int i = 0; i < near_taps.length(); ++i) lit += texture(shadow_map, at + vec3(reach * near_taps[i], 0.0));
    lit /= float(near_taps.length());
    if (lit == 1.0) return lit;
    float gap = 0.0, blocked = 0.0;
    for (int i = 0; i < near_taps.length(); ++i) {
        float before = at.z - texture(shadow_depths, at.xy + reach * near_taps[i]).x;
        gap += max(before, 0.0);
        blocked += float(before > 0.0);
    }
    return blocked == 0.0 ? lit : 1.0 - (1.0 - lit) * covered(at, gap / blocked);
}

// The same of a surface, with an edge as soft as `spread` texels, for smooth surfaces: taps on Vogel's spiral.
float soft_sunlight(vec3 position, vec3 normal, float spread) {
    if (view.sun_color.w == 0.0) return 1.0;
    const int taps = 12;
    vec3 at = shadow_place(position, normal, spread);
    float lit = 0.0;
    for (int i = 0; i < taps; ++i)
        lit += texture(shadow_map, at + vec3(spread * view.sun_color.w * spiral(i, taps), 0.0));
    return lit / float(taps);
}

// Narkowicz, ACES Filmic Tone Mapping Curve (2016).
vec3 tone_map(vec3 color) {
    vec3 x = color * view.sky_color.w * 0.6;
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

// A pixel as the picture's last pass takes it: tone mapped, with the share of its light that comes from all around in
// alpha, where occlusion takes from it.
vec4 shown(vec3 sun, vec3 around) {
    const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
    float from_around = dot(around, luminance);
    return vec4(tone_map(sun + around), from_around / max(from_around + dot(sun, luminance), 1e-6));
}
