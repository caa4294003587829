#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "lighting.glsl"
#include "environment.glsl"

layout(constant_id = 0) const uint shape = 0;
const uint shape_ribbon = 0;

layout(push_constant) uniform Draw {
    layout(offset = 20) float gloss;
    layout(offset = 28) uint in_front;
} draw;

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 smooth_normal;
layout(location = 2) in vec3 albedo;
layout(location = 3) in vec3 crown;  // of ribbons: outwards on both sides
layout(location = 4) in vec3 ambient;  // light from all around
layout(location = 0) out vec4 out_color;

const float translucency = 0.22;  // of thin bands lit from behind
const float rim_strength = 0.30;
const float sky_share = 0.70;     // of the environment's light; the sun shows shapes better

void main() {
    vec3 normal = smooth_normal * (gl_FrontFacing ? 1.0 : -1.0);
    normal = normalize(shape == shape_ribbon ? normal + crown : normal);
    vec3 to_eye = normalize(view.eye.xyz - position);
    vec3 to_sun = view.sun_direction.xyz;

    float facing_sun = dot(normal, to_sun);
    float facing_eye = clamp(dot(normal, to_eye), 0.0, 1.0);
    vec3 half_way = normalize(to_eye + to_sun);
    float facing_half = clamp(dot(normal, half_way), 0.0, 1.0);

    // What is in front is seen through all else; no shadow of that falls on it.
    float lit = draw.in_front != 0u ? 1.0 : sunlight(position, facing_sun < 0.0 ? -normal : normal, shadow_spread);
    float diffuse = max(facing_sun, 0.0);
    if (shape == shape_ribbon) diffuse += translucency * max(-facing_sun, 0.0);

    float shininess = exp2(3.0 + 5.0 * draw.gloss);
    float fresnel = 0.04 + 0.96 * pow(1.0 - clamp(dot(to_eye, half_way), 0.0, 1.0), 5.0);
    float highlight = facing_sun > 0.0 ? fresnel * (shininess + 2.0) * 0.125 * pow(facing_half, shininess) : 0.0;

    // Without the lamps: fragments of curves are many.
    float rim = 1.0 - facing_eye;
    vec3 mirrored = (0.04 + rim_strength * rim * rim * rim * rim) * surroundings(reflect(-to_eye, normal).y, 0.5);
    vec3 sun = (albedo * (inverse_pi * diffuse) + draw.gloss * highlight) * lit * view.sun_color.rgb;
    vec3 around = sky_share * albedo * ambient + draw.gloss * mirrored;
    out_color = shown(sun, around);
    if (draw.in_front != 0u) out_color.a = 0.0;
}
