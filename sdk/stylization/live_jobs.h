// SPDX-License-Identifier: MIT
// Jobs around live strokes: warming a style, ending a stroke, cutting it in two, drawing recorded samples.
#pragma once

#include "runtime/task.h"
#include "stylization/live_stroke.h"

namespace flg {

// Stage "path_trees": all trees of the style at a temperature (in units of the style's).
Task<void> warm_style(Pace& pace, std::shared_ptr<Style> style, double temperature);

// What ends a live stroke: follows it to its last sample, then copies. Either set may be null.
struct LiveEnding final : Output {
    std::shared_ptr<LiveStroke> stroke;
    std::shared_ptr<CurveSet> stylized, samples;

    void publish_partial() noexcept override {}
    void publish(const Job& job) noexcept override;
    void warn(const Host& host) const noexcept override;
};
// Stages "live_stroke", "copy". The ending outlives the job.
Task<void> end_stroke(Pace& pace, LiveEnding& ending);

// Points 0 to `point` and `point` to the last. Either set may be null.
struct LiveSplit final : Output {
    std::shared_ptr<LiveStroke> stroke;
    uint32_t point = 0;
    std::shared_ptr<CurveSet> first, second;

    void publish_partial() noexcept override {}
    void publish(const Job& job) noexcept override;
};
// Stage "copy".
Task<void> split_stroke(Pace& pace, LiveSplit& split);

struct LiveReplayRequest {
    LiveStyleRequests styles{};  // their trees are found by the job
    uint32_t style_count = 1;
    std::shared_ptr<const CurveSet> samples;
    std::shared_ptr<CurveSet> out;
    FlgLiveStrokeDesc desc;  // checked; its styles are resolved above; curve c is drawn with seed + c
    StyleDrives drives{};    // its drives
};
// Stages "path_trees", "check", "live_stroke".
Task<void> replay_strokes(Pace& pace, LiveReplayRequest request);

}  // namespace flg
