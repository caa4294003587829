// SPDX-License-Identifier: MIT
// The job that applies a prepared style to a curve set: Algorithm 1, line 7 (Minarcik, Fiser, Sykora, sec. 4.5).
#pragma once

#include <array>
#include <memory>

#include "runtime/task.h"
#include "stylization/steering.h"
#include "stylization/style.h"
#include "stylization/style_mix.h"

namespace flg {

struct StylizeRequest {
    std::shared_ptr<Style> style;
    std::shared_ptr<const CurveSet> target;
    std::shared_ptr<CurveSet> out;
    FlgCurveSetStylizeDesc desc;  // checked; its handles are resolved above, its drives copied below
    StyleDrives drives{};
    std::array<std::shared_ptr<Style>, styles_max - 1> further_styles{};  // the first `further_style_count`
    uint32_t further_style_count = 0;
};

// Stages "corners" unless the style goes through them, "steering" if there are drives, "size" if the host leaves that
// to the SDK, "measure", "synthesis"; with several styles all but the first for each, then "mixing".
Task<void> apply_style(Pace& pace, StylizeRequest request);

}  // namespace flg
