// SPDX-License-Identifier: MIT
// Mirrors FinishPush in renderer/src/finish_pass.h. The finished picture's depths as places: what was drawn, and the
// floor where nothing was.

// Occlusion is looked for in another direction in each pixel of a square, of which the mean is taken. Where a pixel has
// one sample only, so that it may be quick, the square is small: the mean of frames makes up for it.
#ifdef MULTISAMPLED
layout(set = 1, binding = 0) uniform sampler2DMS depths;
const int square = 4;
#else
layout(set = 1, binding = 0) uniform sampler2D depths;
const int square = 2;
#endif

layout(push_constant) uniform Draw {
    ivec2 size;        // of the drawn picture, pixels; it lies in the corner of its image
    ivec2 out_corner;  // of where it is shown
    ivec2 out_size;
} draw;

struct Place {
    vec3 position;
    float depth;     // as drawn: 0 on the floor
    float distance;  // along the line of sight; 0: there is nothing
};

float depth_at(ivec2 pixel) {
    return texelFetch(depths, pixel, 0).x;
}

Place place_at(ivec2 pixel) {
    vec2 at = (vec2(pixel) + 0.5) / vec2(draw.size) * 2.0 - 1.0;
    vec3 ray = view.ray_forward.xyz + at.x * view.ray_right.xyz - at.y * view.ray_up.xyz;
    Place place;
    place.depth = depth_at(pixel);
    float above = view.eye.y - view.ray_right.w;
    bool is_floor = place.depth == 0.0, misses = is_floor && (ray.y >= 0.0 || above <= 0.0 || view.ray_up.w == 0.0);
    float numerator = is_floor ? above : view.clip_from_world[3][2];
    place.distance = misses ? 0.0 : numerator / (is_floor ? -ray.y : place.depth);
    place.position = view.eye.xyz + ray * place.distance;
    return place;
}
