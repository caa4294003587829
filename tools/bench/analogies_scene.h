// SPDX-License-Identifier: MIT
// A built-in style put on a built-in target by Filigree and by Curve Analogies, with the same predefined guide: for the
// rows of the bench and the gallery's picture (Fig. 11 of the paper).
#pragma once

#include <string>
#include <vector>

#include "bench/curve_analogies.h"

namespace flg::bench {

struct AnalogiesScene {
    std::vector<Vec3> guide, style;  // point by point, at the size they have on the target
    std::vector<Vec3> target;        // evenly resampled: what both methods get
    std::vector<Vec3> guide_tangents, target_tangents;
    Analogy ours, theirs;
    double cold_ms,
        warm_ms;       // ours, from guide and style on: matching, patch graph, synthesis; and with a prepared style
    double theirs_ms;  // from the matched guide and style on
};

// `scale` as in FlgCurveSetStylizeDesc. Times are medians of `runs`.
AnalogiesScene make_analogies_scene(const std::string& style, const std::string& target, float scale, int runs);

}  // namespace flg::bench
