#version 450
// SPDX-License-Identifier: MIT
// How much of what is around each second pixel, each way, is open: Scalable Ambient Obscurance (McGuire, Mara and
// Luebke, 2012), from the depths of the picture. Departures: the floor counts, though it has no depth; no mip levels;
// the spiral is turned by another angle in each pixel of a square, of which finish.frag takes the mean, in place of a
// blur.
#extension GL_GOOGLE_include_directive : require
#include "view.glsl"
#include "picture_place.glsl"

layout(location = 0) out vec2 out_open_and_depth;

const int taps = 10;
const float step_rad = 6.2831853 * 0.3;  // of the spiral, from tap to tap
const float reach_of_scene = 0.18;    // radii: how far away something may be to be in the way
const float reach_of_picture = 0.13;  // heights
const float floor_reach = 2.0;         // radii of the scene: how far from it the floor is looked at
const float strength = 2.6;
const float least_rise = 0.02;  // of a tap over the tangent plane, in reaches: less is curvature and rounding

vec3 nearer_step(Place left, Place here, Place right) {
    vec3 to_right = right.position - here.position, from_left = here.position - left.position;
    bool takes_right = right.distance > 0.0 && (left.distance == 0.0 || abs(right.distance - here.distance) <
                                                                            abs(left.distance - here.distance));
    return takes_right ? to_right : from_left;
}

vec3 normal_at(ivec2 pixel, Place here) {
    if (here.depth == 0.0) return vec3(0.0, 1.0, 0.0);
    vec3 across = nearer_step(place_at(pixel - ivec2(1, 0)), here, place_at(pixel + ivec2(1, 0)));
    vec3 down = nearer_step(place_at(pixel - ivec2(0, 1)), here, place_at(pixel + ivec2(0, 1)));
    vec3 normal = normalize(cross(down, across));
    return dot(normal, view.eye.xyz - here.position) < 0.0 ? -normal : normal;
}

void main() {
    ivec2 half_pixel = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(2 * half_pixel, draw.size - 1);
    Place here = place_at(pixel);
    vec3 normal = normal_at(pixel, here);
    float pixel_m = view.eye.w * here.distance;
    float reach = min(reach_of_scene * view.ray_forward.w, reach_of_picture * float(draw.size.y) * pixel_m);
    float reach_px = reach / pixel_m;
    ivec2 in_square = half_pixel % square;
    float turn = 6.2831853 * (float(in_square.x + square * in_square.y) / float(square * square) + view.turn.x);
    vec2 direction = vec2(cos(turn), sin(turn));
    const mat2 step = mat2(cos(step_rad), sin(step_rad), -sin(step_rad), cos(step_rad));
    float per_reach_square = 1.0 / (reach * reach), hidden = 0.0;
    for (int i = 0; i < taps; ++i) {
        float along = (float(i) + 0.5) / float(taps);
        ivec2 at = pixel + ivec2(round(reach_px * along * direction));
        direction = step * direction;
        Place other = place_at(clamp(at, ivec2(0), draw.size - 1));
        vec3 away = other.position - here.position;
        float share = dot(away, away) * per_reach_square;
        float near = other.distance > 0.0 ? max(1.0 - share, 0.0) : 0.0;
        float rise = max(dot(away, normal) / reach - least_rise, 0.0);
        hidden += near * near * near * rise * inversesqrt(share + 1e-4);
    }
    bool far = here.depth == 0.0 && length(here.position - view.scene_center.xyz) > floor_reach * view.ray_forward.w;
    bool open = far || here.distance == 0.0;
    out_open_and_depth = vec2(open ? 1.0 : clamp(1.0 - strength * hidden / float(taps), 0.0, 1.0), here.depth);
}
