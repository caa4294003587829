// SPDX-License-Identifier: MIT
// Resampling and moving frames, the slow and plain way: every quantity stored, arc length by fine sums, its inverse by
// bisection, frames by parallel transport in tiny steps. Oracle of sdk/curves.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace flg::literal {

using Vec3 = Eigen::Vector3d;

struct FramedPoint {
    Vec3 position;
    Vec3 tangent;
    Vec3 normal;
};

// The normal at u1 that parallel transport makes of `normal` at u0, along a curve with this unit tangent.
Vec3 transport(const std::function<Vec3(double)>& tangent, double u0, double u1, int steps, Vec3 normal);

// The smooth curve of sdk/curves/segment_stream.h through the points, at steps + 1 points (of a closed curve the first
// is repeated) even in arc length, with a rotation-minimizing frame that begins with `first_normal` made perpendicular.
// No twist correction.
std::vector<FramedPoint> resample(const std::vector<Vec3>& points, bool closed, int steps, const Vec3& first_normal);

// An open polyline itself, at steps + 1 points even in arc length: what the paper begins with, and the baseline of the
// benchmarks. Tangents are central differences, frames are transported from sample to sample.
std::vector<FramedPoint> resample_polyline(const std::vector<Vec3>& points, int steps, const Vec3& first_normal);

// Length of the smooth curve.
double curve_length(const std::vector<Vec3>& points, bool closed);

}  // namespace flg::literal
