#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "lighting.glsl"
#include "environment.glsl"
#include "field_color.glsl"
#include "surface_draw.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 smooth_normal;
layout(location = 2) in vec4 color_and_field;
layout(location = 3) in vec4 material;  // metallic, roughness, whether the field is known, share of the triangle's part
#ifdef TEXTURED
layout(location = 4) in vec2 uv;
layout(set = 2, binding = 0) uniform sampler2D picture;
#else
layout(location = 4) flat in vec3 other_color;  // of the other part
#endif
layout(location = 0) out vec4 out_color;

const vec3 unknown_color = vec3(0.25);
const float least_known = 0.999;        // less: a corner of the triangle has no value
const float line_strength = 0.85;       // of isolines over the colour
const float closest_lines_px = 2.5;     // nearer than this isolines are a tint, from twice as far on lines
const float least_roughness = 0.08;
const float sky_share = 0.75;           // of the environment's light; the sun shows shapes better
const float soft_spread = 3.2;          // texels of the shadow map that its edge is blurred over
const float pi = 3.14159265;

vec3 flat_normal() {
    vec3 normal = normalize(cross(dFdx(position), dFdy(position)));
    return dot(normal, view.eye.xyz - position) < 0.0 ? -normal : normal;
}

// How much of the pixel isolines cover. Within a triangle the field is linear: its derivatives are exact.
float isolines() {
    float level = color_and_field.w * draw.isolines_per_unit;
    float per_pixel = max(length(vec2(dFdx(level), dFdy(level))), 1e-12);
    float away_px = abs(fract(level + 0.5) - 0.5) / per_pixel;
    float line = clamp(draw.isoline_half_width_px + 0.5 - away_px, 0.0, 1.0);
    float spacing_px = 1.0 / per_pixel;
    float tint = clamp(2.0 * draw.isoline_half_width_px * per_pixel, 0.0, 0.5);
    return mix(tint, line, smoothstep(closest_lines_px, 2.0 * closest_lines_px, spacing_px));
}

vec3 surface_color() {
    bool known = material.z > least_known;
#ifdef TEXTURED
    vec3 base = color_and_field.rgb * texture(picture, uv).rgb;
#else
    // The border between two parts, sharp in each pixel.
    float own = clamp((material.w - 0.5) / max(fwidth(material.w), 1e-6) + 0.5, 0.0, 1.0);
    vec3 base = mix(other_color, color_and_field.rgb, own);
#endif
    if ((draw.flags & flag_shows_field) != 0u)
        base = known ? field_color((color_and_field.w - draw.field_low) * draw.colors_per_unit) : unknown_color;
    float line = draw.isolines_per_unit > 0.0 && known ? isolines() : 0.0;
    return mix(base, draw.isoline_color, line_strength * line);
}

void main() {
    vec3 to_eye = normalize(view.eye.xyz - position);
    vec3 normal = (draw.flags & flag_is_flat) != 0u ? flat_normal()
                                                    : normalize(gl_FrontFacing ? smooth_normal : -smooth_normal);
    vec3 base = surface_color();
    float metallic = material.x;
    float roughness = max(material.y, least_roughness);

    vec3 to_sun = view.sun_direction.xyz;
    vec3 half_way = normalize(to_eye + to_sun);
    float facing_sun = dot(normal, to_sun);
    float sun = max(facing_sun, 0.0);
    float facing_eye = max(dot(normal, to_eye), 1e-3);
    float facing_half = max(dot(normal, half_way), 0.0);

    // Microfacets: Trowbridge-Reitz (GGX), Smith's shadowing as Karis approximates it, Schlick's Fresnel.
    vec3 matte = base * (1.0 - metallic);
    vec3 mirror = mix(vec3(0.04), base, metallic);
    float alpha = roughness * roughness;
    float lobe = facing_half * facing_half * (alpha * alpha - 1.0) + 1.0;
    float density = alpha * alpha / (pi * lobe * lobe);
    float k = 0.5 * alpha;
    float visibility = 0.25 / ((sun * (1.0 - k) + k) * (facing_eye * (1.0 - k) + k));
    vec3 fresnel = mirror + (1.0 - mirror) * pow(1.0 - clamp(dot(to_eye, half_way), 0.0, 1.0), 5.0);

    float lit = facing_sun > 0.0 ? soft_sunlight(position, normal, soft_spread) : 0.0;
    vec3 sunlit = (matte * inverse_pi + fresnel * (density * visibility)) * (sun * lit) * view.sun_color.rgb;
    vec3 around = sky_share * matte * diffuse_environment(normal);
    around += reflected_share(mirror, roughness, facing_eye) *
              mirrored_environment(reflect(-to_eye, normal), roughness);
    out_color = shown(sunlit, around);
}
