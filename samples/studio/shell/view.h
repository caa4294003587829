// SPDX-License-Identifier: MIT
// Where the scene is looked at from, and what lies under a pixel.
#pragma once

#include <optional>

#include "filigree_renderer/camera.h"

namespace flg::studio {

struct Ray {
    glm::vec3 origin{0.0f}, direction{0.0f, 0.0f, -1.0f};  // of unit length
};

class View {
public:
    render::Orbit orbit;
    glm::ivec4 viewport{0, 0, 1, 1};  // x, y, width, height of the 3D picture in the window, pixels

    float aspect() const { return static_cast<float>(viewport.z) / static_cast<float>(viewport.w); }
    bool contains(glm::vec2 px) const;
    Ray ray(glm::vec2 px) const;
    // In pixels of the window; none behind the eye.
    std::optional<glm::vec2> project(const glm::vec3& world) const;
    // Metres that a pixel covers at a place.
    float metres_per_px(const glm::vec3& world) const;
    // Moves the camera so that it sees the whole box, along its present sight.
    void frame(const render::Box& box);
    // The same along another one; what the keys for front, side and top do.
    void frame(const render::Box& box, const glm::vec3& sight);
};

// Where the ray meets a plane; none if it runs along it or away from it.
std::optional<glm::vec3> meet_plane(const Ray& ray, const glm::vec3& point, const glm::vec3& normal);

}  // namespace flg::studio
