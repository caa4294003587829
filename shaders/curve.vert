#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"

// Expands ribbons, tubes and lines from points. An instance is a chunk of a curve, up to 64 segments of it; a vertex is
// (ring, side), ring r lying at every stride-th point of the chunk. A ring depends on its point and the two next to it
// only, so that rings of neighbouring chunks agree whatever their strides.

layout(constant_id = 0) const uint shape = 0;
const uint shape_ribbon = 0;
const uint shape_tube = 1;
const uint shape_line = 2;

const uint flag_closed = 1u << 16;
const uint segment_mask = 0xffffu;
const uint chunk_bits = 28u;
const uint chunk_mask = (1u << chunk_bits) - 1u;

const uint part_body = 0;
const uint part_begin_cap = 1;
const uint part_end_cap = 2;

const float longest_miter = 2.0;   // in radii; sharper corners are cut off
const float least_width_px = 0.5;  // half-width, also of ribbons seen edge-on: thinner ones would drop out between samples
const float ribbon_crown = 0.35;   // how far a ribbon's shading normals lean outwards at its edges
const float half_pi = 1.5707963;
const float two_pi = 6.2831853;

layout(push_constant) uniform Draw {
    uint columns;      // vertices a ring
    uint part;
    uint cap_rings;    // rings of a cap, minus one
    uint round_cap;
    float line_half_width_px;
    float gloss;
} draw;

layout(set = 1, binding = 0, std430) readonly buffer Centers { vec4 centers[]; };  // position, radius
layout(set = 1, binding = 1, std430) readonly buffer Attributes { uvec2 attributes[]; };  // normal (octahedral), sRGB
layout(set = 1, binding = 2, std430) readonly buffer Chunks { uvec4 chunks[]; };  // first point, segments and flags,
                                                                                  // first and last point of the curve
layout(location = 0) in uint instance;  // chunk, and log2 of its stride above

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec3 out_color;

vec3 unpack_normal(uint bits) {
    vec2 p = unpackSnorm2x16(bits);
    vec3 n = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (n.z < 0.0) n.xy = (1.0 - abs(n.yx)) * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(n.xy, vec2(0.0)));
    return normalize(n);
}

vec3 unpack_color(uint bits) {
    vec3 c = unpackUnorm4x8(bits).rgb;
    return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);  // sRGB to linear within 0.2 %
}

// Metres that a pixel covers at the point.
float pixel_size(vec3 position) {
    return view.eye.w * mix(1.0, length(position - view.eye.xyz), view.bounce_color.w);
}

void main() {
    uvec4 chunk = chunks[instance & chunk_mask];
    uint stride = 1u << (instance >> chunk_bits);
    uint segments = chunk.y & segment_mask;
    uint ring = gl_VertexIndex / draw.columns;
    uint side = gl_VertexIndex - ring * draw.columns;

    uint local = min(ring * stride, segments);
    if (draw.part == part_begin_cap) local = 0;
    if (draw.part == part_end_cap) local = segments;
    uint here = chunk.x + local;

    bool closed = (chunk.y & flag_closed) != 0u;
    bool at_first = here == chunk.z;
    bool at_last = here == chunk.w;
    uint before = at_first ? (closed ? chunk.w - 1u : here) : here - 1u;
    uint after = at_last ? (closed ? chunk.z + 1u : here) : here + 1u;

    vec4 center = centers[here];
    vec3 from = center.xyz - centers[before].xyz;
    vec3 to = centers[after].xyz - center.xyz;
    // No two points in a row are equal: only at the ends is one of the two zero.
    vec3 direction_in = before == here ? normalize(to) : normalize(from);
    vec3 direction_out = after == here ? direction_in : normalize(to);
    vec3 sum = direction_in + direction_out;
    uvec2 packed_look = attributes[here];
    vec3 stored_normal = unpack_normal(packed_look.x);
    vec3 tangent = dot(sum, sum) > 1e-6 ? normalize(sum) : direction_in;  // a full turn back keeps the way in
    vec3 normal = stored_normal - tangent * dot(stored_normal, tangent);
    normal = dot(normal, normal) > 1e-8 ? normalize(normal)
                                        : normalize(cross(tangent, abs(tangent.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
    vec3 binormal = cross(tangent, normal);

    float pixel = pixel_size(center.xyz);
    float radius = max(center.w, least_width_px * pixel);
    vec3 across;
    vec3 shading;
    float lift = 0.0;  // along the tangent, for caps
    if (shape == shape_tube) {
        float angle = two_pi * float(side) / float(draw.columns);
        across = cos(angle) * normal + sin(angle) * binormal;
        shading = across;
    } else if (shape == shape_ribbon) {
        float edge = side == 0u ? -1.0 : 1.0;
        across = edge * binormal;
        shading = normalize(normal + ribbon_crown * across);
    } else {
        float edge = side == 0u ? -1.0 : 1.0;
        vec3 to_eye = view.eye.xyz - center.xyz;
        vec3 sideways = cross(tangent, to_eye);
        float size = length(sideways);
        across = size > 1e-6 * length(to_eye) ? edge * sideways / size : edge * binormal;
        shading = normalize(normalize(to_eye) + ribbon_crown * across);
        radius = draw.line_half_width_px * pixel;
    }

    // Joints: the ring lies in the plane that halves the turn, stretched so that both pieces keep their width.
    vec3 turn = direction_out - direction_in;
    float turn_size = length(turn);
    if (turn_size > 1e-4) {
        vec3 turn_unit = turn / turn_size;
        float cos_half = max(dot(direction_out, tangent), 1.0 / longest_miter);
        across += turn_unit * (dot(across, turn_unit) * (1.0 / cos_half - 1.0));
    }

    vec3 widening = vec3(0.0);
    if (shape == shape_ribbon) {
        bool perspective = view.bounce_color.w > 0.5;
        vec3 to_viewer = perspective ? view.eye.xyz - center.xyz : view.sun_direction.xyz;
        vec3 sideways = cross(tangent, to_viewer);
        float size = length(sideways);
        if (size > 1e-6 * length(to_viewer)) {
            sideways /= size;
            float seen = radius * dot(across, sideways);
            float least = least_width_px * pixel * (side == 0u ? -1.0 : 1.0) * (dot(binormal, sideways) < 0.0 ? -1.0 : 1.0);
            if (abs(seen) < abs(least)) widening = sideways * (least - seen);
        }
    }

    if (draw.part != part_body) {
        bool at_begin = draw.part == part_begin_cap;
        float way = at_begin ? 1.0 - float(ring) / float(draw.cap_rings) : float(ring) / float(draw.cap_rings);
        float sign = at_begin ? -1.0 : 1.0;
        if (draw.round_cap != 0u) {
            float angle = half_pi * way;
            shading = cos(angle) * shading + sign * sin(angle) * tangent;
            across *= cos(angle);
            lift = sign * sin(angle) * radius;
        } else {
            shading = sign * tangent;
            across *= 1.0 - way;
        }
    }

    vec3 position = center.xyz + radius * across + widening + lift * tangent;
    out_position = position;
    out_normal = shading;
    out_color = unpack_color(packed_look.y);
    gl_Position = view.clip_from_world * vec4(position, 1.0);
}
