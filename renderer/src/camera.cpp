// SPDX-License-Identifier: MIT
#include "filigree_renderer/camera.h"

#include <algorithm>
#include <cmath>

#include "vk.h"

namespace flg::render {
namespace {

constexpr float frame_margin = 1.06f;
constexpr float min_pole_distance_rad = 0.02f;
constexpr float half_pi = 1.5707963f;

glm::vec3 usable_up(glm::vec3 forward) {
    return std::abs(forward.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
}

}  // namespace

void Box::add(const Box& other) {
    if (other.empty()) return;
    const bool was_empty = empty();
    min = was_empty ? other.min : glm::min(min, other.min);
    max = was_empty ? other.max : glm::max(max, other.max);
}

Camera frame_box(const Box& box, glm::vec3 direction, float aspect, float fov_y_rad) {
    Box seen = box;
    if (seen.empty()) seen = {glm::vec3(0), glm::vec3(0)};
    if (!(seen.diagonal() > 0.0f)) seen = {seen.min - 0.5f, seen.max + 0.5f};
    glm::vec3 corners[8];
    for (int corner = 0; corner < 8; ++corner)
        corners[corner] = {corner & 1 ? seen.max.x : seen.min.x, corner & 2 ? seen.max.y : seen.min.y,
                           corner & 4 ? seen.max.z : seen.min.z};
    return frame_points(corners, direction, aspect, frame_margin, fov_y_rad);
}

Camera frame_points(std::span<const glm::vec3> points, glm::vec3 direction, float aspect, float margin,
                    float fov_y_rad) {
    const float length = glm::length(direction);
    if (!(length > 0.0f) || std::isinf(length)) fail("The camera's direction must be finite and not zero.");
    if (!(aspect > 0.0f)) fail("The picture's aspect is %g; it must be greater than 0.", aspect);
    if (!(margin >= 1.0f)) fail("The picture's margin is %g; it must be at least 1.", margin);
    if (!(fov_y_rad > 0.0f && fov_y_rad < 3.1f))
        fail("The field of view is %g rad; it must be in 0 to 3.1.", fov_y_rad);
    if (points.empty()) fail("There are no points to frame.");
    Box box{points[0], points[0]};
    for (const glm::vec3& p : points) box.add({p, p});
    if (!(box.diagonal() > 0.0f)) return frame_box(box, direction, aspect, fov_y_rad);

    const glm::vec3 forward = direction / length;
    const glm::vec3 up = usable_up(forward);
    const glm::vec3 right = glm::normalize(glm::cross(forward, up));
    const glm::vec3 true_up = glm::cross(right, forward);
    const float tan_y = std::tan(0.5f * fov_y_rad) / margin;
    const float tan_x = tan_y * aspect;

    // Each point must lie within the four planes through the eye: how far back does it push the eye, and to which side?
    float left = -1e38f, other_x = -1e38f, low = -1e38f, high = -1e38f;
    for (const glm::vec3& point : points) {
        const glm::vec3 p = point - box.center();
        const float x = glm::dot(p, right), y = glm::dot(p, true_up), z = glm::dot(p, forward);
        left = std::max(left, -x / tan_x - z);
        other_x = std::max(other_x, x / tan_x - z);
        low = std::max(low, -y / tan_y - z);
        high = std::max(high, y / tan_y - z);
    }
    const float back = std::max(0.5f * (left + other_x), 0.5f * (low + high));
    const glm::vec3 shift = right * (0.5f * (other_x - left) * tan_x) + true_up * (0.5f * (high - low) * tan_y);
    Camera camera;
    camera.target = box.center() + shift;
    camera.eye = camera.target - forward * back;
    camera.up = up;
    camera.fov_y_rad = fov_y_rad;
    return camera;
}

void Orbit::turn(float yaw_rad, float pitch_rad) {
    const glm::vec3 arm = camera.eye - camera.target;
    const float distance = glm::length(arm);
    float yaw = std::atan2(arm.x, arm.z) + yaw_rad;
    float pitch = std::asin(std::clamp(arm.y / distance, -1.0f, 1.0f)) + pitch_rad;
    pitch = std::clamp(pitch, -half_pi + min_pole_distance_rad, half_pi - min_pole_distance_rad);
    camera.eye = camera.target + distance * glm::vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                                                      std::cos(yaw) * std::cos(pitch));
    camera.up = {0.0f, 1.0f, 0.0f};
}

void Orbit::pan(float right, float up) {
    const glm::vec3 arm = camera.target - camera.eye;
    const glm::vec3 sideways = glm::normalize(glm::cross(arm, camera.up));
    const glm::vec3 upwards = glm::normalize(glm::cross(sideways, arm));
    const float height = 2.0f * glm::length(arm) * std::tan(0.5f * camera.fov_y_rad);
    const glm::vec3 shift = height * (right * sideways + up * upwards);
    camera.eye += shift;
    camera.target += shift;
}

void Orbit::zoom(float factor) {
    camera.eye = camera.target + factor * (camera.eye - camera.target);
}

}  // namespace flg::render
