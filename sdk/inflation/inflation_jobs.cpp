// SPDX-License-Identifier: MIT
#include "inflation/inflation_jobs.h"

#include "inflation/height_field.h"
#include "inflation/part_mesh.h"
#include "inflation/part_raster.h"

namespace flg {

namespace {

constexpr uint32_t chunk = 30, merge_chunk = 15;  // about 10 us

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

Task<void> merge_parts(Pace& pace, std::span<const PlacedPart> parts, MergeOptions options, MergedMesh& mesh) {
    pace.stage("merge");
    MergeParts merge(parts, options, mesh, pace.memory());
    while (!merge.run(merge_chunk)) co_await pace;
}

Task<void> weigh_bones(Pace& pace, const MergedMesh& mesh, std::span<const BoneSegment> bones,
                       BoneWeightOptions options, BoneWeights& weights) {
    pace.stage("weights");
    BoneWeightsKernel kernel(mesh, bones, options, weights, pace.memory());
    while (!kernel.run(chunk)) co_await pace;
}

}  // namespace flg
