// SPDX-License-Identifier: MIT
// Takes the last step of a tangle back for good, whole or not. It is a kernel and no task because it takes no memory,
// as the call of a task does: what runs out of memory takes its step back by it.
//
//     for (StepRemoval removal(tangle, step); removal.goes_on();) co_await pace;
#pragma once

#include <optional>

#include "runtime/each.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/surface_update.h"
#include "tangles/tangle.h"

namespace flg {

class StepRemoval {
public:
    // Both outlive this. `updated`: what the surface keeps beside its mesh may have followed the step.
    StepRemoval(Tangle& tangle, TangleStep& step, bool updated = true) {
        tangle.tree.take_back(step.tree);
        if (!step.edit) return;
        if (updated) drop_solvers(*tangle.surface);
        mesh_.emplace(tangle.surface->mesh(), tangle.surface->columns, *step.edit, MeshEditReplay::Direction::abandon);
    }
    // Does a slice's work; false when done.
    bool goes_on() { return mesh_ && !mesh_->run(static_cast<uint32_t>(Cost::some_ns)); }

private:
    std::optional<MeshEditReplay> mesh_;
};

}  // namespace flg
