// SPDX-License-Identifier: MIT
// Where the pictures of strokes are taken from, and how wide they are.
#pragma once

#include <span>

#include "filigree/filigree.h"
#include "filigree_renderer/camera.h"

namespace flg::samples {

constexpr uint32_t kWidth = 1280, kHeight = 720;

struct Framing {
    render::Camera camera;
    uint32_t width;  // of a picture kHeight high, up to kWidth: narrower for tall strokes
};

// All points of the views, filling most of the picture, none at its edge.
Framing frame_strokes(std::span<const FlgCurveSetView> views);

}  // namespace flg::samples
