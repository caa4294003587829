// SPDX-License-Identifier: MIT
// The eight macros: sec. 3.4 and Fig. 13 of Nazzaro, Puppo, Pellacini: geoTangle (2021), as sequences of operators.
#pragma once

#include "tangles/tangle_operators.h"

namespace flg {

struct MacroRequest {
    explicit MacroRequest(Memory* memory) : regions(memory) {}

    FlgTangleMacro kind = FLG_TANGLE_MACRO_SUNBURST;
    std::pmr::vector<RegionId> regions;
    uint32_t count = 0;
    float size = 0, spacing = 0;  // metres
    uint64_t seed = 1;
};

// One or two operators, one after the other on the same regions.
std::pmr::vector<DivideRequest> expand_macro(const MacroRequest& macro, Memory* memory);

}  // namespace flg
