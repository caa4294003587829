// SPDX-License-Identifier: MIT
// The jobs that place points on surfaces.
#pragma once

#include "surfaces/field.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/traced_curves.h"

namespace flg {

// The whole of flgSurfaceSample, with regions resolved. The blocks of the field's surface are built.
Task<void> sample_surface(Pace& pace, FlgSurfaceSampleDesc desc, RegionSet regions, std::shared_ptr<Field> out);

// The whole of flgSurfaceSampleBorders.
Task<void> sample_border(Pace& pace, uint32_t region, float spacing, std::shared_ptr<TracedCurves> out);

}  // namespace flg
