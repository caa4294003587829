// SPDX-License-Identifier: MIT
// How curves look in the gallery.
#pragma once

#include "filigree_renderer/renderer.h"

namespace flg::gallery {

constexpr uint32_t kWidth = 960, kHeight = 540;  // of a picture, pixels

// Linear RGB.
constexpr glm::vec3 kInk = {0.020f, 0.035f, 0.090f}, kRed = {0.66f, 0.035f, 0.020f}, kGold = {0.85f, 0.36f, 0.03f},
                    kTeal = {0.010f, 0.200f, 0.190f}, kLeaf = {0.060f, 0.190f, 0.020f}, kGrey = {0.30f, 0.30f, 0.31f};

// `radius` counts where the curves have none.
inline render::CurveLook tube(glm::vec3 color = kInk, float radius = 0.005f, float radius_scale = 1.0f) {
    render::CurveLook look;
    look.shape = render::Shape::tube;
    look.color = look.color_end = color;
    look.radius = radius;
    look.radius_scale = radius_scale;
    return look;
}

inline render::CurveLook ribbon(glm::vec3 from, glm::vec3 to, float radius, float radius_scale = 1.0f) {
    render::CurveLook look = tube(from, radius, radius_scale);
    look.shape = render::Shape::ribbon;
    look.color_end = to;
    return look;
}

// The head and the ball: large tubes, round and matte.
inline render::CurveLook body() {
    render::CurveLook look = tube();
    look.sides = 32;
    look.gloss = 0.1f;
    look.caps = render::Caps::none;
    return look;
}

}  // namespace flg::gallery
