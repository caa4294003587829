// SPDX-License-Identifier: MIT
// Where joints are, and how far apart two of them move a point.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "inflation/bone_weights.h"
#include "runtime/each.h"

namespace flg {

class Pivots {
public:
    static Task<Pivots> make(Pace& pace, const BoneRig& rig) {
        auto count = static_cast<uint32_t>(rig.joint_parents.size());
        co_await each(pace, rig.bones.size(), Cost::some_ns,
                      [&](uint32_t bone) { count = std::max(count, rig.bones[bone].joint + 1); });
        Pivots pivots(rig.joint_parents, count, pace.memory());
        co_await each(pace, count, Cost::some_ns,
                      [&](uint32_t joint) { std::construct_at(&pivots.at_[joint], Vec3::Zero()); });
        co_await each(pace, rig.bones.size(), Cost::some_ns,
                      [&](uint32_t bone) { pivots.at_[rig.bones[bone].joint] = rig.bones[bone].from; });
        co_return pivots;
    }

    struct Between {
        double farthest = 0;  // from a point
        uint32_t count = 0;
    };
    // The joints that move one bone and not another, of the bones that turn with two joints.
    Between between(uint32_t a, uint32_t b, const Vec3& from) const {
        double squared = 0;
        uint32_t count = 0;
        for (; a != b; ++count) {
            uint32_t& lower = a == no_joint || (b != no_joint && b > a) ? b : a;
            squared = std::max(squared, (from - at_[lower]).squaredNorm());
            lower = lower < parents_.size() ? parents_[lower] : no_joint;
        }
        return {std::sqrt(squared), count};
    }

private:
    Pivots(std::span<const uint32_t> parents, uint32_t count, Memory* memory) : parents_(parents), at_(count, memory) {}

    std::span<const uint32_t> parents_;
    Buffer<Vec3> at_;
};

}  // namespace flg
