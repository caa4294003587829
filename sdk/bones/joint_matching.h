// SPDX-License-Identifier: MIT
// Which joints of two drawings of one part are the same, where limbs turned, grew or bent in between and some have more
// joints than before.
//
// 1. Anchors: two of a kind are each other's nearest, and no other of it is less than twice as far. First forks; then,
//    after step 2, ends; then, after step 2 again, joints between.
// 2. From joint to joint that are known to be the same, over the limbs that leave them: all turned by one angle, each
//    is the one that points its way and is about as long. Along a limb joints are the same by their share of its
//    length, and so are its ends, from where it goes on.
// 3. What is left: each other's nearest, if near.
#pragma once

#include <span>

#include "core/memory.h"
#include "runtime/task.h"
#include "skeletons/point2.h"

namespace flg {

inline constexpr uint32_t no_joint_before = UINT32_MAX;

// Of a tree of joints, those before come first.
struct DrawnJoint {
    Point2 at;
    uint32_t before;  // the one that it comes after along the part; no_joint_before: the first
};

// By joint of `now` the one of `then` that it is; no_joint_before: none. No two are the same one. Steps 1 and 3 take
// about 2 ns a pair of joints. `near`: so far may they be apart.
Task<Buffer<uint32_t>> match_joints(Pace& pace, std::span<const DrawnJoint> now, std::span<const DrawnJoint> then,
                                    double near);

}  // namespace flg
