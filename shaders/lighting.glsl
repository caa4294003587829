// SPDX-License-Identifier: MIT
// Sun with soft shadows, what is left of the environment where others stand in its way, tone mapping.

layout(set = 0, binding = 1) uniform sampler2DShadow shadow_map;

const float inverse_pi = 0.3183;
const float golden_angle = 2.39996323;
const float shadow_spread = 1.6;  // texels between the taps of the shadow's filter

// Where to look in the shadow map. Points are moved off their own surface by the texels the filter reaches over.
vec3 shadow_place(vec3 position, vec3 normal, float spread) {
    vec3 moved = position + normal * (view.sun_direction.w * (1.0 + spread));
    vec4 clip = view.shadow_from_world * vec4(moved, 1.0);
    return vec3(clip.xy * 0.5 + 0.5, clamp(clip.z, 0.0, 1.0) - 0.0005);
}

// Share of the sun that reaches a point; `spread` in texels between the taps.
float sunlight(vec3 position, vec3 normal, float spread) {
    if (view.sun_color.w == 0.0) return 1.0;
    vec3 at = shadow_place(position, normal, spread);
    float reach = spread * view.sun_color.w;
    float lit = texture(shadow_map, at + vec3(-0.94 * reach, -0.40 * reach, 0.0));
    lit += texture(shadow_map, at + vec3(0.95 * reach, -0.77 * reach, 0.0));
    lit += texture(shadow_map, at + vec3(-0.09 * reach, 0.93 * reach, 0.0));
    lit += texture(shadow_map, at + vec3(0.34 * reach, 0.29 * reach, 0.0));
    return 0.25 * lit;
}

// The same with an edge as soft as `spread` texels, for smooth surfaces: taps on Vogel's spiral.
float soft_sunlight(vec3 position, vec3 normal, float spread) {
    if (view.sun_color.w == 0.0) return 1.0;
    const int taps = 12;
    vec3 at = shadow_place(position, normal, spread);
    float lit = 0.0;
    for (int i = 0; i < taps; ++i) {
        float angle = golden_angle * float(i) + 6.2831853 * view.turn.x;
        float reach = spread * view.sun_color.w * sqrt((float(i) + 0.5) / float(taps));
        lit += texture(shadow_map, at + vec3(reach * cos(angle), reach * sin(angle), 0.0));
    }
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
