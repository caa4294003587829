// SPDX-License-Identifier: MIT
// Mirrored by shaders/field_color.glsl.
#include <algorithm>
#include <cmath>

#include "filigree_renderer/surface_look.h"

namespace flg::render {
namespace {

// Ottosson, A perceptual color space for image processing (2020).
glm::vec3 linear_of_oklab(glm::vec3 lab) {
    const float l = lab.x + 0.3963377774f * lab.y + 0.2158037573f * lab.z;
    const float m = lab.x - 0.1055613458f * lab.y - 0.0638541728f * lab.z;
    const float s = lab.x - 0.0894841775f * lab.y - 1.2914855480f * lab.z;
    const glm::vec3 cone(l * l * l, m * m * m, s * s * s);
    return {4.0767416621f * cone.x - 3.3077115913f * cone.y + 0.2309699292f * cone.z,
            -1.2684380046f * cone.x + 2.6097574011f * cone.y - 0.3413193965f * cone.z,
            -0.0041960863f * cone.x - 0.7034186147f * cone.y + 1.7076147010f * cone.z};
}

}  // namespace

glm::vec3 field_color(float t) {
    const float at = std::clamp(t, 0.0f, 1.0f);
    const float lightness = std::lerp(0.38f, 0.93f, at);
    const float hue = std::lerp(5.10f, 1.78f, at);  // radians
    const float ends = 2.0f * at - 1.0f;
    const float chroma = std::lerp(0.095f, 0.145f, ends * ends);
    return glm::clamp(linear_of_oklab({lightness, chroma * std::cos(hue), chroma * std::sin(hue)}), 0.0f, 1.0f);
}

}  // namespace flg::render
