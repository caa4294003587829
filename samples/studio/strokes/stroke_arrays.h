// SPDX-License-Identifier: MIT
// Strokes as the SDK takes them: recorded samples in flat arrays.
#pragma once

#include <span>
#include <vector>

#include "filigree/filigree_live.h"
#include "strokes/stroke_document.h"
#include "support/live_sample.h"

namespace flg::studio {

// POSITION, ORIENTATION, PRESSURE, TIME, and COLOR for the renderer where there is one.
class StrokeArrays {
public:
    explicit StrokeArrays(std::span<const Stroke> strokes);
    // Lives as long as this.
    const FlgCurveSetView& view() const { return view_; }

private:
    std::vector<float> positions_, orientations_, pressures_, times_;
    std::vector<uint32_t> offsets_{0};
    std::vector<FlgColumn> columns_;
    FlgCurveSetView view_;
};

// What a controller would say whose y axis is the sample's normal.
samples::LiveSample live_sample(const StrokeSample& sample);

constexpr float kHandSmoothing_s = 0.02f;  // of a mouse's steps

// How far the style swings off a stroke of this hand, root mean square, metres.
float swing_m(const StrokeSettings& settings);

// A live stroke with these settings; `rms` of the style at scale 1, metres, `size` of DrawnStroke.
FlgLiveStrokeDesc live_desc(const StrokeSettings& settings, float rms, float size);

}  // namespace flg::studio
