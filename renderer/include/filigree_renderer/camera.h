// SPDX-License-Identifier: MIT
// Where the picture is taken from. Right-handed, y up, metres, radians, as in the rest of Filigree.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>

namespace flg::render {

// An axis-aligned box, metres; empty while min > max.
struct Box {
    glm::vec3 min{1.0f};
    glm::vec3 max{-1.0f};
    bool empty() const { return min.x > max.x; }
    glm::vec3 center() const { return 0.5f * (min + max); }
    float diagonal() const { return empty() ? 0.0f : glm::length(max - min); }
    void add(const Box& other);
};

// What an eye sees, as headsets say it: angles from the line of sight, radians, to the left and down negative, less than a
// right angle each.
struct FieldOfView {
    float left, right, up, down;
};

struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 1.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};  // not along the line of sight; corrected if it is
    float fov_y_rad = 0.6f;          // height of the view, in (0, pi)
    // In place of it, and of the picture's aspect.
    std::optional<FieldOfView> field{};
};

constexpr float default_fov_y_rad = 0.6f;  // about a 38 mm lens on film

// The camera that looks along `direction` (from the eye into the scene, any length but zero) and sees the whole box, with a
// small margin, in a picture `aspect` times as wide as high. An empty box is taken as a point, a point as a box of one
// metre.
Camera frame_box(const Box& box, glm::vec3 direction, float aspect, float fov_y_rad = default_fov_y_rad);

// The same for points, of which there must be one: as near as it can be while the picture's edges stay clear of them by
// `margin`, the picture's size over that of what they fill, >= 1.
Camera frame_points(std::span<const glm::vec3> points, glm::vec3 direction, float aspect, float margin,
                    float fov_y_rad = default_fov_y_rad);

// Turns around its target, moves nearer and aside; what the mouse does in a window.
struct Orbit {
    Camera camera;
    void turn(float yaw_rad, float pitch_rad);  // stays clear of the poles
    void pan(float right, float up);            // in heights of the picture
    void zoom(float factor);                    // > 0; multiplies the distance to the target
};

}  // namespace flg::render
