// SPDX-License-Identifier: MIT
#include "environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace flg::render {
namespace {

constexpr float horizon_share = 0.55f;  // of what the backdrop shows there
constexpr int directions = 512;         // that irradiance is summed over; harmonics of the second degree need few

// A soft box about the sun, a wide one across from it, and a strip to the side that shows edges.
struct Lamp {
    glm::vec3 axis;  // along the sun's way over the floor, up, and across
    float sharpness;
    glm::vec3 color;  // of the sky's
};
constexpr Lamp lamps[lamp_count] = {{{1.0f, 0.9f, 0.35f}, 9.0f, {1.25f, 1.15f, 1.0f}},
                                    {{-1.0f, 0.35f, -0.4f}, 5.0f, {0.22f, 0.27f, 0.34f}},
                                    {{-0.35f, 0.55f, 1.0f}, 14.0f, {0.9f, 0.88f, 0.86f}}};

float smoothstep(float low, float high, float x) {
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

glm::vec3 radiance(const Scene& scene, const EnvironmentUniforms& made, glm::vec3 direction) {
    glm::vec3 light =
        glm::mix(scene.bounce_color, horizon_share * scene.background_bottom, smoothstep(-0.1f, 0.05f, direction.y));
    light = glm::mix(light, scene.sky_color, smoothstep(0.0f, 0.35f, direction.y));
    for (uint32_t i = 0; i < lamp_count; ++i) {
        const float off = glm::dot(direction, glm::vec3(made.lamp_axis[i])) - 1.0f;
        light += glm::vec3(made.lamp_color[i]) * std::exp(made.lamp_axis[i].w * off);
    }
    return light;
}

}  // namespace

EnvironmentUniforms make_environment(const Scene& scene) {
    EnvironmentUniforms made{};
    const glm::vec3 sun = scene.sun_direction;
    const float level = std::hypot(sun.x, sun.z);
    const glm::vec3 along = level > 1e-6f ? glm::vec3(sun.x / level, 0, sun.z / level) : glm::vec3(1, 0, 0);
    const glm::vec3 across(-along.z, 0, along.x);
    for (uint32_t i = 0; i < lamp_count; ++i) {
        const Lamp& lamp = lamps[i];
        const glm::vec3 axis = lamp.axis.x * along + glm::vec3(0, lamp.axis.y, 0) + lamp.axis.z * across;
        made.lamp_axis[i] = glm::vec4(glm::normalize(axis), lamp.sharpness);
        made.lamp_color[i] = glm::vec4(lamp.color * scene.sky_color, 0.0f);
    }
    constexpr float pi = std::numbers::pi_v<float>, golden_angle = 2.39996323f;
    for (int i = 0; i < directions; ++i) {
        const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / directions;
        const float flat = std::sqrt(1.0f - y * y), angle = golden_angle * static_cast<float>(i);
        const glm::vec3 n(flat * std::cos(angle), y, flat * std::sin(angle));
        // Harmonics without their constants, which come in squared, times what a matte surface leaves of their degree.
        const float harmonics[9] = {
            1.0f, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3 * n.z * n.z - 1, n.x * n.z, n.x * n.x - n.y * n.y};
        constexpr float squares[9] = {0.0795775f, 0.2387324f, 0.2387324f, 0.2387324f, 1.1936621f,
                                      1.1936621f, 0.0994718f, 1.1936621f, 0.2984155f};
        const glm::vec3 light = radiance(scene, made, n) * (4.0f * pi / directions);
        for (int k = 0; k < 9; ++k) {
            const float left = k == 0 ? 1.0f : k < 4 ? 2.0f / 3.0f : 0.25f;
            made.irradiance[k] += glm::vec4(light * (harmonics[k] * squares[k] * left), 0.0f);
        }
    }
    return made;
}

}  // namespace flg::render
