// SPDX-License-Identifier: MIT
// What the mouse can take hold of in the picture, and where that is. Pixels of the window.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "splines/spline_editor.h"

namespace flg::studio::splines {

enum class HandleKind {
    none,
    point,  // of the chosen curve
    span,   // the chosen curve between point `index` and the next
    curve,  // another one
    begin_slope,
    end_slope,
    solid,      // an obstacle by its middle
    solid_end,  // a capsule by its other end
    solid_size,
    key,  // of the chosen motion
    ring  // turns the chosen key about the body's axis `index`
};

struct Handle {
    HandleKind kind = HandleKind::none;
    uint32_t item = 0;
    int index = 0;
    bool operator==(const Handle&) const = default;
};

// Of the layout: how near the mouse must be, and how thick what is drawn is. Times AppContext::scale.
constexpr float kReach = 8.0f, kCurveReach = 6.0f;

// The ends of the arrows that are the slopes; none for closed curves.
std::optional<glm::dvec3> slope_tip(const SplineEditor& editor, const Curve& curve, bool begin);
double slope_length(const SplineEditor& editor);  // metres that a slope of 1 is shown as
// The ring about an axis of the body of a key.
std::vector<glm::dvec3> ring_of(const Motion& motion, const Key& key, int axis);
// To the right of an obstacle as it is seen, on its outline.
glm::dvec3 size_handle(const SplineEditor& editor, const Obstacle& obstacle);
double reach_of(const Obstacle& obstacle);  // from its middle to its farthest point

std::vector<glm::vec2> project(const View& view, std::span<const glm::dvec3> places);
// From a pixel to the nearest of a chain's pieces; none: FLT_MAX. Places behind the eye must not be there.
float distance_to(const std::vector<glm::vec2>& chain, glm::vec2 px);

// What lies under the mouse, for the tool that is chosen.
Handle find_handle(const SplineEditor& editor, glm::vec2 px);

}  // namespace flg::studio::splines
