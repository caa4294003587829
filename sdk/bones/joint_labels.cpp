// SPDX-License-Identifier: MIT
#include "bones/joint_labels.h"

#include <algorithm>
#include <cstdint>

#include "core/memory.h"
#include "runtime/each.h"

namespace flg {

Task<void> number_joints(Pace& pace, std::span<const DrawnJoint> joints, EarlierJoints before, double near,
                         std::span<uint32_t> numbers) {
    const auto count = static_cast<uint32_t>(joints.size());
    uint32_t largest = count;
    for (const uint32_t number : before.numbers) largest = std::max(largest, number);
    for (const uint32_t number : before.awaited) largest = std::max(largest, number);
    const size_t number_count = static_cast<size_t>(largest) + 2 * size_t{count} + 1;
    Buffer<uint8_t> taken(number_count, pace.memory()), awaited(number_count, pace.memory());
    co_await each(pace, number_count, Cost::some_ns, [&](uint32_t n) { taken[n] = awaited[n] = 0; });
    co_await each(pace, before.awaited.size(), Cost::some_ns, [&](uint32_t i) { awaited[before.awaited[i]] = 1; });
    const bool is_same = std::equal(joints.begin(), joints.end(), before.joints.begin(), before.joints.end(),
                                    [](const DrawnJoint& a, const DrawnJoint& b) { return a.at == b.at; });
    if (is_same) {
        co_await each(pace, count, Cost::some_ns, [&](uint32_t i) { numbers[i] = before.numbers[i]; });
        co_return;
    }
    co_await each(pace, before.numbers.size(), Cost::some_ns, [&](uint32_t i) { taken[before.numbers[i]] = 1; });
    const Buffer<uint32_t> same = co_await match_joints(pace, joints, before.joints, near);
    uint32_t free = 0;
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        if (same[i] != no_joint_before) {
            numbers[i] = before.numbers[same[i]];
            return;
        }
        uint32_t number = i;
        if (taken[number] != 0) {
            while (taken[free] != 0 || awaited[free] != 0) ++free;
            number = free;
        }
        numbers[i] = number;
        taken[number] = 1;
    });
}

}  // namespace flg
