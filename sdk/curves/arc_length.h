// SPDX-License-Identifier: MIT
// First pass over a curve: its length, and what the initial normal of a moving frame is chosen from.
#pragma once

#include "curves/segment_stream.h"
#include "runtime/task.h"

namespace flg {

// What is known of a curve after one pass.
struct CurveMeasure {
    double length = 0;             // 0: all points are one
    double extent = 0;             // largest coordinate in size, which says how coarse the float coordinates are
    Vec3 tangent = Vec3::UnitX();  // at the start
    Vec3 mean = Vec3::Zero();      // mean deviation from the first point
    Vec3 farthest = Vec3::Zero();  // largest deviation from the line along the first tangent, across it

    // How far rounding to float may have moved the points.
    double resolution() const;
    // Unit, across the first tangent. Depends on the curve's shape alone, so that a moved curve carries its frames
    // along: towards the curve's mean; where that lies on the first tangent, towards the farthest deviation from it;
    // of a straight curve, towards the world axis least aligned with it (the one exception).
    Vec3 initial_normal() const;
};

// The number of equal steps nearest to `spacing` that `length` is divided into: at least 1, closed 3. 0 without length.
// As a double, since it may be beyond any integer; at most 2^53.
double even_step_count(double length, double spacing, bool closed);
// The number of steps of exactly `step` that there is room for; 0 if there is for none.
double exact_step_count(double length, double step);

// About 25 ns a point. The curve outlives the task.
Task<CurveMeasure> measure_curve(Pace& pace, CurveView curve);
// The length in steps, each one metre times `scales`, which has a value above 0 for each point (see StepScale).
Task<double> measure_steps(Pace& pace, CurveView curve, const float* scales);

}  // namespace flg
