// SPDX-License-Identifier: MIT
// The sizes in which a style was drawn on curves, and how thick lines are that have no radius of their own.
#pragma once

#include <vector>

#include "documents/report.h"
#include "documents/session.h"
#include "filigree/filigree.h"

namespace flg::cli {

struct ChosenScales {
    std::vector<float> scales;  // one a curve
    float rms;                  // metres that the style swings at scale 1

    // Metres; the style's turns stay apart.
    float radius_at(float scale) const;
    float median() const;
    // Their least, median and greatest into the report's quality.
    void describe(Report& report) const;
};

// Of a result that is there.
ChosenScales scales_of(FlgContext context, FlgStyle style, FlgCurveSet result);

// Those that the SDK chooses for curves.
ChosenScales choose_scales(Session& session, FlgStyle style, const FlgCurveSetView& curves, const std::string& name,
                           Report& report);

}  // namespace flg::cli
