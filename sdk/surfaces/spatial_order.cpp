// SPDX-License-Identifier: MIT
#include "surfaces/spatial_order.h"

#include <algorithm>
#include <limits>

namespace flg {

namespace {

constexpr uint32_t digit_bits = 10;
constexpr uint32_t digit_mask = (1u << digit_bits) - 1;

// Bit i of x < 1024 becomes bit 3 i.
uint32_t spread_bits(uint32_t x) {
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

}  // namespace

SpatialOrderKernel::SpatialOrderKernel(const GrowingBuffer<Position>& positions, Memory* memory)
    : positions_(positions), keys_(positions.size(), memory), sorted_(positions.size(), memory) {
    low_.fill(std::numeric_limits<float>::max());
    high_.fill(std::numeric_limits<float>::lowest());
    if (positions.size() == 0) pass_ = Pass::done;
}

void SpatialOrderKernel::extend_bounds(uint32_t vertex) {
    for (uint32_t axis = 0; axis < 3; ++axis) {
        low_[axis] = std::min(low_[axis], positions_[vertex][axis]);
        high_[axis] = std::max(high_[axis], positions_[vertex][axis]);
    }
}

void SpatialOrderKernel::begin_keys() {
    double side = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) side = std::max(side, double{high_[axis]} - low_[axis]);
    cells_per_metre_ = side > 0 ? digit_mask / side : 0;
}

void SpatialOrderKernel::make_key(uint32_t vertex) {
    uint32_t code = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) {
        const double cell = (double{positions_[vertex][axis]} - low_[axis]) * cells_per_metre_;
        code |= spread_bits(static_cast<uint32_t>(cell)) << axis;
    }
    keys_[vertex] = {code, vertex};
    for (uint32_t digit = 0; digit < 3; ++digit) ++starts_[digit][code >> digit * digit_bits & digit_mask];
}

void SpatialOrderKernel::begin_sort() {
    for (auto& counts : starts_) {
        uint32_t start = 0;
        for (uint32_t& count : counts) start += std::exchange(count, start);
    }
}

void SpatialOrderKernel::sort(uint32_t digit, uint32_t i) {
    const Key key = (digit == 1 ? sorted_ : keys_)[i];
    Buffer<Key>& to = digit == 1 ? keys_ : sorted_;
    to[starts_[digit][key.code >> digit * digit_bits & digit_mask]++] = key;
}

bool SpatialOrderKernel::run(uint32_t count) {
    const uint32_t vertices = static_cast<uint32_t>(positions_.size());
    for (; count > 0 && pass_ != Pass::done; --count) {
        const uint32_t i = at_++;
        switch (pass_) {
            case Pass::bounds: extend_bounds(i); break;
            case Pass::keys: make_key(i); break;
            case Pass::sort_low: sort(0, i); break;
            case Pass::sort_middle: sort(1, i); break;
            case Pass::sort_high: sort(2, i); break;
            case Pass::done: break;
        }
        if (at_ < vertices) continue;
        if (pass_ == Pass::bounds) begin_keys();
        if (pass_ == Pass::keys) begin_sort();
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return pass_ == Pass::done;
}

}  // namespace flg
