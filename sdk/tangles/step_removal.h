// SPDX-License-Identifier: MIT
// Takes the last step of a tangle back for good, whole or not. It takes no memory: no call of another task does that.
#pragma once

#include <optional>

#include "surfaces/mesh_edit_replay.h"
#include "surfaces/surface_update.h"
#include "tangles/tangle.h"

namespace flg {

class StepRemoval {
public:
    // Both outlive this.
    StepRemoval(Tangle& tangle, TangleStep& step) {
        tangle.tree.take_back(step.tree);
        if (!step.edit) return;
        drop_solvers(*tangle.surface);  // they may have followed it
        mesh_.emplace(tangle.surface->mesh(), tangle.surface->columns, *step.edit, MeshEditReplay::Direction::abandon);
    }
    // A unit is a word that was changed: a few nanoseconds. True when done.
    bool run(uint32_t count) { return !mesh_ || mesh_->run(count); }

private:
    std::optional<MeshEditReplay> mesh_;
};

}  // namespace flg
