// SPDX-License-Identifier: MIT
// What every shader of a pass knows: where it is seen from and what lights it. Mirrors ViewUniforms in
// renderer/src/view_uniforms.h. With STEREO defined there are two, one an eye.
#ifdef STEREO
#extension GL_EXT_multiview : require
#endif

const int lamp_count = 3;  // mirrors renderer/src/environment.h

struct View {
    mat4 clip_from_world;    // depth 1 near, 0 infinitely far
    mat4 shadow_from_world;  // the sun's view: x, y in -1..1, depth 0 near
    vec4 eye;                // xyz: metres; w: metres a pixel covers, at distance 1 (perspective) or anywhere (sun)
    vec4 ray_right;          // through the picture: forward + x right + y up, x, y in -1..1; w: ground height
    vec4 ray_up;             // w: 1 = ground, 0 = none
    vec4 ray_forward;        // w: radius of the scene, metres
    vec4 sun_direction;      // unit, towards the sun; w: metres a texel of the shadow map covers
    vec4 sun_color;          // w: 1 / edge of the shadow map, texels; 0 = no shadows
    vec4 sky_color;          // w: exposure
    vec4 bounce_color;       // w: 1 = perspective, 0 = the sun's parallel view
    vec4 background_top;     // w: 2 / width of the picture, pixels
    vec4 background_bottom;  // w: 2 / height of the picture, pixels
    vec4 scene_center;       // w: depth of the shadow map, metres
    vec4 turn;               // x: of sampling patterns, in turns, other in each frame of a picture that is refined
    vec4 irradiance[9];      // of the environment over pi, by spherical harmonics
    vec4 lamp_axis[lamp_count];   // soft lights of the environment; w: sharpness
    vec4 lamp_color[lamp_count];
};

#ifdef STEREO
layout(set = 0, binding = 0, std140) uniform Views { View eyes[2]; } views;
#define view views.eyes[gl_ViewIndex]
#else
layout(set = 0, binding = 0, std140) uniform Views { View eye; } views;
#define view views.eye
#endif
