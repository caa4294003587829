// SPDX-License-Identifier: MIT
// Who a joint is: a key that survives edits of the drawing. A part's own joints are numbered along it, alone, from
// where it hangs: what else the model has and where parts meet does not change that. Other joints are told by what they
// are for: where another part hangs, or the middle of the trunk.
//
// Where there is a model from before, the own joints of a part of the same name keep their numbers: two joints are the
// same if in the drawing each is the other's nearest, and near. Numbers of joints that are gone are not given again at
// once.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/memory.h"
#include "runtime/task.h"
#include "skeletons/point2.h"

namespace flg {

// One of a part's own joints as it was made, before parts were connected.
struct OwnJoint {
    Point2 at;  // in the drawing
    uint32_t number;
};

// Of one part, in the order along it: the numbers of `joints` are set.
struct OwnJoints {
    std::span<OwnJoint> joints;
    std::span<const OwnJoint> before;  // in the model before; none: a new part
    double near;                       // in the drawing's unit: farther joints are others
};

Task<void> number_joints(Pace& pace, OwnJoints own);

}  // namespace flg
