// SPDX-License-Identifier: MIT
// What the shaders of a pass know of camera and light; mirrors shaders/view.glsl.
#pragma once

#include <glm/glm.hpp>

#include "environment.h"
#include "filigree_renderer/renderer.h"

namespace flg::render {

struct ViewUniforms {
    glm::mat4 clip_from_world;
    glm::mat4 shadow_from_world;
    glm::vec4 eye;
    glm::vec4 ray_right;
    glm::vec4 ray_up;
    glm::vec4 ray_forward;
    glm::vec4 sun_direction;
    glm::vec4 sun_color;
    glm::vec4 sky_color;
    glm::vec4 bounce_color;
    glm::vec4 background_top;
    glm::vec4 background_bottom;
    glm::vec4 scene_center;
    glm::vec4 turn;
    EnvironmentUniforms environment;
};

// The sun's parallel view of a box, to be the projection of a shadow map of `shadow_size` pixels.
ViewUniforms sun_view(const Scene& scene, const Box& box, uint32_t shadow_size);

// The camera's view; throws Error for a camera that sees nothing. shadow_size 0: no shadows. `environment` is left
// zero.
ViewUniforms camera_view(const Camera& camera, const Scene& scene, const Box& box, uint32_t width, uint32_t height,
                         uint32_t shadow_size);

// Moves the picture by a part of a pixel and turns the shaders' sampling patterns, by the how-maniest of the frames it
// is that a picture is the mean of.
void vary(ViewUniforms& view, uint32_t frame);

}  // namespace flg::render
