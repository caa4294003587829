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

// A step that does nothing, as one.
Task<void> leave_step(Pace& pace, std::shared_ptr<Tangle> tangle, StepRecords records, StepState state,
                      const char* why);

// What a step's record asks for: all of it or, if it fails, nothing. It has to be the next of the tangle.
Task<void> run_record(Pace& pace, Tangle& tangle, uint32_t revision, TangleStep& step);

// The same by another way: `change` makes it.
Task<void> run_step(Pace& pace, Tangle& tangle, TangleStep& step, Task<void>& change);

// Makes room for one more act, behind all others; and counts it as done, which forgets those that were taken back.
void begin_act(Tangle& tangle, std::shared_ptr<StepTail> tail);
void keep_act(Tangle& tangle) noexcept;

// The whole of flgTangleTraceBorders.
Task<void> trace_borders(Pace& pace, std::shared_ptr<Tangle> tangle, std::shared_ptr<TracedCurves> out);

// The whole of flgTangleUndo and flgTangleRedo.
Task<void> undo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision);
Task<void> redo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision);

}  // namespace flg
