// SPDX-License-Identifier: MIT
#include "runtime/each.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "core/random.h"
#include "runtime/run_now.h"

namespace flg::test {
namespace {

Memory* memory() {
    return std::pmr::new_delete_resource();
}

// How often a task pauses if it may each time.
template <class Make>
uint32_t pauses(const Make& make) {
    uint32_t slices = 0;
    run_haltingly(memory(), make, [&](const auto& slice) {
        ++slices;
        slice();
    });
    return slices - 1;
}

TEST(Each, TakesEachStepOnceAndInOrder) {
    for (const uint32_t count : {0u, 1u, 8u, 9u, 5000u}) {
        std::vector<uint32_t> seen;
        run_haltingly(memory(), [&](Pace& pace) {
            return each(pace, count, Cost::microseconds, [&](uint32_t i) { seen.push_back(i); });
        });
        std::vector<uint32_t> expected(count);
        std::iota(expected.begin(), expected.end(), 0u);
        EXPECT_EQ(seen, expected);
    }
}

TEST(Each, ARangeBeginsWhereItSays) {
    std::vector<uint32_t> seen;
    run_now(memory(),
            [&](Pace& pace) { return each(pace, 3u, 6u, Cost::microseconds, [&](uint32_t i) { seen.push_back(i); }); });
    EXPECT_EQ(seen, (std::vector<uint32_t>{3, 4, 5}));
}

TEST(Each, PausesByTheCostOfAStep) {
    const auto of = [](Cost cost) {
        return pauses([=](Pace& pace) { return each(pace, 4096, cost, [](uint32_t) {}); });
    };
    EXPECT_EQ(of(Cost::some_ns), 2u);
    EXPECT_EQ(of(Cost::tens_of_ns), 16u);
    EXPECT_EQ(of(Cost::microseconds), 512u);
}

TEST(Each, ByWorkASliceEndsWhenItIsFull) {
    std::vector<uint32_t> seen;
    const uint32_t paused = pauses([&](Pace& pace) {
        return each_by_work(pace, 10, Cost::microseconds, [&](uint32_t i) {
            seen.push_back(i);
            return 4u;
        });
    });
    EXPECT_EQ(seen.size(), 10u);
    EXPECT_EQ(paused, 5u);  // two steps a slice
}

TEST(Each, RepeatsUntilItIsOver) {
    int left = 100;
    run_haltingly(memory(), [&](Pace& pace) { return repeat(pace, Cost::hundreds_of_ns, [&] { return --left > 0; }); });
    EXPECT_EQ(left, 0);
}

TEST(Each, WhatABodyThrowsReachesTheCaller) {
    EXPECT_THROW(run_haltingly(memory(),
                               [](Pace& pace) {
                                   return each(pace, 1000, Cost::microseconds, [](uint32_t i) {
                                       if (i == 500) throw std::runtime_error("500");
                                   });
                               }),
                 std::runtime_error);
}

TEST(Slice, IsOverWhenItsStepsAreDone) {
    Slice slice(Cost::microseconds);
    EXPECT_FALSE(slice.is_over(7));
    EXPECT_EQ(slice.left(), 1u);
    EXPECT_TRUE(slice.is_over());
    EXPECT_EQ(slice.left(), 8u);
    EXPECT_TRUE(slice.is_over(20));
}

TEST(Portion, PortionsFillSlicesAndMakeUpTheRange) {
    Slice slice(Cost::microseconds);
    std::vector<std::pair<uint32_t, uint32_t>> portions;
    uint32_t slices = 0;
    for (const uint32_t end : {3u, 3u, 12u, 30u}) {
        for (Portion part(slice, 3, end); part.next();) {
            portions.emplace_back(part.begin, part.end);
            slices += part.is_over();
        }
    }
    const std::vector<std::pair<uint32_t, uint32_t>> expected = {{3, 11},  {11, 12}, {3, 10},
                                                                 {10, 18}, {18, 26}, {26, 30}};
    EXPECT_EQ(portions, expected);
    EXPECT_EQ(slices, 4u);
}

TEST(GroupBy, AgreesWithAStableSort) {
    constexpr uint32_t count = 5000, keys = 70;
    std::vector<uint32_t> key(count);
    for (uint32_t i = 0; i < count; ++i) {
        const auto drawn = static_cast<uint32_t>(random_unit(1, i, 0) * (keys + 5));
        key[i] = drawn < keys ? drawn : no_key;
    }
    const Groups groups = run_haltingly(
        memory(), [&](Pace& pace) { return group_by(pace, count, keys, [&](uint32_t i) { return key[i]; }); });
    std::vector<uint32_t> expected;
    for (uint32_t i = 0; i < count; ++i)
        if (key[i] != no_key) expected.push_back(i);
    std::sort(expected.begin(), expected.end(),
              [&](uint32_t a, uint32_t b) { return key[a] != key[b] ? key[a] < key[b] : a < b; });
    std::vector<uint32_t> found;
    for (uint32_t k = 0; k < keys; ++k) {
        for (const uint32_t item : groups.of(k)) {
            EXPECT_EQ(key[item], k);
            found.push_back(item);
        }
    }
    EXPECT_EQ(found, expected);
    EXPECT_EQ(groups.count(), expected.size());
}

TEST(GroupBy, NothingHasNoGroups) {
    const Groups groups =
        run_now(memory(), [](Pace& pace) { return group_by(pace, 0, 0, [](uint32_t) { return 0u; }); });
    EXPECT_EQ(groups.count(), 0u);
}

}  // namespace
}  // namespace flg::test
