// SPDX-License-Identifier: MIT
// Corners of curves, and curves in pieces from corner to corner, each of which is sampled in equal steps of its own.
//
// A corner is a point where edges turn by more than an angle, and stand out by that: by more than twice what they turn
// by, in the same direction, at the points next to it. Else coarse samples of a tight bend would be corners. Turns of
// 1.7 times the angle are corners anyway: a square has nothing but such. Corners that are drawn round, over several
// points, are round_corners.h's.
// Open curves have a piece more than corners, closed ones as many: such a curve begins at a corner (begin_at_corners).
#pragma once

#include <memory>
#include <span>

#include "curves/curve_set.h"
#include "curves/segment_stream.h"
#include "runtime/task.h"

namespace flg {

struct CurvePiece {
    uint32_t first_segment = 0, last_segment = 0;  // as SegmentStream has their indices
    double metres = 0, length = 0;                 // its length; likewise, divided by the step scales along it
    Vec3 start = Vec3::Zero();
    Vec3 tangent_start = Vec3::UnitX(), tangent_end = Vec3::UnitX();
    // Filled in by who chooses the steps.
    double step = 0;        // of `length`
    uint32_t end_step = 0;  // the sample at its end, which is the next piece's first
};

struct CornerSearch {
    double angle = 0;         // radians
    double longest_bend = 0;  // metres: how far corners are drawn round at most; 0: they are points
};
struct CornerCount {
    uint32_t corners = 0;
    uint32_t first_segment = 0;  // of a closed curve: the one that begins at its first corner
};
// `marks`: one a point of the curve, made 1 where a segment begins at a corner and else 0. About 50 ns a point, 0.4 to
// 1.6 us with bends. What is referred to outlives the task.
Task<CornerCount> find_corners(Pace& pace, CurveView curve, CornerSearch search, std::span<uint8_t> marks);

// The same curves; closed ones begin at their first corner if they have any. `counts`: one a curve. The set itself if
// nothing changes.
Task<std::shared_ptr<const CurveSet>> begin_at_corners(Pace& pace, std::shared_ptr<const CurveSet> set,
                                                       std::span<const CornerCount> counts);

// Fills in the pieces, which know their first segments, but for an open curve's first one. `scales`: one a point, see
// StepScale; null: 1.
Task<void> split_at_corners(Pace& pace, CurveView curve, const float* scales, std::span<CurvePiece> pieces);

}  // namespace flg
