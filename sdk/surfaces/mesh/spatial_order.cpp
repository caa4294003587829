// SPDX-License-Identifier: MIT
#include "surfaces/mesh/spatial_order.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "runtime/each.h"

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

Task<SpatialOrder> spatial_order(Pace& pace, const GrowingBuffer<Position>& positions) {
    using Key = SpatialOrder::Key;
    const size_t count = positions.size();
    Buffer<Key> keys(count, pace.memory()), sorted(count, pace.memory());
    Position low, high;
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t vertex) {
        for (uint32_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], positions[vertex][axis]);
            high[axis] = std::max(high[axis], positions[vertex][axis]);
        }
    });
    double side = 0;
    for (uint32_t axis = 0; axis < 3; ++axis) side = std::max(side, double{high[axis]} - low[axis]);
    const double cells_per_metre = side > 0 ? digit_mask / side : 0;

    std::array<std::array<uint32_t, 1u << digit_bits>, 3> starts{};  // of each digit's values; counts at first
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t vertex) {
        uint32_t code = 0;
        for (uint32_t axis = 0; axis < 3; ++axis) {
            const double cell = (double{positions[vertex][axis]} - low[axis]) * cells_per_metre;
            code |= spread_bits(static_cast<uint32_t>(cell)) << axis;
        }
        keys[vertex] = {code, vertex};
        for (uint32_t digit = 0; digit < 3; ++digit) ++starts[digit][code >> digit * digit_bits & digit_mask];
    });
    for (auto& counts : starts) {
        uint32_t start = 0;
        for (uint32_t& of_value : counts) start += std::exchange(of_value, start);
    }
    // The lowest digit first.
    for (uint32_t digit = 0; digit < 3; ++digit) {
        const Key* const from = (digit == 1 ? sorted : keys).data();
        Key* const to = (digit == 1 ? keys : sorted).data();
        uint32_t* const place = starts[digit].data();
        co_await each(pace, count, Cost::tens_of_ns,
                      [=](uint32_t i) { to[place[from[i].code >> digit * digit_bits & digit_mask]++] = from[i]; });
    }
    SpatialOrder order{std::move(sorted)};
    co_return order;
}

}  // namespace flg
