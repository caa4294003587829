// SPDX-License-Identifier: MIT
// Sorting of arrays that are too large for std::sort within a slice.
#pragma once

#include <algorithm>
#include <span>

#include "runtime/each.h"

namespace flg {

// Items that compare equal keep their order. A comparison takes tens of nanoseconds at most. `scratch` is as large.
template <class T, class Less>
Task<void> merge_sort(Pace& pace, std::span<T> items, std::span<T> scratch, Less less) {
    constexpr uint32_t shortest = 16;
    const auto count = static_cast<uint32_t>(items.size());
    T *from = items.data(), *to = scratch.data();
    co_await each(pace, (count + shortest - 1) / shortest, Cost::microseconds, [=](uint32_t i) {
        const uint32_t begin = i * shortest, end = std::min(count, begin + shortest);
        for (uint32_t next = begin + 1; next < end; ++next) {
            T* const place = std::upper_bound(from + begin, from + next, from[next], less);
            std::rotate(place, from + next, from + next + 1);
        }
    });
    for (uint64_t width = shortest; width < count; width *= 2) {
        uint32_t left = 0, right = 0, left_end = 0, end = 0;
        co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            if (i == end) {
                left = end;
                right = left_end = static_cast<uint32_t>(std::min<uint64_t>(count, left + width));
                end = static_cast<uint32_t>(std::min<uint64_t>(count, left + 2 * width));
            }
            const bool takes_right = left == left_end || (right < end && less(from[right], from[left]));
            to[i] = from[takes_right ? right++ : left++];
        });
        std::swap(from, to);
    }
    if (from != items.data()) co_await each(pace, count, Cost::some_ns, [=](uint32_t i) { to[i] = from[i]; });
}

}  // namespace flg
