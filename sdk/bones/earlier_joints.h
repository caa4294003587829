// SPDX-License-Identifier: MIT
// The joints that parts had in the model before this one: in a model that is still there, or in what a file kept of it.
// A kept joint is a part's own if its key is the part's name with a number. Those that refinement took away are not
// known any more.
#pragma once

#include <string>
#include <unordered_map>

#include "bones/joint_labels.h"
#include "bones/model.h"
#include "runtime/task.h"

namespace flg {

class EarlierParts {
public:
    explicit EarlierParts(Memory* memory) : parts_(memory), joints_(memory), numbers_(memory), awaited_(memory) {}

    // What `model` has of them outlives this.
    static Task<EarlierParts> find(Pace& pace, const HeldModel& model);

    // None: the part is new.
    EarlierJoints of(const ModelPart& part) const;

private:
    static Task<void> read_kept(Pace& pace, const HeldModel& model, EarlierParts& out);
    static Task<void> read_edits(Pace& pace, const HeldModel& model, EarlierParts& out);

    std::pmr::unordered_map<std::pmr::string, EarlierJoints> parts_;  // by name and side
    std::pmr::vector<DrawnJoint> joints_;                             // of kept ones, part by part
    std::pmr::vector<uint32_t> numbers_;
    std::pmr::unordered_map<std::pmr::string, std::pmr::vector<uint32_t>> awaited_;  // by name and side
};

}  // namespace flg
