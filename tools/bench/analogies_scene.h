// SPDX-License-Identifier: MIT
// A built-in style put on a built-in target by Filigree and by Curve Analogies, with the same predefined guide: for the
// rows of the bench and the gallery's picture (Fig. 11 of the paper).
#pragma once

#include <string>
#include <vector>

#include "bench/host.h"
#include "core/vec.h"

namespace flg::bench {

struct AnalogiesScene {
    std::vector<Vec3> guide, style;  // point by point, at the size they have on the target
    std::vector<Vec3> target;        // evenly resampled: what both methods get
    std::vector<Vec3> ours, theirs;  // a point for each of the target
    double cold_ms, warm_ms;  // ours from guide and style on: matching, patch graph, synthesis; with a prepared style
    double theirs_ms;         // from the matched guide and style on
};

// `scale` as in FlgStylizeDesc. Times are medians of `runs`.
AnalogiesScene make_analogies_scene(const std::string& style, const std::string& target, float scale, int runs);

}  // namespace flg::bench
