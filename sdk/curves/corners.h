// SPDX-License-Identifier: MIT
// Corners of curves, and curves in pieces from corner to corner, each of which is sampled in equal steps of its own.
//
// A corner is a point where edges turn by more than an angle, and stand out by that: by more than twice what they turn
// by, in the same direction, at the points next to it. Else coarse samples of a tight bend would be corners. Turns of
// 1.7 times the angle are corners anyway: a square has nothing but such.
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

// The angle in radians. About 50 ns a point. The curve outlives the task.
struct CornerCount {
    uint32_t corners = 0;
    uint32_t first_segment = 0;  // of a closed curve: the one that begins at its first corner
};
Task<CornerCount> count_corners(Pace& pace, CurveView curve, double corner_angle);

// The same curves; closed ones begin at their first corner if they have any. `counts`: one a curve. The set itself if
// nothing changes.
Task<std::shared_ptr<const CurveSet>> begin_at_corners(Pace& pace, std::shared_ptr<const CurveSet> set,
                                                       std::span<const CornerCount> counts);

// Fills in the pieces, which are as many as counted. `scales`: one a point, see StepScale; null: 1.
Task<void> split_at_corners(Pace& pace, CurveView curve, const float* scales, double corner_angle,
                            std::span<CurvePiece> pieces);

}  // namespace flg
