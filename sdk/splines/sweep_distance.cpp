// SPDX-License-Identifier: MIT
#include "splines/sweep_distance.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr uint32_t batch = 32;
constexpr double infinite = std::numeric_limits<double>::infinity();
// Of the spacing: smaller changes are not followed up.
constexpr double least_change = 1e-9;

}  // namespace

std::array<uint32_t, 3> SweepGrid::nearest(const double* x) const {
    std::array<uint32_t, 3> at{};
    for (uint32_t k = 0; k < dimension; ++k) {
        const double t = std::floor((x[k] - origin[k]) / spacing + 0.5);
        at[k] = static_cast<uint32_t>(std::clamp(t, 0.0, counts[k] - 1.0));
    }
    return at;
}

SweepDistance::SweepDistance(const SweepGrid& grid, const uint8_t* flags, Memory* memory)
    : grid_(grid), flags_(flags), values_(grid.size(), memory) {}

void SweepDistance::begin(std::span<const Seed> seeds) {
    seeds_ = seeds;
    pass_ = Pass::clear;
    at_ = order_ = idle_ = 0;
}

bool SweepDistance::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        if (pass_ == Pass::sweep) {
            sweep_some();
            continue;
        }
        const bool clears = pass_ == Pass::clear;
        const uint32_t size = clears ? grid_.size() : static_cast<uint32_t>(seeds_.size());
        for (uint32_t k = 0; k < batch && at_ < size; ++k, ++at_) {
            if (clears)
                values_[at_] = infinite;
            else
                values_[seeds_[at_].node] = std::min(values_[seeds_[at_].node], seeds_[at_].value);
        }
        if (at_ < size) continue;
        at_ = 0;
        pass_ = clears ? Pass::seed : Pass::sweep;
        if (!clears) begin_sweep();
    }
    return pass_ == Pass::done;
}

void SweepDistance::begin_sweep() {
    at_ = 0;
    changed_ = false;
    for (uint32_t k = 0; k < 3; ++k) cell_[k] = (order_ >> k & 1) != 0 ? grid_.counts[k] - 1 : 0;
}

void SweepDistance::sweep_some() {
    const uint32_t size = grid_.size();
    const double change = least_change * grid_.spacing;
    for (uint32_t k = 0; k < batch && at_ < size; ++k, ++at_) {
        const uint32_t node = grid_.node(cell_);
        if ((flags_[node] & unused) == 0) {
            const double value = updated(node, cell_[0], cell_[1], cell_[2]);
            if (value < values_[node]) {
                changed_ = changed_ || values_[node] - value > change;
                values_[node] = value;
            }
        }
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const bool back = (order_ >> axis & 1) != 0;
            if (cell_[axis] != (back ? 0 : grid_.counts[axis] - 1)) {
                cell_[axis] += back ? -1u : 1u;
                break;
            }
            cell_[axis] = back ? grid_.counts[axis] - 1 : 0;
        }
    }
    if (at_ < size) return;
    const uint32_t orders = 1u << grid_.dimension;
    idle_ = changed_ ? 0 : idle_ + 1;
    if (idle_ == orders) {
        pass_ = Pass::done;
        return;
    }
    order_ = (order_ + 1) % orders;
    begin_sweep();
}

// The least u with sum over axes of max(u - a, 0)^2 = h^2, a the lesser neighbour along an axis.
double SweepDistance::updated(uint32_t node, uint32_t x, uint32_t y, uint32_t z) const {
    const uint32_t at[3] = {x, y, z};
    double a[3] = {infinite, infinite, infinite};
    uint32_t count = 0;
    for (uint32_t k = 0; k < grid_.dimension; ++k) {
        const uint32_t stride = grid_.stride(k);
        double least = infinite;
        if (at[k] > 0 && (flags_[node - stride] & closed(k)) == 0) least = values_[node - stride];
        if (at[k] + 1 < grid_.counts[k] && (flags_[node] & closed(k)) == 0) {
            least = std::min(least, values_[node + stride]);
        }
        uint32_t place = count++;
        for (; place > 0 && a[place - 1] > least; --place) a[place] = a[place - 1];
        a[place] = least;
    }
    const double h = grid_.spacing;
    double u = a[0] + h, sum = a[0], squares = a[0] * a[0];
    for (uint32_t k = 1; k < count && u > a[k]; ++k) {
        sum += a[k];
        squares += a[k] * a[k];
        const double n = k + 1;
        u = (sum + std::sqrt(std::max(sum * sum - n * (squares - h * h), 0.0))) / n;
    }
    return u;
}

}  // namespace flg
