// SPDX-License-Identifier: MIT
// What pictures point things out with: dots, and places on curves.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "filigree/filigree.h"
#include "scenes/scenes.h"

namespace flg::gallery {

inline scenes::Point to_point(const glm::vec3& p) {
    return {p.x, p.y, p.z};
}

// A ball: a tube without length, round at its ends.
scenes::Curve dot(const glm::vec3& at);

// The values of a column of three, one a point.
std::vector<glm::vec3> vectors_of(const FlgCurveSetView& curves, FlgAttribute attribute = FLG_ATTRIBUTE_POSITION);

// Where these lengths along the first curve lead, which must not fall.
std::vector<glm::vec3> places_on(const FlgCurveSetView& curve, std::span<const float> lengths);

// The corners of a cube.
std::vector<glm::vec3> around(const glm::vec3& center, float reach);

// A target that is wider than high: a plane arc that turns the other way in its middle.
scenes::Curve wave();

// Moved as a whole.
scenes::Curve moved(scenes::Curve curve, const glm::vec3& by);

}  // namespace flg::gallery
