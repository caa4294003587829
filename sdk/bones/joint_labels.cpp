// SPDX-License-Identifier: MIT
#include "bones/joint_labels.h"

#include <algorithm>
#include <cstdint>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr uint32_t no_own = UINT32_MAX;

struct Best {
    double distance;
    uint32_t joint = no_own;
};

Best nearest(const Point2& at, std::span<const OwnJoint> joints, uint32_t begin, uint32_t end, Best best) {
    for (uint32_t i = begin; i < end; ++i) {
        const double d = distance(at, joints[i].at);
        if (d < best.distance) best = {d, i};
    }
    return best;
}

// By joint of `from` its nearest of `to`, if that is near.
Task<Buffer<uint32_t>> nearest_of(Pace& pace, std::span<const OwnJoint> from, std::span<const OwnJoint> to,
                                  double near) {
    Buffer<uint32_t> out(from.size(), pace.memory());
    Slice slice(Cost::some_ns);
    for (size_t i = 0; i < from.size(); ++i) {
        Best best{near};
        for (Portion part(slice, 0, static_cast<uint32_t>(to.size())); part.next();) {
            best = nearest(from[i].at, to, part.begin, part.end, best);
            if (part.is_over()) co_await pace;
        }
        out[i] = best.joint;
        if (slice.is_over()) co_await pace;
    }
    co_return out;
}

}  // namespace

Task<void> number_joints(Pace& pace, OwnJoints own) {
    const std::span<OwnJoint> joints = own.joints;
    const std::span<const OwnJoint> before = own.before;
    co_await each(pace, joints.size(), Cost::some_ns, [&](uint32_t i) { joints[i].number = no_own; });
    uint32_t largest = static_cast<uint32_t>(joints.size());
    for (const OwnJoint& joint : before) largest = std::max(largest, joint.number);
    const size_t numbers = static_cast<size_t>(largest) + joints.size() + 1;
    Buffer<uint8_t> taken(numbers, pace.memory());
    co_await each(pace, numbers, Cost::some_ns, [&](uint32_t n) { taken[n] = 0; });
    const bool is_same = std::equal(joints.begin(), joints.end(), before.begin(), before.end(),
                                    [](const OwnJoint& a, const OwnJoint& b) { return a.at == b.at; });
    if (is_same) {
        co_await each(pace, joints.size(), Cost::some_ns, [&](uint32_t i) { joints[i].number = before[i].number; });
        co_return;
    }
    co_await each(pace, before.size(), Cost::some_ns, [&](uint32_t i) { taken[before[i].number] = 1; });
    const Buffer<uint32_t> old_of = co_await nearest_of(pace, joints, before, own.near);
    const Buffer<uint32_t> new_of = co_await nearest_of(pace, before, joints, own.near);
    co_await each(pace, joints.size(), Cost::some_ns, [&](uint32_t i) {
        if (old_of[i] != no_own && new_of[old_of[i]] == i) joints[i].number = before[old_of[i]].number;
    });
    uint32_t free = 0;
    co_await each(pace, joints.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (joints[i].number != no_own) return;
        uint32_t number = i;
        if (taken[number] != 0) {
            while (taken[free] != 0) ++free;
            number = free;
        }
        joints[i].number = number;
        taken[number] = 1;
    });
}

}  // namespace flg
