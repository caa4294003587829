// SPDX-License-Identifier: MIT
// How many steps of a style an open target gets, when it is to have the style's caps, and whole motifs.
//
// As it is, a target gets the whole number of steps that comes nearest to its length, and ends wherever the style then
// is. Here what it gets is chosen first:
//   steps = start cap + repetitions + end cap,
// and steps are stretched or shrunk evenly to fill it. Repetitions follow one another in the style's order, from its
// first joint on, and behind the last one from the first again; there are as many as come nearest to the length, one at
// least. A style that repeats nothing is one motif by itself, and gets
//   motifs * (motif - 1) * r^(1 - fit) steps,   r = what the length asks for / whole motifs:
// what stretching leaves over, the walk skips or repeats on its last path (synthesis). A motif's last point is the next
// one's first.
// A target too short for both caps, or for a motif, gets them smaller, and less of the displacement: smaller in all
// directions.
#pragma once

#include <span>

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

// The motifs that strokes are made of.
struct StrokeMotifs {
    std::span<const uint32_t> joints{};  // find_joints(); none: no motifs are fitted
    double fit = 0;

    bool repeat() const { return joints.size() > 2; }
};

// Steps from the last joint to the style's end, the cap included.
inline uint32_t steps_behind(const PatchGraph& graph, std::span<const uint32_t> joints) {
    return graph.node_count - 1 - joints.back();
}

// `wanted`: the target's length in the style's steps, above 0; `steps`: that as a whole number.
StrokeFit fit_stroke(const PatchGraph& graph, StrokeCaps caps, StrokeMotifs motifs, double wanted, uint32_t steps);

}  // namespace flg
