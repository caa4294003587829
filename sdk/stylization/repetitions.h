// SPDX-License-Identifier: MIT
// The repetitions that a style consists of: its joints, nodes of the same phase, from one of which the style may go on
// behind any other.
//
// The period is the least lag at which the displacement is like itself, as pitch is found in sound (de Cheveigne,
// Kawahara: YIN, a fundamental frequency estimator for speech and music, 2002): the first minimum of D(L) that is low
// against its mean up to L. D(L) is the median of the squared differences at lag L, where sound has their mean: a cap
// may be many times larger than all that repeats. From joint to joint the lag may differ by 40 %: the next joint is
// where the style is most like it was around the second one, over a period.
#pragma once

#include "stylization/displacement.h"
#include "stylization/patch_graph.h"
#include "stylization/style_caps.h"

namespace flg {

// At least two nodes, rising. Between the first and the last lie all whole repetitions of the style's first curve that
// has patches, without its caps; where nothing repeats, they are that curve's ends, and it is the one repetition. Up to
// 4096 points about 2 ms.
Task<Buffer<uint32_t>> find_joints(Pace& pace, const PatchGraph& graph, const Displacement& displacement);

// What a style of one curve has before its first and behind its last repetition; none where nothing repeats, or where
// it goes on to repeat in part.
Task<StyleCaps> caps_beside_repetitions(Pace& pace, const Displacement& displacement);

}  // namespace flg
