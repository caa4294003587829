// SPDX-License-Identifier: MIT
// The job that prepares a style: Algorithm 1, lines 1 to 6 (Minarcik, Fiser, Sykora).
#pragma once

#include <memory>

#include "runtime/task.h"
#include "stylization/style.h"

namespace flg {

struct StyleRequest {
    std::shared_ptr<const CurveSet> example;
    std::shared_ptr<const CurveSet> guide;  // null: made by the guide flow
    std::shared_ptr<Style> style;           // to be filled in
    uint32_t point_count = 0;               // 0: chosen from the example
    double alpha = 0.5;
    double smoothing = 1;
    double beta = 0.2;
    uint32_t patch = 10;
};

// Points of a style, where the caller doesn't say.
constexpr uint32_t auto_points_min = 256;
constexpr uint32_t auto_points_max = 2048;
constexpr double auto_turn_per_point = 0.12;  // radians

// Stages "resample", "guide_flow", "matching", "displacement", "patch_graph". Throws FLG_ERROR_INVALID_ARGUMENT for examples
// and guides that are not one open curve with length.
Task<void> prepare_style(Pace& pace, StyleRequest request);

}  // namespace flg
