// SPDX-License-Identifier: MIT
// Light from everywhere but the sun, made of a scene's colours: no picture of a room is needed. Its formulas are those
// of shaders/environment.glsl, which names their sources.
#pragma once

#include <glm/glm.hpp>

#include "filigree_renderer/renderer.h"

namespace flg::render {

constexpr uint32_t lamp_count = 3;

// The end of ViewUniforms; mirrors shaders/view.glsl.
struct EnvironmentUniforms {
    glm::vec4 irradiance[9];
    glm::vec4 lamp_axis[lamp_count];
    glm::vec4 lamp_color[lamp_count];
};

// Takes some 50 us.
EnvironmentUniforms make_environment(const Scene& scene);

}  // namespace flg::render
