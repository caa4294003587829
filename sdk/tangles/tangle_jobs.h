// SPDX-License-Identifier: MIT
// The jobs of tangles. All change the surface's labels or mesh, one after the other; each is a step of the history, or takes
// one back.
#pragma once

#include "surfaces/traced_curves.h"
#include "tangles/tangle_displacement.h"
#include "tangles/tangle_operators.h"

namespace flg {

// The whole of flgTangleCreate.
Task<void> begin_tangle(Pace& pace, std::shared_ptr<Tangle> tangle);

// The whole of flgTangleDivide. `revision`: of the surface, after the job; so for all.
Task<void> divide_tangle(Pace& pace, std::shared_ptr<Tangle> tangle, DivideRequest request, uint32_t revision);

// The whole of flgTangleApplyMacro: operators that are one step together.
Task<void> divide_in_sequence(Pace& pace, std::shared_ptr<Tangle> tangle, std::pmr::vector<DivideRequest> requests,
                              uint32_t revision);

// The whole of flgTangleDisplace.
Task<void> displace_tangle(Pace& pace, std::shared_ptr<Tangle> tangle, DisplaceRequest request, uint32_t revision);

// The whole of flgTangleGroup, flgTangleUngroup and flgTangleJoin.
Task<void> group_regions(Pace& pace, std::shared_ptr<Tangle> tangle, std::pmr::vector<RegionId> regions);
Task<void> ungroup_regions(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t group);
Task<void> join_regions(Pace& pace, std::shared_ptr<Tangle> tangle, std::pmr::vector<RegionId> regions,
                        uint32_t revision);

// The whole of flgTangleBorders.
Task<void> trace_borders(Pace& pace, std::shared_ptr<Tangle> tangle, std::shared_ptr<TracedCurves> out);

// The whole of flgTangleUndo and flgTangleRedo.
Task<void> undo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision);
Task<void> redo_step(Pace& pace, std::shared_ptr<Tangle> tangle, uint32_t revision);

}  // namespace flg
