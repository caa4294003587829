// SPDX-License-Identifier: MIT
// The jobs of tangles. All change the surface's labels or mesh, one after the other; each is a step of the history, or
// takes one back.
#pragma once

#include "surfaces/traced_curves.h"
#include "tangles/step_record.h"
#include "tangles/tangle.h"

namespace flg {

// The whole of flgTangleCreate.
Task<void> begin_tangle(Pace& pace, std::shared_ptr<Tangle> tangle);

// The whole of flgTangleDivide, flgTangleApplyMacro, flgTangleDisplace, flgTangleGroup, flgTangleUngroup and
// flgTangleJoin: one step, whatever it consists of. `revision`: of the surface, after the job; so for all.
Task<void> make_step(Pace& pace, std::shared_ptr<Tangle> tangle, StepRecords records, uint32_t revision);

// The whole of flgTangleTraceBorders.
Task<void> trace_borders(Pace& pace, std::shared_ptr<Tangle> tangle, std::shared_ptr<TracedCurves> out);

// The whole of flgTangleUndo and flgTangleRedo.
Task<void> undo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision);
Task<void> redo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision);

}  // namespace flg
