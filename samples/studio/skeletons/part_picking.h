// SPDX-License-Identifier: MIT
// Which part of the drawing or which joint lies under the mouse, and where parts' outlines are in the window.
#pragma once

#include <optional>

#include "skeletons/editor.h"

namespace flg::studio {

struct PartHit {
    uint32_t id;
    glm::vec3 position;  // metres
    bool is_image;       // of the mirror
};

// On the body at rest, as it is shown; where there is none the smallest outline around the place.
std::optional<PartHit> pick_part(const Editor& editor, glm::vec2 px);

// A point of a skin's surface.
struct SkinHit {
    uint32_t triangle;
    glm::vec3 shares;    // of its corners
    glm::vec3 position;  // metres
};

// The nearest along a ray. `positions`: 3 per vertex, of the pose that is shown. Cost: 5 ns a triangle.
std::optional<SkinHit> pick_skin(const FlgSkinView& skin, std::span<const float> positions, const Ray& ray);

// Of a ring of the part, or of its mirror image; empty where it reaches behind the eye.
std::vector<glm::vec2> ring_in_window(const View& view, const DrawnPart& part, const Ring& ring,
                                      const glm::vec4* mirror = nullptr);
bool is_in_polygon(std::span<const glm::vec2> polygon, glm::vec2 px);

constexpr float kJointReach = 9.0f;  // units of the layout

// The nearest joint within its ball, as it is drawn, or within `reach` pixels.
std::optional<uint32_t> joint_at(const View& view, glm::vec2 px, const Rig& rig, const PosedJoints& joints,
                                 float reach);

// Where the ray through a pixel meets the part's plane, or that of its mirror image, in units of its contour.
std::optional<glm::dvec2> meet_part(const View& view, const DrawnPart& part, glm::vec2 px,
                                    const glm::vec4* mirror = nullptr);

}  // namespace flg::studio
