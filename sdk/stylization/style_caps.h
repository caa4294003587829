// SPDX-License-Identifier: MIT
// A style's caps: the points at its start and at its end that strokes begin and end with, and never repeat. They are
// given as lengths of the example, or found: what comes before the first and after the last repetition. That is so
// many points in a row as a patch has, each of them in the middle of a patch that has a like one elsewhere.
// Where the style has a period, caps_beside_repetitions() knows better.
//
// For that, patches are wide: a flourish that goes to and fro must not count as its own repetition. Like are patches
// whose distance is below a tenth of what two unrelated ones have, or below twice the median of the patches' distances
// to the one most like each.
#pragma once

#include "runtime/task.h"
#include "stylization/patch_graph.h"

namespace flg {

struct StyleCaps {
    uint32_t start = 0, end = 0;  // points
};

// `matching`: arc lengths on the style's curves, of its points; `last_length`: the last curve's. Caps below 0 count as
// 0.
StyleCaps marked_caps(std::span<const uint32_t> boundaries, std::span<const float> matching, double last_length,
                      double start_cap, double end_cap);

// The scene as caps are looked for in it.
StyleScene wide_scene(StyleScene scene);
// From that scene's graph. `rms`: metres, of the displacement.
Task<StyleCaps> find_caps(Pace& pace, const PatchGraph& graph, const StyleScene& scene, double rms);

}  // namespace flg
