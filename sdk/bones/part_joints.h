// SPDX-License-Identifier: MIT
// Which samples of each branch of each part become joints.
//
// - BoundedDP (bounded_dp.h), with the part's threshold.
// - For people, unless `detail` is 0: a bone that is long for its width is divided, a finger's once, an arm of an
//   octopus more often; where the outline narrows or bends most near the even places, as at an elbow. Limbs of about
//   the same length and width get the same number of joints. A limb's last bone is divided where it is longer than
//   wide, for a knee. Where branches run side by side in a trunk they become one (shared_trunks.h).
// - Of a branch and its mirror image in one contour the same samples become joints.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "bones/model.h"
#include "bones/shared_trunks.h"
#include "runtime/task.h"

namespace flg {

struct PartJoints {
    explicit PartJoints(Memory* memory) : first_branch(memory), samples(memory), trunks(memory), trunk_at(memory) {}

    // Of a branch of a part: from its beginning to its end, or from and to where a trunk of two branches ends.
    std::span<const uint32_t> of(uint32_t part, size_t branch) const { return samples[first_branch[part] + branch]; }
    // The trunk that a branch hangs on where it begins (0) or ends (1), a number of `trunks`; no_number: none.
    uint32_t trunk_of(uint32_t part, size_t branch, uint32_t end) const {
        return trunk_at[first_branch[part] + branch][end];
    }

    std::pmr::vector<uint32_t> first_branch;  // by part
    std::pmr::vector<std::pmr::vector<uint32_t>> samples;
    std::pmr::vector<SharedTrunk> trunks;  // of all parts
    std::pmr::vector<std::array<uint32_t, 2>> trunk_at;
};

Task<PartJoints> choose_joints(Pace& pace, const HeldModel& model);

}  // namespace flg
