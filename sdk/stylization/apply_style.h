// SPDX-License-Identifier: MIT
// The job that applies a prepared style to a curve set: Algorithm 1, line 7 (Minarcik, Fiser, Sykora, sec. 4.5).
#pragma once

#include <memory>

#include "runtime/task.h"
#include "stylization/steering.h"
#include "stylization/style.h"

namespace flg {

struct StylizeRequest {
    std::shared_ptr<Style> style;
    std::shared_ptr<const CurveSet> target;
    std::shared_ptr<CurveSet> out;
    FlgCurveSetStylizeDesc desc;  // checked; its handles are resolved above, its drives copied below
    StyleDrives drives{};
};

// Stages "steering" if there are drives, "size" if the host leaves that to the SDK, "measure", "synthesis".
Task<void> apply_style(Pace& pace, StylizeRequest request);

}  // namespace flg
