// SPDX-License-Identifier: MIT
// The points of curves where they are drawn, and the frame of a ring.
//
// Without a magnitude offset frames come with the points. With one, each point stands at position + offset *
// displacement, and its frame follows from where its neighbours then stand: from the chunk's first ring on, over the
// rings drawn. Two chunks meet in a ring that each draws for itself, so that their frames need not agree there: tubes
// are round, ribbons have two sides.

layout(constant_id = 0) const uint shape = 0;
const uint shape_ribbon = 0;
const uint shape_tube = 1;
const uint shape_line = 2;
layout(constant_id = 1) const bool displaced = false;

layout(push_constant) uniform Draw {
    uint columns;      // vertices a ring
    uint part;
    uint cap_rings;    // rings of a cap, minus one
    uint round_cap;
    float line_half_width_px;
    float gloss;
    float magnitude_offset;
    uint in_front;
} draw;

layout(set = 1, binding = 0, std430) readonly buffer Centers { vec4 centers[]; };  // position, radius
layout(set = 1, binding = 1, std430) readonly buffer Attributes { uvec2 attributes[]; };  // normal (octahedral), sRGB
layout(set = 1, binding = 2, std430) readonly buffer Chunks { uvec4 chunks[]; };  // first point, segments and flags,
                                                                                  // first and last point of the curve
layout(set = 1, binding = 3, std430) readonly buffer Displacements { uvec4 displacements[]; };  // three floats, and the
                                                                                               // normal as given

const uint flag_closed = 1u << 16;
const uint segment_mask = 0xffffu;
const float least_said = 0.1;  // sine of a given normal's angle to the tangent below which it says too little

vec3 unpack_normal(uint bits) {
    return octahedral_normal(unpackSnorm2x16(bits));
}

vec3 unit_or(vec3 v, vec3 otherwise) {
    return dot(v, v) > 0.0 ? normalize(v) : otherwise;
}

vec3 position_of(uint point) {
    vec3 position = centers[point].xyz;
    if (displaced) position += draw.magnitude_offset * uintBitsToFloat(displacements[point].xyz);
    return position;
}

struct Way {
    vec3 position;
    vec3 into, on, tangent;  // directions to the point, from it, and between the two
};

Way way_at(uint here, uvec4 chunk) {
    bool closed = (chunk.y & flag_closed) != 0u;
    uint before = here == chunk.z ? (closed ? chunk.w - 1u : here) : here - 1u;
    uint after = here == chunk.w ? (closed ? chunk.z + 1u : here) : here + 1u;
    vec3 position = position_of(here);
    // At the ends one of the two is zero; both only where a displacement puts three points in one place.
    vec3 from = position - position_of(before), to = position_of(after) - position;
    Way way;
    way.position = position;
    way.into = unit_or(from, unit_or(to, vec3(1, 0, 0)));
    way.on = unit_or(to, way.into);
    vec3 sum = way.into + way.on;
    way.tangent = dot(sum, sum) > 1e-6 ? normalize(sum) : way.into;  // a full turn back keeps the way in
    return way;
}

vec3 any_normal(vec3 tangent) {
    return normalize(cross(tangent, abs(tangent.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0)));
}

vec3 level(vec3 normal, vec3 tangent, vec3 otherwise, float least) {
    vec3 across = normal - tangent * dot(normal, tangent);
    return dot(across, across) > least * least ? normalize(across) : otherwise;
}

vec3 reflect_across(vec3 v, vec3 mirror_normal) {
    float square = dot(mirror_normal, mirror_normal);
    return square > 0.0 ? v - mirror_normal * (2.0 * dot(v, mirror_normal) / square) : v;
}

// By double reflection, as the host carries frames: curve_frames.cpp.
vec3 carry(vec3 normal, vec3 chord, vec3 tangent_from, vec3 tangent_to) {
    vec3 tangent_left = reflect_across(tangent_from, chord);
    vec3 next = reflect_across(reflect_across(normal, chord), tangent_to - tangent_left);
    return level(next, tangent_to, any_normal(tangent_to), 1e-4);
}

// Normal of the ring at the chunk's point `local`; rings lie at every stride-th point.
vec3 normal_at(uint local, uint stride, uvec4 chunk, vec3 tangent) {
    if (!displaced || shape == shape_line)
        return level(unpack_normal(attributes[chunk.x + local].x), tangent, any_normal(tangent), 1e-4);
    Way last = way_at(chunk.x, chunk);
    vec3 normal = level(unpack_normal(displacements[chunk.x].w), last.tangent, any_normal(last.tangent), 1e-4);
    for (uint at = 0u; at < local;) {
        at = min(at + stride, local);
        Way next = way_at(chunk.x + at, chunk);
        normal = carry(normal, next.position - last.position, last.tangent, next.tangent);
        if (shape == shape_ribbon) {
            vec3 given = level(unpack_normal(displacements[chunk.x + at].w), next.tangent, normal, least_said);
            normal = dot(given, normal) < 0.0 ? -given : given;
        }
        last = next;
    }
    return normal;
}
