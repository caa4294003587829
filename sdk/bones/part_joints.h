// SPDX-License-Identifier: MIT
// Which samples of each branch of each part become joints.
//
// - BoundedDP (bounded_dp.h), with the part's threshold.
// - For people, unless `detail` is 0: a bone that is long for its width is divided, a finger's once, an arm of an
//   octopus more often; where the outline narrows or bends most near the even places, as at an elbow. Limbs of about
//   the same length and width get the same number of joints, unless one is folded and the other straight. A limb that
//   begins in a trunk and is straight beyond has a knee if it is longer than wide there.
// - Of a branch and its mirror image in one contour the same samples become joints.
#pragma once

#include <span>
#include <vector>

#include "bones/model.h"
#include "runtime/task.h"

namespace flg {

struct PartJoints {
    explicit PartJoints(Memory* memory) : first_branch(memory), samples(memory) {}

    // Of a branch of a part, the first and the last sample among them.
    std::span<const uint32_t> of(uint32_t part, size_t branch) const { return samples[first_branch[part] + branch]; }

    std::pmr::vector<uint32_t> first_branch;  // by part
    std::pmr::vector<std::pmr::vector<uint32_t>> samples;
};

Task<PartJoints> choose_joints(Pace& pace, const HeldModel& model);

}  // namespace flg
