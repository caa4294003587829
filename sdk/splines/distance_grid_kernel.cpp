// SPDX-License-Identifier: MIT
// Coefficients of the B-splines through samples: c[i - 1] + 4 c[i] + c[i + 1] = 6 v[i] along each axis in turn, with c
// = v at both ends, where second derivatives are 0. Eliminated forwards, and back.
#include <algorithm>

#include "core/failure.h"
#include "splines/distance_grid.h"

namespace flg {

namespace {

// What elimination leaves of the upper diagonal in row i >= 1: from 1/4 on it converges quickly to 2 - sqrt(3).
constexpr uint32_t pivots = 16;
constexpr auto pivot_table = [] {
    std::array<double, pivots> table{};
    for (double last = 0; double& pivot : table) last = pivot = 1 / (4 - last);
    return table;
}();

double pivot(uint32_t row) {
    return pivot_table[std::min(row, pivots) - 1];
}

constexpr uint32_t most_along_an_axis = 65536;
constexpr double most_samples = 2147483648.0;

}  // namespace

DistanceGridKernel::DistanceGridKernel(const GridInput& input, Memory* memory) : input_(input) {
    double samples = 1;
    for (const uint32_t count : input.counts) {
        if (count < 2 || count > most_along_an_axis) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a grid has 2 to %u samples along each axis, not %u",
                          most_along_an_axis, count);
        }
        samples *= count;
    }
    if (samples > most_samples) throw Failure(FLG_ERROR_LIMIT, "a grid has at most 2^31 samples, not %.0f", samples);
    coefficients_ = Buffer<float>(static_cast<size_t>(samples), memory);
}

bool DistanceGridKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        if (pass_ == Pass::copy) {
            copy();
        } else {
            step(static_cast<uint32_t>(pass_) - static_cast<uint32_t>(Pass::along_x));
        }
    }
    return pass_ == Pass::done;
}

void DistanceGridKernel::copy() {
    const size_t end = std::min(at_ + lanes, coefficients_.size());
    for (; at_ < end; ++at_) {
        const float value = input_.values[at_];
        coefficients_[at_] = value;
        positive_ = positive_ || value > 0;
        negative_ = negative_ || value < 0;
    }
    if (at_ < coefficients_.size()) return;
    if (!positive_ || !negative_) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the grid's values are nowhere %s: it has no zero level",
                      positive_ ? "negative" : "positive");
    }
    pass_ = Pass::along_x;
    begin_lines();
}

void DistanceGridKernel::begin_lines() {
    index_ = 0;
    back_ = false;
}

// One step along lines that lie side by side: along y and z these are neighbours in x, along x they are neighbours in
// y.
void DistanceGridKernel::step(uint32_t axis) {
    const size_t strides[] = {1, input_.counts[0], size_t{input_.counts[0]} * input_.counts[1]};
    const uint32_t side = axis == 0 ? 1 : 0, other = axis == 2 ? 1 : 2;
    const uint32_t count = input_.counts[axis], width = std::min(lanes, input_.counts[side] - first_[0]);
    float* samples = &coefficients_[first_[0] * strides[side] + first_[1] * strides[other] + index_ * strides[axis]];
    const size_t stride = strides[side];
    if (!back_) {
        if (index_ == 0 || index_ + 1 == count) {
            for (uint32_t lane = 0; lane < width; ++lane) carried_[lane] = samples[lane * stride];
        } else {
            const double share = pivot(index_);
            for (uint32_t lane = 0; lane < width; ++lane) {
                carried_[lane] = (6.0 * samples[lane * stride] - carried_[lane]) * share;
                samples[lane * stride] = static_cast<float>(carried_[lane]);
            }
        }
        back_ = index_ + 1 == count;
        index_ = back_ ? index_ - 1 : index_ + 1;
    } else if (index_ > 0) {
        const double share = pivot(index_);
        for (uint32_t lane = 0; lane < width; ++lane) {
            carried_[lane] = samples[lane * stride] - share * carried_[lane];
            samples[lane * stride] = static_cast<float>(carried_[lane]);
        }
        --index_;
    }
    if (!back_ || index_ > 0) return;
    begin_lines();
    first_[0] += lanes;
    if (first_[0] < input_.counts[side]) return;
    first_[0] = 0;
    if (++first_[1] < input_.counts[other]) return;
    first_[1] = 0;
    pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
}

}  // namespace flg
