// SPDX-License-Identifier: MIT
// A motion that shows whether a model is bound well: each joint swings about the normal of its part's plane, later the
// farther it is from the root, and mirror images in turn.
#pragma once

#include <vector>

#include "documents/model_drawing.h"

namespace flg::cli {

struct TestMotion {
    const char* name = "swing";
    std::vector<float> times, rotations, translations;  // as FlgSkinAnimation has them; no translations: none

    FlgSkinAnimation animation() const;
};

// Two seconds that can be repeated.
TestMotion make_test_motion(const FlgModelView& model, const ModelDrawing& drawing);

}  // namespace flg::cli
