// SPDX-License-Identifier: MIT
// The eight macros: sec. 3.4 and Fig. 13 of Nazzaro, Puppo, Pellacini: geoTangle (2021), as sequences of operators.
#pragma once

#include "tangles/tangle_operators.h"

namespace flg {

struct MacroRequest {
    explicit MacroRequest(Memory* memory) : regions(memory) {}

    FlgTangleApplyMacroDesc desc{};  // checked; without what it points to
    std::pmr::vector<RegionId> regions;
};

// One or two operators, one after the other on the same regions.
std::pmr::vector<DivideRequest> expand_macro(const MacroRequest& macro, Memory* memory);

}  // namespace flg
