// SPDX-License-Identifier: MIT
// Which values of a field are traced or cut.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/field.h"

namespace flg {

struct LevelRequest {
    Buffer<float> values;  // finite, rising; empty: evenly spaced ones
    uint32_t count = 0;    // of those; 0: all that the field has
    float first = 0, every = 0;
};

// Those to use, rising. Evenly spaced ones above the largest of the field's values are left out, and those below the
// smallest if the request does not say how many. Fails with FLG_ERROR_LIMIT if more than `most` are left, or values
// round to the same.
Task<Buffer<float>> list_levels(Pace& pace, const DistanceField& field, const LevelRequest& request, uint32_t most);

}  // namespace flg
