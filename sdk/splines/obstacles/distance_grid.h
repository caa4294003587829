// SPDX-License-Identifier: MIT
// The zero level of a function that is sampled on a regular grid, such as a signed distance: by cubic B-splines along
// each axis, whose coefficients are chosen so that they pass through the samples (Unser: Splines, a perfect fit for
// signal and image processing, 1999). Two continuous derivatives; the third ones jump from cell to cell. At the ends of
// the grid second derivatives across them are 0, so that what is linear comes out exactly.
#pragma once

#include <array>

#include "runtime/each.h"
#include "splines/manifolds/hypersurface.h"

namespace flg {

struct GridInput {
    std::array<uint32_t, 3> counts{};  // of samples along x, y, z: 2 to 65536
    std::array<double, 3> origin{};    // metres: where the first sample is
    double spacing = 1;                // metres, > 0: from a sample to the next
    const float* values = nullptr;     // x runs fastest, then y; finite; positive outside
};

// Not defined outside of the box of the samples.
class DistanceGrid final : public Hypersurface {
public:
    // Coefficients from interpolate(), instead of values.
    DistanceGrid(const GridInput& input, Buffer<float> coefficients);

    // 0.4 us.
    bool evaluate(const double* x, double*, double* value, double* gradient, double* second) const override;
    // As Hypersurface, but places outside of the box are first moved to its nearest point, and steps end at its sides.
    bool project(double* x, double* hint) const override;

    // The box of the samples, metres.
    double low(uint32_t axis) const { return origin_[axis]; }
    double extent(uint32_t axis) const { return spacing_ * (counts_[axis] - 1.0); }

private:
    struct Axis;
    bool locate(double at, uint32_t axis, Axis& result) const;

    std::array<uint32_t, 3> counts_;
    std::array<double, 3> origin_;
    double spacing_;
    Buffer<float> coefficients_;
};

// Through the values, which outlive the task. A Failure says so if there are fewer than 2 samples along an axis or more
// than 2^31 in all, or if all values have the same sign. About 20 ns a sample.
Task<DistanceGrid> interpolate(Pace& pace, GridInput input);

}  // namespace flg
