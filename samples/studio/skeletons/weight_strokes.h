// SPDX-License-Identifier: MIT
// What was painted on a body: strokes, kept by their places on the drawn parts, so that they can be painted again on
// whatever body is made of the parts later.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

namespace flg::studio {

// On a drawn part, or its mirror image, by the part's name.
struct BodyPlace {
    std::string part;
    bool is_image = false;
    glm::dvec3 at{0.0};  // in the part's drawing, as FlgJointEdit::at
    bool operator==(const BodyPlace&) const = default;
};

// Numbers are kept in documents.
enum class WeightBrush { add, subtract, smooth };

struct WeightDab {
    BodyPlace place;
    double radius = 0.0;     // in units of the part's drawing
    bool is_mirror = false;  // of the stroke's second joint
    bool operator==(const WeightDab&) const = default;
};

struct WeightStroke {
    WeightBrush brush = WeightBrush::add;
    std::string joint, mirror_joint;  // keys; the second is empty where nothing was painted on the other side
    float strength = 0.5f;            // 0 to 1: of what is missing to the whole, in the middle of a dab
    std::vector<WeightDab> dabs;
    bool operator==(const WeightStroke&) const = default;
};

// Never changes once it is a drawing's; copies of drawings share it.
using WeightStrokePtr = std::shared_ptr<const WeightStroke>;

}  // namespace flg::studio
