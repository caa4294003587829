// SPDX-License-Identifier: MIT
// How many steps of a style an open target gets, when it is to have the style's caps, and whole motifs.
//
// As it is, a target gets the whole number of steps that comes nearest to its length, and ends wherever the style then
// is. Here what it gets is chosen first:
//   steps = start cap + motifs * (motif - 1) * r^(1 - fit) + end cap,   r = what the length asks for / whole motifs,
// and steps are stretched or shrunk evenly to fill it. A motif's last point is the next one's first. What stretching
// leaves over, the walk skips or repeats on its last path (synthesis).
// A target too short for both caps, or for a motif, gets them smaller, and less of the displacement: smaller in all
// directions.
#pragma once

#include "stylization/patch_graph.h"

namespace flg {

struct StrokeFit {
    uint32_t steps = 0;
    float across = 1;  // factor on the displacement, at most 1
};

// Points of the style's caps that a target gets.
struct StrokeCaps {
    uint32_t start = 0, end = 0;
};

// `wanted`: the target's length in the style's steps, above 0; `steps`: that as a whole number.
StrokeFit fit_stroke(const PatchGraph& graph, StrokeCaps caps, double wanted, uint32_t steps, double fit);

}  // namespace flg
