// SPDX-License-Identifier: MIT
// The curves of a style and their guides, up to the points that the style's nodes are (Minarcik, Fiser, Sykora, sec.
// 4.1 and Fig. 3). A style may have several curves; its guides are all sampled with the same spacing, as nearly as
// whole numbers of steps allow: steps are shared out by guide length, largest remainders first, at least one each.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "curves/sampling_job.h"
#include "stylization/prepare_style.h"

namespace flg {

struct StyleCurve {
    explicit StyleCurve(Memory* memory) : points(memory) {}

    CurveView example;
    CurveMeasure measure;
    std::pmr::vector<Vec3> points;  // even ones of the example, close enough for a smooth curve through them
    CurveView guide;
    CurveMeasure guide_measure;
    Buffer<float> placed;  // the guide's points, if the flow made it or it came with another origin
    uint32_t steps = 0;    // between the guide's nodes: one fewer than these
    // Caps, around which the guide goes straight on.
    struct Cap {
        uint32_t points = 0;      // of `points`, apart from the one that it shares with the body
        double guide_length = 0;  // metres
    };
    Cap start_cap, end_cap;

    // Metres of the example between neighbouring points.
    double point_spacing() const { return measure.length / static_cast<double>(points.size() - 1); }
    // Nodes of the guide that are a cap's.
    uint32_t nodes_of(const Cap& cap) const {
        if (cap.points == 0) return 0;
        const double nodes = std::round(steps * (cap.guide_length / guide_measure.length));
        return std::max(static_cast<uint32_t>(nodes), 1U);
    }
};

using StyleCurves = std::pmr::vector<StyleCurve>;

// Measures the example's curves; throws FLG_ERROR_INVALID_ARGUMENT where example or guide are not open curves with
// length, equally many.
Task<void> measure_curves(Pace& pace, const StyleRequest& request, StyleCurves& curves);
// The number of points a style is given, where the caller doesn't say.
Task<uint32_t> choose_point_count(Pace& pace, const StyleCurves& curves);
// Samples the example's curves, with `count` points in all.
Task<void> sample_curves(Pace& pace, StyleCurves& curves, uint32_t count);
// The guides: flowed, unless given, and measured. What `desc` marks as caps isn't flowed, else an arrow's head would
// bend the guide of its shaft: there the guide goes on straight, as far as the cap reaches. Returns the flow's steps.
Task<uint32_t> make_guides(Pace& pace, const StyleRequest& request, StyleCurves& curves);
// Shares out `count` points; throws where no curve gets enough for two patches of size `patch`.
void share_points(StyleCurves& curves, uint32_t count, uint32_t patch, Memory* memory);
// The guides' nodes as a curve set, with the frames that synthesis would give these curves as targets.
Task<void> frame_guides(Pace& pace, const StyleCurves& curves, CurveSet& guide);

}  // namespace flg
