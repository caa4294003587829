// SPDX-License-Identifier: MIT
// The box around curves at any magnitude offset, without looking at their points again. The furthest that points p +
// offset * d reach along an axis is a convex function of the offset: boxes kept at a few offsets, and a straight line
// from one to the next, never fall short, and are exact at those.
#pragma once

#include "filigree_renderer/camera.h"

namespace flg::render {

class DisplacedBox {
public:
    static constexpr int furthest = 2;  // boxes are kept at the whole offsets from -furthest to furthest

    // `reach`: how far around its point a curve is drawn, metres.
    void add(glm::vec3 position, glm::vec3 displacement, float reach);
    Box at(float offset) const;

private:
    static constexpr int box_count = 2 * furthest + 1;
    Box boxes_[box_count];
    float largest_displacement_ = 0.0f;
};

}  // namespace flg::render
