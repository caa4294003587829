// SPDX-License-Identifier: MIT
// The repetitions that a style consists of: its joints, nodes of the same phase, from one of which the style may go on
// behind any other.
//
// The period is the least lag at which the displacement is like itself, as pitch is found in sound (de Cheveigne,
// Kawahara: YIN, a fundamental frequency estimator for speech and music, 2002): D(L) is the mean squared difference at
// lag L, and the first minimum of D(L) over its mean up to L that is low enough counts. From joint to joint the lag may
// differ by 40 %: the next joint is where the style is most like it was around the one before, over a period.
#pragma once

#include "stylization/displacement.h"
#include "stylization/patch_graph.h"

namespace flg {

// At least two nodes, rising. Between the first and the last lie all whole repetitions of the style's first curve that
// has patches, without its caps; where nothing repeats, they are that curve's ends, and it is the one repetition. Up to
// 4096 points about 2 ms.
Task<Buffer<uint32_t>> find_joints(Pace& pace, const PatchGraph& graph, const Displacement& displacement);

}  // namespace flg
