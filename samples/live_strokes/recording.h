// SPDX-License-Identifier: MIT
// Strokes as a controller drew them, one after the other on one clock.
#pragma once

#include <string>
#include <vector>

#include "filigree/filigree_live.h"
#include "live_strokes/xr_source.h"
#include "support/live_sample.h"

namespace flg::samples {

class Recording {
public:
    // "builtin:session": made here; else a file of curves or builtin:NAME, as CurveSource reads it: TIME, PRESSURE and
    // ORIENTATION where there are, else drawn at an even speed and full pressure. What is larger than an arm reaches,
    // or far from the hand, is brought there. Throws SourceError.
    explicit Recording(const std::string& name);

    double end_s() const { return strokes_.back().back().time; }
    // Where the controller is: on a stroke with its trigger pressed, or on its way to the next. It starts over at the
    // end.
    XrController at(double time_s) const;

private:
    using Stroke = std::vector<LiveSample>;
    void draw_session();
    void load(const std::string& name);
    void bring_near();

    std::vector<Stroke> strokes_;  // two samples each at least; times rise from stroke to stroke
};

}  // namespace flg::samples
