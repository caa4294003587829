// SPDX-License-Identifier: MIT
// Triangles in texture coordinates, by the bands of rows that they lie in: bands are drawn by themselves, side by side.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "runtime/each.h"

namespace flg {

// Corners in texels from the map's upper left corner.
using TexelTriangle = std::array<std::array<float, 2>, 3>;

struct Bands {
    explicit Bands(uint32_t of_size)
        : size(of_size), height(std::max(1u, texels / of_size)), count((of_size + height - 1) / height) {}

    // Of a triangle, by the rows whose middles it may hold; last < first: none.
    struct Range {
        uint32_t first = 1, last = 0;
    };
    Range of(const TexelTriangle& triangle) const {
        const auto [low, high] = std::minmax({triangle[0][1], triangle[1][1], triangle[2][1]});
        const auto begin = static_cast<int32_t>(std::floor(low - 1)), end = static_cast<int32_t>(std::ceil(high + 1));
        const int32_t last_row = static_cast<int32_t>(size) - 1;
        return {static_cast<uint32_t>(std::clamp(begin, 0, last_row)) / height,
                static_cast<uint32_t>(std::clamp(end, 0, last_row)) / height};
    }
    uint32_t first_row(uint32_t band) const { return band * height; }
    uint32_t end_row(uint32_t band) const { return std::min(size, (band + 1) * height); }

    // Of a band: a quarter of a megabyte of owners, which a core's cache holds.
    static constexpr uint32_t texels = 1u << 16;

    uint32_t size, height, count;
};

// Triangles [0, count) by band, those of one band rising; range_of(t) is a Bands::Range.
template <class RangeOf>
Task<Groups> group_by_band(Pace& pace, uint32_t count, uint32_t bands, RangeOf range_of) {
    Groups groups;
    groups.offsets = Buffer<uint32_t>(size_t{bands} + 2, pace.memory());
    uint32_t* const offsets = groups.offsets.data();
    co_await each(pace, size_t{bands} + 2, Cost::some_ns, [=](uint32_t b) { offsets[b] = 0; });
    co_await each_by_work(pace, count, Cost::tens_of_ns, [=](uint32_t t) {
        const Bands::Range range = range_of(t);
        for (uint32_t b = range.first; b <= range.last; ++b) ++offsets[b + 2];
        return 1 + (range.last + 1 - range.first) / 8;
    });
    co_await each(pace, bands, Cost::some_ns, [=](uint32_t b) { offsets[b + 2] += offsets[b + 1]; });
    groups.items = Buffer<uint32_t>(offsets[bands + 1], pace.memory());
    uint32_t* const items = groups.items.data();
    co_await each_by_work(pace, count, Cost::tens_of_ns, [=](uint32_t t) {
        const Bands::Range range = range_of(t);
        for (uint32_t b = range.first; b <= range.last; ++b) items[offsets[b + 1]++] = t;
        return 1 + (range.last + 1 - range.first) / 8;
    });
    co_return groups;
}

}  // namespace flg
