// SPDX-License-Identifier: MIT
// Baseline: A. Hertzmann, N. Oliver, B. Curless, S. M. Seitz, "Curve Analogies" (Eurographics Workshop on Rendering
// 2002), extended to space curves as naively as Minarcik, Fiser, Sykora did for their sec. 7: neighbourhoods of points
// are compared after the rigid motion that aligns them best; no moving frame is carried along.
//
// For each point of the target in order: its neighbourhood, which is the target around it and the result made so far
// before it, is compared with the same neighbourhood (guide around, style before) of every point of the exemplar. The
// best match, or the one that continues the last match if it is about as good, gives its offset from guide to style,
// turned as the alignment turns.
//
// Departures from the 2002 paper
// - In space: the alignment is Kabsch's. One for guide and style together, so that the style stays where its guide is.
// - One level, not a pyramid; every candidate is compared, none is found by approximate search. Uniform weights.
// - Its exemplar is as good as ours: guide and style come matched point by point.
// Made to be fast, as far as the method goes: covariances of two candidates at a time, energies from running sums,
// singular values in closed form; only the winner's rotation is a decomposition.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace flg::bench {

struct Analogy {
    std::vector<Vec3> points;       // one for each point of the target
    std::vector<uint32_t> matches;  // the exemplar's point that each copies
};

// The target with the style that leads from `guide` to `style`, points that belong together. `guide` and `target` have
// the same spacing, and more than 2 * neighbourhood + 1 points, neighbourhood >= 1.
Analogy curve_analogies(const std::vector<Vec3>& guide, const std::vector<Vec3>& style, const std::vector<Vec3>& target,
                        uint32_t neighbourhood);

}  // namespace flg::bench
