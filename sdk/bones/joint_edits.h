// SPDX-License-Identifier: MIT
// What hosts and their users set about joints, applied to a model each time that it is made: after parts are connected,
// before the model is refined. Joints that are pinned or made by edits are never refined away.
#pragma once

#include <span>
#include <string>

#include "bones/bone_graph.h"
#include "bones/hierarchy.h"
#include "filigree/filigree_model.h"
#include "runtime/task.h"

namespace flg {

// Throws, with the edit's number, where a pin is outside of its part, a root is merged, or two joints get one name.
Task<void> edit_joints(Pace& pace, const HeldModel& model, BoneGraph& graph, Hierarchy& hierarchy);

}  // namespace flg
