// SPDX-License-Identifier: MIT
// The job that prepares a style: Algorithm 1, lines 1 to 6 (Minarcik, Fiser, Sykora).
#pragma once

#include <array>
#include <memory>

#include "runtime/task.h"
#include "stylization/style.h"

namespace flg {

// Several patch sizes, attributes, curves: so many at most. The last bounds the matrix' first rows and the jumps kept
// from the curves' last patches.
constexpr uint32_t patch_sizes_max = 8;
constexpr uint32_t style_curves_max = 256;

struct StyleRequest {
    std::shared_ptr<const CurveSet> example;
    std::shared_ptr<const CurveSet> guide;  // null: made by the guide flow
    std::shared_ptr<Style> style;           // to be filled in
    FlgStyleDesc desc;                      // checked; its handles are resolved above, its arrays copied below
    std::array<FlgPatchSize, patch_sizes_max> patch_sizes{};
    std::array<FlgStyleAttribute, style_attributes_max> attributes{};

    uint32_t largest_patch() const;
};

// Points of a style, where the caller doesn't say.
constexpr uint32_t auto_points_min = 256;
constexpr uint32_t auto_points_max = 2048;
constexpr double auto_turn_per_point = 0.12;  // radians

// Stages "resample", "guide_flow", "matching", "displacement", "patch_graph". Throws FLG_ERROR_INVALID_ARGUMENT for
// examples and guides that are not open curves with length, and for attributes that the example doesn't have.
Task<void> prepare_style(Pace& pace, StyleRequest request);

}  // namespace flg
