// SPDX-License-Identifier: MIT
// The jobs that cut surfaces. They are the ones that change them: from the first change on they can't be cancelled, and
// if that fails, for want of memory or of labels, it is taken back.
#pragma once

#include "surfaces/field_levels.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/traced_curves.h"

namespace flg {

struct CutIsolinesRequest {
    std::shared_ptr<const Field> field;
    uint32_t revision;                   // of its surface after the cut
    std::pmr::vector<uint32_t> regions;  // rising; empty: all
    LevelRequest levels;
    uint32_t first_label;        // no_index: labels stay
    std::shared_ptr<Field> out;  // the field on the cut surface, or null
};

// The whole of flgSurfaceCutIsolines.
Task<void> cut_isolines(Pace& pace, CutIsolinesRequest request);

// The whole of flgSurfaceCutCurves. `revision`: of the surface after the cut.
Task<void> cut_curves(Pace& pace, std::shared_ptr<const TracedCurves> curves, uint32_t first_label, uint32_t revision);

}  // namespace flg
