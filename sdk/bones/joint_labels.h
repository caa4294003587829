// SPDX-License-Identifier: MIT
// Who a joint is: a key that survives edits of the drawing. A part's own joints are numbered along it, alone, from
// where it hangs: what else the model has and where parts meet does not change that. Other joints are told by what they
// are for: where another part hangs, or the middle of the trunk.
//
// Where there is a model from before, the own joints of a part of the same name keep their numbers (joint_matching.h).
// Numbers of joints that are gone are not given again at once, and those that edits wait for only to the joint at that
// place along the part.
#pragma once

#include <span>

#include "bones/joint_matching.h"

namespace flg {

// Of one part, as its joints were made, before parts were connected; in the order along it.
struct EarlierJoints {
    std::span<const DrawnJoint> joints;  // none: a new part
    std::span<const uint32_t> numbers;
    std::span<const uint32_t> awaited;  // numbers that edits know joints by
};

// Sets the numbers of `joints`. `near`: in the drawing's unit; farther joints are others.
Task<void> number_joints(Pace& pace, std::span<const DrawnJoint> joints, EarlierJoints before, double near,
                         std::span<uint32_t> numbers);

}  // namespace flg
