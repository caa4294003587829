// SPDX-License-Identifier: MIT
// A history made again: on the mesh it is of, to the bit; or on another mesh of its shape, where points, borders and
// regions are found by where they were.
#pragma once

#include <array>

#include "tangles/tangle_jobs.h"

namespace flg {

struct ReplayStep {
    explicit ReplayStep(StepRecords of_step) : records(std::move(of_step)) {}

    // With anchors and places as far as they are known. Names of wanted regions are of steps by their place in the
    // history.
    StepRecords records;
    StepState state = StepState::made;
    std::array<char, 256> why{};
};

struct ReplayRequest {
    explicit ReplayRequest(Memory* memory) : steps(memory) {}

    MeshFingerprint base;
    std::pmr::deque<ReplayStep> steps;
    size_t made = 0;  // the others are taken back again
};

// The whole of flgTangleReplay.
Task<void> replay_tangle(Pace& pace, std::shared_ptr<Tangle> tangle, ReplayRequest request, uint32_t revision);

}  // namespace flg
