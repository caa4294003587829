// SPDX-License-Identifier: MIT
#include "view_uniforms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vk.h"

namespace flg::render {
namespace {

constexpr float near_share = 0.002f;    // of the distance to the target; nearer things are cut away
constexpr float shadow_margin = 1.02f;  // so that no caster touches the edge of the map
constexpr float largest_angle_rad = 1.55f;
constexpr float min_field_rad = 1e-3f;
constexpr float min_radius_m = 1e-6f;  // of an empty scene

bool finite(glm::vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

glm::vec3 unit_sun(const Scene& scene) {
    const float length = glm::length(scene.sun_direction);
    if (!finite(scene.sun_direction) || !(length > 0.0f))
        fail("The scene's sun_direction must be finite and not zero.");
    return scene.sun_direction / length;
}

struct SunMap {
    glm::mat4 clip_from_world;
    float texel_m;
    float depth_m;
};

SunMap sun_map(glm::vec3 to_sun, const Box& box, uint32_t size) {
    const glm::vec3 center = box.empty() ? glm::vec3(0) : box.center();
    const glm::vec3 helper = std::abs(to_sun.y) < 0.99f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    const glm::vec3 right = glm::normalize(glm::cross(helper, to_sun));
    const glm::vec3 up = glm::cross(to_sun, right);
    const glm::vec3 half = box.empty() ? glm::vec3(0) : 0.5f * (box.max - box.min);
    const auto extent = [&](glm::vec3 axis) {
        return std::max(shadow_margin * glm::dot(glm::abs(axis), half), min_radius_m);
    };
    const float x = extent(right), y = extent(up), z = extent(to_sun);
    // Rows: right, up, and from the sun (depth 0) away (depth 1).
    const glm::vec4 rows[3] = {glm::vec4(right, -glm::dot(right, center)) / x, glm::vec4(up, -glm::dot(up, center)) / y,
                               glm::vec4(-to_sun, glm::dot(to_sun, center)) / (2.0f * z) + glm::vec4(0, 0, 0, 0.5f)};
    SunMap map;
    map.clip_from_world = glm::transpose(glm::mat4(rows[0], rows[1], rows[2], glm::vec4(0, 0, 0, 1)));
    map.texel_m = 2.0f * std::max(x, y) / static_cast<float>(std::max(size, 1u));
    map.depth_m = 2.0f * z;
    return map;
}

// What the picture shows at distance 1 from the eye: half its size, and its middle off the line of sight.
struct Frustum {
    float half_width, half_height;
    float center_x, center_y;
};

Frustum frustum_of(const Camera& camera, uint32_t width, uint32_t height) {
    if (!camera.field) {
        if (!(camera.fov_y_rad > 0.0f && camera.fov_y_rad < 3.1f))
            fail("The camera's fov_y_rad is %g; it must be in 0 to 3.1.", camera.fov_y_rad);
        const float tan_y = std::tan(0.5f * camera.fov_y_rad);
        return {tan_y * static_cast<float>(width) / static_cast<float>(height), tan_y, 0.0f, 0.0f};
    }
    const FieldOfView& field = *camera.field;
    for (const float angle : {field.left, field.right, field.up, field.down})
        if (!(std::abs(angle) <= largest_angle_rad))
            fail("The camera's field has an angle of %g; each must be in -%g to %g.", angle, largest_angle_rad,
                 largest_angle_rad);
    if (!(field.right - field.left > min_field_rad && field.up - field.down > min_field_rad))
        fail("The camera's field is %g to %g wide and %g to %g high; it must not be empty.", field.left, field.right,
             field.down, field.up);
    const float left = std::tan(field.left), right = std::tan(field.right);
    const float down = std::tan(field.down), up = std::tan(field.up);
    return {0.5f * (right - left), 0.5f * (up - down), 0.5f * (left + right), 0.5f * (down + up)};
}

float ground_height(const Scene& scene, const Box& box) {
    return scene.ground_height.value_or(box.empty() ? 0.0f : box.min.y);
}

// The box down to the floor, which has to lie within the shadow map.
Box down_to_ground(const Scene& scene, Box box) {
    if (scene.ground && !box.empty()) box.min.y = std::min(box.min.y, ground_height(scene, box));
    return box;
}

}  // namespace

ViewUniforms sun_view(const Scene& scene, const Box& box, uint32_t shadow_size) {
    const glm::vec3 to_sun = unit_sun(scene);
    const SunMap map = sun_map(to_sun, down_to_ground(scene, box), shadow_size);
    ViewUniforms view{};
    view.clip_from_world = map.clip_from_world;
    view.eye =
        glm::vec4(to_sun * (2.0f * box.diagonal() + 1.0f) + (box.empty() ? glm::vec3(0) : box.center()), map.texel_m);
    view.sun_direction = glm::vec4(to_sun, 0.0f);
    view.bounce_color.w = 0.0f;
    return view;
}

ViewUniforms camera_view(const Camera& camera, const Scene& scene, const Box& box, uint32_t width, uint32_t height,
                         uint32_t shadow_size) {
    const glm::vec3 arm = camera.target - camera.eye;
    const float distance = glm::length(arm);
    if (!finite(camera.eye) || !finite(camera.target) || !finite(camera.up) || !(distance > 0.0f))
        fail("The camera's eye and target must be finite and apart.");
    if (!(scene.exposure > 0.0f)) fail("The scene's exposure is %g; it must be greater than 0.", scene.exposure);
    const glm::vec3 forward = arm / distance;
    glm::vec3 right = glm::cross(forward, camera.up);
    if (glm::length(right) < 1e-4f * glm::length(camera.up) || glm::length(camera.up) == 0.0f)
        right = glm::cross(forward, std::abs(forward.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
    right = glm::normalize(right);
    const glm::vec3 up = glm::cross(right, forward);

    const Frustum frustum = frustum_of(camera, width, height);
    const float tan_x = frustum.half_width, tan_y = frustum.half_height;
    const glm::vec3 middle = forward + frustum.center_x * right + frustum.center_y * up;
    const glm::vec3 across = right - frustum.center_x * forward, upwards = up - frustum.center_y * forward;
    // Reversed depth with the far plane at infinity: near -> 1, far -> 0. Vulkan's y points down.
    const glm::vec4 rows[4] = {glm::vec4(across, -glm::dot(across, camera.eye)) / tan_x,
                               glm::vec4(-upwards, glm::dot(upwards, camera.eye)) / tan_y,
                               glm::vec4(0, 0, 0, near_share * distance),
                               glm::vec4(forward, -glm::dot(forward, camera.eye))};
    const glm::vec3 to_sun = unit_sun(scene);
    const SunMap map = sun_map(to_sun, down_to_ground(scene, box), shadow_size);
    ViewUniforms view{};
    view.clip_from_world = glm::transpose(glm::mat4(rows[0], rows[1], rows[2], rows[3]));
    view.shadow_from_world = map.clip_from_world;
    view.eye = glm::vec4(camera.eye, 2.0f * tan_y / static_cast<float>(height));
    view.ray_right = glm::vec4(right * tan_x, ground_height(scene, box));
    view.ray_up = glm::vec4(up * tan_y, scene.ground && !box.empty() ? 1.0f : 0.0f);
    view.ray_forward = glm::vec4(middle, std::max(0.5f * box.diagonal(), min_radius_m));
    view.sun_direction = glm::vec4(to_sun, map.texel_m);
    view.sun_color = glm::vec4(scene.sun_color, shadow_size ? 1.0f / static_cast<float>(shadow_size) : 0.0f);
    view.sky_color = glm::vec4(scene.sky_color, scene.exposure);
    view.bounce_color = glm::vec4(scene.bounce_color, 1.0f);
    view.background_top = glm::vec4(scene.background_top, 2.0f / static_cast<float>(width));
    view.background_bottom = glm::vec4(scene.background_bottom, 2.0f / static_cast<float>(height));
    view.scene_center = glm::vec4(box.empty() ? glm::vec3(0) : box.center(), map.depth_m);
    return view;
}

void vary(ViewUniforms& view, uint32_t frame) {
    // Halton's points: even over the pixel however many there are.
    const auto radical_inverse = [](uint32_t i, uint32_t base) {
        float value = 0.0f, digit = 1.0f / static_cast<float>(base);
        for (; i > 0; i /= base, digit /= static_cast<float>(base)) value += digit * static_cast<float>(i % base);
        return value;
    };
    const glm::vec2 pixels(radical_inverse(frame, 2) - 0.5f, radical_inverse(frame, 3) - 0.5f);
    const glm::vec2 clip = pixels * glm::vec2(view.background_top.w, view.background_bottom.w);
    for (int column = 0; column < 4; ++column) {
        view.clip_from_world[column].x += clip.x * view.clip_from_world[column].w;
        view.clip_from_world[column].y += clip.y * view.clip_from_world[column].w;
    }
    constexpr float golden_turn = 0.6180340f;
    view.turn.x = std::fmod(golden_turn * static_cast<float>(frame), 1.0f);
}

}  // namespace flg::render
