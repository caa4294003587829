// SPDX-License-Identifier: MIT
#include "inflation/inflation_jobs.h"

#include "inflation/height_field.h"
#include "inflation/part_mesh.h"
#include "inflation/part_raster.h"

namespace flg {

namespace {

constexpr uint32_t chunk = 30;  // about 10 us

}  // namespace

Task<void> inflate_part(Pace& pace, InflationOptions options, InflatedPart& part) {
    pace.stage("inflate");
    {
        PartMesh mesh(options, part, pace.memory());
        while (!mesh.run(chunk)) co_await pace;
    }
    {
        HeightField heights(part, pace.memory());
        while (!heights.run(chunk)) co_await pace;
    }
    PartRasterKernel raster(part, pace.memory());
    while (!raster.run(chunk)) co_await pace;
}

Task<void> make_part_surface(Pace& pace, const InflatedPart& part, PartSurface& surface) {
    TwoSidedMesh mesh(part, surface, pace.memory());
    while (!mesh.run(chunk)) co_await pace;
}

}  // namespace flg
