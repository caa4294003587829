// SPDX-License-Identifier: MIT
// The kernels of this room one after the other, as jobs run them.
#pragma once

#include "inflation/bone_weights.h"
#include "inflation/merge_parts.h"
#include "inflation/two_sided_mesh.h"
#include "runtime/pace.h"
#include "runtime/task.h"

namespace flg {

// Fills `part`, whose contour is given: its triangulation, heights and raster. Throws, with a sentence, for contours that cross
// themselves. About 3 ms for a part of 700 vertices. `part` outlives the task.
Task<void> inflate_part(Pace& pace, InflationOptions options, InflatedPart& part);

// The closed surface of a part that is inflated. Both outlive the task.
Task<void> make_part_surface(Pace& pace, const InflatedPart& part, PartSurface& surface);

// One surface of parts that are inflated. `parts`, what they point to, and `mesh` outlive the task. Throws as MergeParts does. About 8 us a
// vertex that the surface gets.
Task<void> merge_parts(Pace& pace, std::span<const PlacedPart> parts, MergeOptions options, MergedMesh& mesh);

// Weights of bones for a surface whose parts have the bones' numbers. `mesh`, what `bones` shows, and `weights` outlive the task. Throws as
// BoneWeightsKernel does. About 6 us a vertex, and 0.6 us a vertex for each eight joints.
Task<void> weigh_bones(Pace& pace, const MergedMesh& mesh, std::span<const BoneSegment> bones,
                       BoneWeightOptions options, BoneWeights& weights);

}  // namespace flg
