// SPDX-License-Identifier: MIT
// What differs from surface to surface. Mirrors SurfacePush in renderer/src/surface_pipelines.h.

layout(push_constant) uniform Draw {
    vec3 isoline_color;
    float isoline_half_width_px;
    float field_low;
    float colors_per_unit;
    float isolines_per_unit;
    uint flags;
} draw;

const uint flag_shows_field = 1u;
const uint flag_is_flat = 2u;
