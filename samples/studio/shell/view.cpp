// SPDX-License-Identifier: MIT
#include "shell/view.h"

#include <array>
#include <cmath>

namespace flg::studio {
namespace {

// Right, up and forward of the camera.
struct Axes {
    glm::vec3 right, up, forward;
    float tan_half;
};

Axes axes_of(const render::Camera& camera) {
    Axes axes;
    axes.forward = glm::normalize(camera.target - camera.eye);
    axes.right = glm::normalize(glm::cross(axes.forward, camera.up));
    axes.up = glm::cross(axes.right, axes.forward);
    axes.tan_half = std::tan(0.5f * camera.fov_y_rad);
    return axes;
}

}  // namespace

bool View::contains(glm::vec2 px) const {
    return px.x >= viewport.x && px.y >= viewport.y && px.x < viewport.x + viewport.z && px.y < viewport.y + viewport.w;
}

Ray View::ray(glm::vec2 px) const {
    const Axes axes = axes_of(orbit.camera);
    const glm::vec2 size(viewport.z, viewport.w);
    const glm::vec2 share = (px - glm::vec2(viewport.x, viewport.y)) / size * 2.0f - 1.0f;
    const glm::vec3 direction =
        axes.forward + axes.right * (share.x * axes.tan_half * aspect()) - axes.up * (share.y * axes.tan_half);
    return {orbit.camera.eye, glm::normalize(direction)};
}

std::optional<glm::vec2> View::project(const glm::vec3& world) const {
    const Axes axes = axes_of(orbit.camera);
    const glm::vec3 arm = world - orbit.camera.eye;
    const float depth = glm::dot(arm, axes.forward);
    if (!(depth > 1e-6f * glm::length(orbit.camera.target - orbit.camera.eye))) return std::nullopt;
    const glm::vec2 share(glm::dot(arm, axes.right) / (depth * axes.tan_half * aspect()),
                          -glm::dot(arm, axes.up) / (depth * axes.tan_half));
    return glm::vec2(viewport.x, viewport.y) + 0.5f * (share + 1.0f) * glm::vec2(viewport.z, viewport.w);
}

float View::metres_per_px(const glm::vec3& world) const {
    const Axes axes = axes_of(orbit.camera);
    const float depth = glm::dot(world - orbit.camera.eye, axes.forward);
    return 2.0f * std::abs(depth) * axes.tan_half / static_cast<float>(viewport.w);
}

void View::frame(const render::Box& box) {
    frame(box, orbit.camera.target - orbit.camera.eye);
}

void View::frame(const render::Box& box, const glm::vec3& sight) {
    constexpr float margin = 1.25f;
    const render::Box seen = box.empty() ? render::Box{glm::vec3(-0.5f), glm::vec3(0.5f)} : box;
    std::array<glm::vec3, 8> corners;
    for (size_t i = 0; i < corners.size(); ++i)
        corners[i] = {i & 1 ? seen.max.x : seen.min.x, i & 2 ? seen.max.y : seen.min.y,
                      i & 4 ? seen.max.z : seen.min.z};
    const float fov = orbit.camera.fov_y_rad;
    orbit.camera = render::frame_points(corners, sight, aspect(), margin, fov);
    // The camera turns about what it looks at.
    const glm::vec3 forward = glm::normalize(orbit.camera.target - orbit.camera.eye);
    orbit.camera.target = orbit.camera.eye + forward * glm::dot(seen.center() - orbit.camera.eye, forward);
}

std::optional<glm::vec3> meet_plane(const Ray& ray, const glm::vec3& point, const glm::vec3& normal) {
    const float along = glm::dot(ray.direction, normal);
    if (std::abs(along) < 1e-6f) return std::nullopt;
    const float distance = glm::dot(point - ray.origin, normal) / along;
    if (!(distance > 0.0f) || !std::isfinite(distance)) return std::nullopt;
    return ray.origin + distance * ray.direction;
}

}  // namespace flg::studio
