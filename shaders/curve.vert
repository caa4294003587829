#version 450
// SPDX-License-Identifier: MIT
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "packing.glsl"
#include "curve_frame.glsl"
#include "environment.glsl"

// Expands ribbons, tubes and lines from points. An instance is a chunk of a curve, up to 64 segments of it; a vertex is
// (ring, side), ring r lying at every stride-th point of the chunk. Where a ring lies and what plane it is in depends
// on its point and the two next to it only, so that rings of neighbouring chunks agree whatever their strides.

const uint chunk_bits = 28u;
const uint chunk_mask = (1u << chunk_bits) - 1u;

const uint part_body = 0;
const uint part_begin_cap = 1;
const uint part_end_cap = 2;

const float longest_miter = 2.0;   // in radii; sharper corners are cut off
// Half-width, also of ribbons seen edge-on: thinner ones would drop out between samples.
const float least_width_px = 0.5;
const float ribbon_crown = 0.35;   // how far a ribbon's shading normals lean outwards at its edges
const float half_pi = 1.5707963;
const float two_pi = 6.2831853;

layout(location = 0) in uint instance;  // chunk, and log2 of its stride above

layout(location = 0) out vec3 out_position;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out vec3 out_color;
layout(location = 3) out vec3 out_crown;
layout(location = 4) out vec3 out_ambient;

// Metres that a pixel covers at the point.
float pixel_size(vec3 position) {
    return view.eye.w * mix(1.0, length(position - view.eye.xyz), view.bounce_color.w);
}

// Light from all around at a ring's corner. It changes slowly: what lies between corners takes it from them. Of ribbons
// and lines the side that is seen.
vec3 ambient_on(vec3 normal, vec3 position) {
    bool from_behind = shape != shape_tube && dot(normal, view.eye.xyz - position) < 0.0;
    return diffuse_environment(from_behind ? -normal : normal);
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

    Way way = way_at(here, chunk);
    vec3 tangent = way.tangent;
    vec3 normal = normal_at(local, stride, chunk, tangent);
    vec3 binormal = cross(tangent, normal);
    vec3 center = way.position;

    float pixel = pixel_size(center);
    float radius = max(centers[here].w, least_width_px * pixel);
    vec3 across;
    vec3 shading;
    vec3 crown = vec3(0.0);
    float lift = 0.0;  // along the tangent, for caps
    if (shape == shape_tube) {
        float angle = two_pi * float(side) / float(draw.columns);
        across = cos(angle) * normal + sin(angle) * binormal;
        shading = across;
    } else if (shape == shape_ribbon) {
        float edge = side == 0u ? -1.0 : 1.0;
        across = edge * binormal;
        shading = normal;
        crown = ribbon_crown * across;
    } else {
        float edge = side == 0u ? -1.0 : 1.0;
        vec3 to_eye = view.eye.xyz - center;
        vec3 sideways = cross(tangent, to_eye);
        float size = length(sideways);
        across = size > 1e-6 * length(to_eye) ? edge * sideways / size : edge * binormal;
        shading = normalize(normalize(to_eye) + ribbon_crown * across);
        radius = draw.line_half_width_px * pixel;
    }

    // Joints: the ring lies in the plane that halves the turn, stretched so that both pieces keep their width.
    vec3 turn = way.on - way.into;
    float turn_size = length(turn);
    if (turn_size > 1e-4) {
        vec3 turn_unit = turn / turn_size;
        float cos_half = max(dot(way.on, tangent), 1.0 / longest_miter);
        across += turn_unit * (dot(across, turn_unit) * (1.0 / cos_half - 1.0));
    }

    vec3 widening = vec3(0.0);
    if (shape == shape_ribbon) {
        bool perspective = view.bounce_color.w > 0.5;
        vec3 to_viewer = perspective ? view.eye.xyz - center : view.sun_direction.xyz;
        vec3 sideways = cross(tangent, to_viewer);
        float size = length(sideways);
        if (size > 1e-6 * length(to_viewer)) {
            sideways /= size;
            float seen = radius * dot(across, sideways);
            float least = least_width_px * pixel * (side == 0u ? -1.0 : 1.0) *
                          (dot(binormal, sideways) < 0.0 ? -1.0 : 1.0);
            if (abs(seen) < abs(least)) widening = sideways * (least - seen);
        }
    }

    if (draw.part != part_body) {
        bool at_begin = draw.part == part_begin_cap;
        float to_pole = at_begin ? 1.0 - float(ring) / float(draw.cap_rings) : float(ring) / float(draw.cap_rings);
        float sign = at_begin ? -1.0 : 1.0;
        if (draw.round_cap != 0u) {
            float angle = half_pi * to_pole;
            shading = cos(angle) * shading + sign * sin(angle) * tangent;
            across *= cos(angle);
            lift = sign * sin(angle) * radius;
        } else {
            shading = sign * tangent;
            across *= 1.0 - to_pole;
        }
    }

    vec3 position = center + radius * across + widening + lift * tangent;
    out_position = position;
    out_normal = shading;
    out_crown = crown;
    out_ambient = ambient_on(shading, position);
    out_color = linear_color(unpackUnorm4x8(attributes[here].y).rgb);
    gl_Position = view.clip_from_world * vec4(position, 1.0);
}
