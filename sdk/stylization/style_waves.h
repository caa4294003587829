// SPDX-License-Identifier: MIT
// How many waves a style has along it: what tells the guide flow how far to go.
//
// The spectrum of the style's unit tangents over its arc length shows waves of all sizes alike, by their slope: a
// zigzag, loops and fur have most of what is in it at their own period, whatever bends beneath them. Bends that don't
// repeat are taken out first, as polynomials. Of several kinds of waves, apart by an octave or more, the shortest count
// that are not slight beside the strongest; overtones belong to their waves. Taken is the low edge of what counts, so
// that uneven waves are as safe as even ones.
#pragma once

#include <span>

#include "core/vec.h"
#include "runtime/task.h"

namespace flg {

// Waves over the whole length, those at the low edge of their spectrum: about 0.6 of what one would count. 0: there are
// none, the style is straight, bends plainly, or is too short to tell. `style`: at least two points, about evenly
// spaced. It outlives the task. About 80 ns a point.
Task<double> count_waves(Pace& pace, std::span<const Vec3> style);

}  // namespace flg
