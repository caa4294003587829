// SPDX-License-Identifier: MIT
// A history made again: on the mesh it is of, to the bit; or on another mesh of its shape, where points, borders and
// regions are found by where they were.
#pragma once

#include "tangles/tangle_jobs.h"

namespace flg {

struct ReplayRequest {
    explicit ReplayRequest(Memory* memory) : steps(memory) {}

    MeshFingerprint base;
    std::pmr::deque<StepRecords> steps;  // with anchors and places as far as they are known
    size_t made = 0;                     // the others are taken back again
};

// The whole of flgTangleReplay.
Task<void> replay_tangle(Pace& pace, std::shared_ptr<Tangle> tangle, ReplayRequest request, uint32_t revision);

}  // namespace flg
