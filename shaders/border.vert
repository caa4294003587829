#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "packing.glsl"
#include "surface_draw.glsl"

// An edge as a line of a width in pixels that faces the camera: a strip with a tip at each end, so that lines join
// whatever their angle. It is lifted towards the camera, which doesn't move it in the picture, so that the surface
// doesn't hide half of it.

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in vec4 color;
layout(location = 3) in float half_width_px;

layout(location = 0) out vec3 out_color;

const float lift = 3.0;  // half-widths: clear of surfaces seen at up to 70 degrees

void main() {
    // Tip, two corners, two corners, tip: four triangles in a row.
    int corner = gl_VertexIndex / 3 + gl_VertexIndex % 3;
    vec3 end = placed(corner < 3 ? from : to);
    vec3 along = placed_direction(normalize(to - from));
    vec3 to_eye = view.eye.xyz - end;
    float away = length(to_eye);
    vec3 sideways = cross(along, to_eye / away);
    float size = length(sideways);
    vec3 side = size > 1e-6 ? sideways / size : vec3(0.0);
    float half_width = half_width_px * view.eye.w * away;
    vec3 position = end + to_eye / away * (lift * half_width);
    if (corner == 0) position -= half_width * along;
    else if (corner == 5) position += half_width * along;
    else position += half_width * ((corner & 1) == 0 ? side : -side);
    out_color = linear_color(color.rgb);
    gl_Position = view.clip_from_world * vec4(position, 1.0);
}
