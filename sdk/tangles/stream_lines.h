// SPDX-License-Identifier: MIT
// The lines of the stream operator: sec. 3.3 of Nazzaro, Puppo, Pellacini: geoTangle (2021). Integral curves of a field
// that start evenly along borders or lines.
//
// Departures
// - A whole border gets as many as the groups that take turns divide: its last strip is not like its first.
// - Away from borders, not towards others, curves meet where distances from borders far apart do. There they end, and
//   this ridge is a line as well: so each strip ends where it meets others.
// - Of borders of each leaf, curves stay in the leaf that they start in.
#pragma once

#include "tangles/tangle_operators.h"
#include "tangles/tangle_seeds.h"

namespace flg {

struct StreamLines {
    SurfaceCurves curves;
    uint32_t stream_count = 0;  // the first ones; the others are ridges
};

// `field`: what the curves climb. Fails if the seeds have neither borders nor lines.
Task<StreamLines> trace_streams(Pace& pace, Tangle& tangle, const LeafSet& leaves, const DivideRequest& request,
                                const DistanceField& field);

}  // namespace flg
