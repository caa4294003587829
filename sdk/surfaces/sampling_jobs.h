// SPDX-License-Identifier: MIT
// The jobs that place points on surfaces.
#pragma once

#include "surfaces/field.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/traced_curves.h"

namespace flg {

struct SamplingRequest {
    std::shared_ptr<Surface> surface;  // its blocks are built
    RegionSet regions;
    float radius;  // metres
    uint32_t max_count;
    uint64_t seed;
    std::shared_ptr<Field> out;
};

// The whole of flgSurfaceSample.
Task<void> sample_surface(Pace& pace, SamplingRequest request);

// The whole of flgSurfaceSampleBorders.
Task<void> sample_border(Pace& pace, uint32_t region, float spacing, std::shared_ptr<TracedCurves> out);

}  // namespace flg
