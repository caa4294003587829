// SPDX-License-Identifier: MIT
// Work over whole arrays: the one place that knows how it is sliced.
//
//     co_await each(pace, vertices, Cost::tens_of_ns, [&](uint32_t v) { area[v] /= 3; });
//
// Rules
// - Inner loops live in the body that each() gets. Nothing awaits inside them.
// - Call each() once an array, not once an element: a call allocates a frame.
// - Steps run in order, on one thread. Results don't depend on where slices end.
// - Making a large array is a slice too. Take a Buffer, which is not cleared, and fill it by each(). Give large ones
//   back one at a time.
// - Counts are below 2^32. A look at the pace takes about 25 ns, a call of each() about 60 ns. What a body throws
//   leaves the task.
#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>

#include "core/memory.h"
#include "runtime/pace.h"
#include "runtime/task.h"

namespace flg {

// What one step of a loop costs, about. The value is the number of steps between two looks at the pace: some 10 us.
enum class Cost : uint32_t { some_ns = 2048, tens_of_ns = 256, hundreds_of_ns = 32, microseconds = 8 };

namespace detail {

// Plain functions that take the body by value: what it captures lives in registers. In the frame of a coroutine the
// same loop takes 20 to 30 % longer.
template <class Body>
[[gnu::noinline]] void run_steps(Body body, uint32_t begin, uint32_t end) {
    for (uint32_t i = begin; i < end; ++i) body(i);
}

template <class Body>
[[gnu::noinline]] uint32_t run_work(Body body, uint32_t begin, uint32_t end, uint32_t work) {
    for (uint32_t done = 0; begin < end && done < work; ++begin) done += body(begin);
    return begin;
}

template <class Body>
[[gnu::noinline]] bool run_while(Body body, uint32_t steps) {
    for (; steps > 0; --steps)
        if (!body()) return false;
    return true;
}

}  // namespace detail

// body(i) for every i in [begin, end).
template <class Body>
Task<void> each(Pace& pace, uint32_t begin, uint32_t end, Cost cost, Body body) {
    for (const auto slice = static_cast<uint32_t>(cost); begin < end;) {
        const uint32_t stop = begin + std::min(end - begin, slice);
        detail::run_steps(body, begin, stop);
        begin = stop;
        co_await pace;
    }
}

// body(i) for every i in [0, count).
template <class Body>
Task<void> each(Pace& pace, size_t count, Cost cost, Body body) {
    return each(pace, 0, static_cast<uint32_t>(count), cost, body);
}

// The same where steps differ in length: body(i) returns what it did, in units that cost `cost` each. One step must
// not take more than a slice by itself.
template <class Body>
Task<void> each_by_work(Pace& pace, size_t count, Cost cost, Body body) {
    for (uint32_t i = 0; i < count;) {
        i = detail::run_work(body, i, static_cast<uint32_t>(count), static_cast<uint32_t>(cost));
        co_await pace;
    }
}

// Calls body() until it returns false.
template <class Body>
Task<void> repeat(Pace& pace, Cost cost, Body body) {
    while (detail::run_while(body, static_cast<uint32_t>(cost))) co_await pace;
}

// For the loops that a coroutine runs itself, because their length is open:
//
//     while (queue.pop()) if (slice.is_over()) co_await pace;
class Slice {
public:
    explicit Slice(Cost cost) : size_(static_cast<uint32_t>(cost)) {}
    bool is_over(uint32_t steps = 1) {
        used_ += steps;
        if (used_ < size_) return false;
        used_ = 0;
        return true;
    }
    uint32_t left() const { return size_ - used_; }

private:
    uint32_t size_, used_ = 0;
};

// What a slice has room for of [begin, end): for loops that are too short and too many for each(). The inner loop lives
// in a plain function.
//
//     for (Portion part(slice, 0, count); part.next();) {
//         add(part.begin, part.end);
//         if (part.is_over()) co_await pace;
//     }
struct Portion {
    Portion(Slice& of_slice, uint32_t from, uint32_t to) : begin(from), end(from), slice(of_slice), last(to) {}
    bool next() {
        begin = end;
        end = begin + std::min(last - begin, slice.left());
        return begin < end;
    }
    bool is_over() { return slice.is_over(end - begin); }

    uint32_t begin, end;
    Slice& slice;
    uint32_t last;
};

// Items by key, those of one key in ascending order.
struct Groups {
    std::span<const uint32_t> of(uint32_t key) const {
        return {items.data() + offsets[key], items.data() + offsets[key + 1]};
    }
    uint32_t count() const { return offsets[static_cast<uint32_t>(offsets.size()) - 2]; }

    Buffer<uint32_t> offsets;  // where each key's begin; one more for the end, and one that is not used
    Buffer<uint32_t> items;
};

inline constexpr uint32_t no_key = UINT32_MAX;

// Sorts items [0, count) by key_of(item), a key below `keys`; items of no_key are left out. Reads each key twice.
template <class KeyOf>
Task<Groups> group_by(Pace& pace, size_t count, size_t keys, KeyOf key_of) {
    Groups groups{Buffer<uint32_t>(keys + 2, pace.memory()), Buffer<uint32_t>(count, pace.memory())};
    uint32_t* const offsets = groups.offsets.data();
    uint32_t* const items = groups.items.data();
    co_await each(pace, keys + 2, Cost::some_ns, [=](uint32_t k) { offsets[k] = 0; });
    co_await each(pace, count, Cost::tens_of_ns, [=](uint32_t i) {
        if (const uint32_t key = key_of(i); key != no_key) ++offsets[key + 2];
    });
    co_await each(pace, keys, Cost::some_ns, [=](uint32_t k) { offsets[k + 2] += offsets[k + 1]; });
    // A key's begin stands one place to the right: placing its items moves it to where the next key's is.
    co_await each(pace, count, Cost::tens_of_ns, [=](uint32_t i) {
        if (const uint32_t key = key_of(i); key != no_key) items[offsets[key + 1]++] = i;
    });
    co_return groups;
}

// Items, those of lower keys first, those of one key in their order; keys are at most `largest`. A pass over all of
// them for each byte of that.
template <class T, class KeyOf>
Task<Buffer<T>> sort_by(Pace& pace, const std::pmr::deque<T>& items, uint32_t largest, KeyOf key_of) {
    Buffer<T> sorted(items.size(), pace.memory()), scratch(items.size(), pace.memory());
    co_await each(pace, items.size(), Cost::some_ns, [&](uint32_t i) { sorted[i] = items[i]; });
    for (uint32_t shift = 0; shift < 32 && largest >> shift != 0; shift += 8) {
        const Groups groups =
            co_await group_by(pace, sorted.size(), 256, [&](uint32_t i) { return key_of(sorted[i]) >> shift & 255; });
        co_await each(pace, sorted.size(), Cost::tens_of_ns, [&](uint32_t i) { scratch[i] = sorted[groups.items[i]]; });
        std::swap(sorted, scratch);
    }
    co_return sorted;
}

}  // namespace flg
