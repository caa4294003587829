// SPDX-License-Identifier: MIT
// The camera. Right-handed, y up, metres, radians, as in the rest of Filigree.
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

// An eye's field of view, as headsets report it: angles from the line of sight, radians, left and down negative, each
// less than a right angle.
struct FieldOfView {
    float left, right, up, down;
};

struct Camera {
    glm::vec3 eye{0.0f, 0.0f, 1.0f};
    glm::vec3 target{0.0f};
    glm::vec3 up{0.0f, 1.0f, 0.0f};  // not along the line of sight; corrected if it is
    float fov_y_rad = 0.6f;          // height of the view, in (0, pi)
    // Replaces fov_y_rad and the picture's aspect.
    std::optional<FieldOfView> field{};
};

constexpr float default_fov_y_rad = 0.6f;  // about a 38 mm lens on film

// A camera that looks along `direction` (from the eye into the scene, any length but zero) and sees the whole box, with
// a small margin, in a picture `aspect` times as wide as high. An empty box counts as a point, a point as a box of one
// metre.
Camera frame_box(const Box& box, glm::vec3 direction, float aspect, float fov_y_rad = default_fov_y_rad);

// The same for points, at least one: as near as possible while the points keep `margin` from the picture's edges: the
// picture's size divided by the size they fill, >= 1.
Camera frame_points(std::span<const glm::vec3> points, glm::vec3 direction, float aspect, float margin,
                    float fov_y_rad = default_fov_y_rad);

// Turns around its target, zooms and pans; driven by the mouse in a window.
struct Orbit {
    Camera camera;
    void turn(float yaw_rad, float pitch_rad);  // stays clear of the poles
    void pan(float right, float up);            // in picture heights
    void zoom(float factor);                    // > 0; multiplies the distance to the target
};

}  // namespace flg::render
