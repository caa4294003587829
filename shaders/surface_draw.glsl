// SPDX-License-Identifier: MIT
// What differs from surface to surface. Mirrors SurfacePush in renderer/src/surface_pipelines.h.

layout(push_constant) uniform Draw {
    vec3 isoline_color;
    float isoline_half_width_px;
    float field_low;
    float colors_per_unit;
    float isolines_per_unit;
    uint flags;
    vec4 turn;         // Placement: a unit quaternion,
    vec4 at;           // metres; w: scale
    uint first_joint;  // of surfaces that follow joints
} draw;

const uint flag_shows_field = 1u;
const uint flag_is_flat = 2u;

vec3 placed_direction(vec3 own) {
    vec3 twice = 2.0 * cross(draw.turn.xyz, own);
    return own + draw.turn.w * twice + cross(draw.turn.xyz, twice);
}

vec3 placed(vec3 own) {
    return draw.at.xyz + draw.at.w * placed_direction(own);
}
