// SPDX-License-Identifier: MIT
// Corners that are drawn round, over several points: a short bend between two straight sides.
//
// Around each point of the curve a window of arc length w is the bend, and what lies up to 3 w before and behind it are
// its sides. It is a corner if the sides' chords turn by more than the corner's angle, and by more than stands_out
// times what a side turns by itself: one half against the other, or its first or last quarter against its chord. (On a
// circle that is less than 3 times; at the tips of an ellipse 3 times as long as wide, and of waves that slope by 50
// degrees, below 12.) Chords make little of a hand's tremor. Turns of nearly a half are loops and the ends of narrow
// ovals. The bend may not go around a loop either: its ends are as far apart as a corner's.
//
// w is what the host looks for at most, and down from there by sqrt(2) as far as points are close enough together: on
// each half of a side there is one at least, else nobody knows whether it is straight. Of the points of one bend the
// corner is where the chords of both halves of the window turn most.
#pragma once

#include <span>

#include "curves/segment_stream.h"
#include "runtime/task.h"

namespace flg {

// Marks points where segments begin at such corners, farther than a bend from those that are marked already. `angle` in
// radians, `longest` bend in metres. 0.1 to 0.2 us a point and w, of which there are 8 at most. What is referred to
// outlives the task.
Task<void> mark_round_corners(Pace& pace, CurveView curve, double angle, double longest, std::span<uint8_t> marks);

}  // namespace flg
