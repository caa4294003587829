// SPDX-License-Identifier: MIT
// Descriptors of tangles' steps, checked and copied: those that hosts fill, and those of histories.
#pragma once

#include "filigree/filigree_tangle.h"
#include "tangles/tangle_replay.h"

namespace flg {

FlgTangleDivideDesc default_divide_desc();
FlgTangleApplyMacroDesc default_macro_desc();
FlgTangleDisplaceDesc default_displace_desc();

std::pmr::vector<RegionId> read_region_ids(const uint32_t* regions, uint32_t count, const char* argument,
                                           Memory* memory);

// Without the seeds' curves; check_seeds_of() once they are there.
DivideRequest read_divide(const FlgTangleDivideDesc& desc, Memory* memory);
// Refuses what an operator can't do without, or has no use for.
void check_seeds_of(const DivideRequest& request);
MacroRequest read_macro(const FlgTangleApplyMacroDesc& desc, Memory* memory);
DisplaceRequest read_displace(const FlgTangleDisplaceDesc& desc, Memory* memory);

// A step as a history has it; `surface`: of its tangle.
ReplayStep read_step(Memory* memory, const FlgTangleStep& step, const std::shared_ptr<Surface>& surface);

}  // namespace flg
