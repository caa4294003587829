// SPDX-License-Identifier: MIT
// The history as a list that is edited: steps are changed, inserted, moved, removed and muted, and what comes after
// them is made again.
//
// Invariants
// - The tangle is what its history makes of its first mesh, to the bit: also after an edit, whatever of it was kept.
// - An edit happens whole or not at all. Its steps before and after are both there until it is forgotten: taking it
//   back, or making it again, exchanges them.
// - A step keeps its identity through edits. Regions are known by the step that made them, their part of it, the
//   region they were in and a place within; so those of a step that was made anew are found again, or are missed.
// - What comes after an edit and has no region left to act on, or fails, is lost: it does nothing, and stays.
#pragma once

#include "tangles/tangle_jobs.h"

namespace flg {

struct HistoryEdit {
    enum class Kind { change, insert, move, remove, mute };

    explicit HistoryEdit(Kind what, Memory* memory) : kind(what), records(memory) {}

    Kind kind;
    size_t step = 0;      // counted from 0, a macro as one
    size_t to = 0;        // of a move: its number afterwards
    bool muted = false;   // of a mute: not to be made
    StepRecords records;  // of a change, an insertion
};

// The whole of flgTangleEditStep, flgTangleInsertStep, flgTangleMoveStep, flgTangleRemoveStep and flgTangleMuteStep.
// Cancelled it stops between steps.
Task<void> edit_history(Pace& pace, std::shared_ptr<Tangle> tangle, HistoryEdit edit, uint32_t revision);

// The beginnings of the steps among the first `made` of the tangle's, and the end.
std::pmr::vector<size_t> step_begins(const Tangle& tangle, size_t made, Memory* memory);

// Takes steps back, or makes them again, until so many are made: all of that or, if it throws, nothing. If memory runs
// out even for the way back, the steps stay as they are then, each of them an act.
Task<void> go_to(Pace& pace, Tangle& tangle, size_t count, uint32_t revision);

// Puts a tail's other end in place of that which the tangle has: likewise.
Task<void> exchange_tail(Pace& pace, Tangle& tangle, StepTail& tail, uint32_t revision);

}  // namespace flg
