// SPDX-License-Identifier: MIT
// The job that applies a prepared style to a curve set: Algorithm 1, line 7 (Minarcik, Fiser, Sykora, sec. 4.5).
#pragma once

#include <array>
#include <memory>

#include "runtime/task.h"
#include "stylization/style.h"

namespace flg {

struct StylizeRequest {
    std::shared_ptr<Style> style;
    std::shared_ptr<const CurveSet> target;
    std::shared_ptr<CurveSet> out;
    double magnitude = 1;
    double temperature = 0;  // in units of the style's
    double scale = 1;
    std::array<double, 9> basis{1, 0, 0, 0, 1, 0, 0, 0, 1};  // row-major
    FlgFrameMethod frame = FLG_FRAME_ROTATION_MINIMIZING;
    FlgStart start = FLG_START_AUTO;
    uint64_t seed = 1;
    uint32_t strokes = 1;
    uint32_t max_points = 0;  // of the result; 0: as many as there can be
    bool pin_ends = false;
    bool keep_displacement = false;
};

// Stages "measure", "synthesis".
Task<void> apply_style(Pace& pace, StylizeRequest request);

}  // namespace flg
