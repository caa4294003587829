// SPDX-License-Identifier: MIT
// What seeds turned out to be, by positions in space: what finds them again on another mesh of the same shape, whose
// triangles, borders and samples have other numbers.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/region_loops.h"
#include "surfaces/traced_curves.h"

namespace flg {

struct SeedAnchors {
    // Of the seeds' points, and of the points of their curves.
    Buffer<Position> points, curve_points;
    // Of the first vertices of the outer borders, in their order; empty: they were not asked for.
    Buffer<Position> loops;
    // Of the samples, in the order they were chosen.
    Buffer<Position> samples;
    // They are a history's; and of another mesh: points, curves, samples and borders are where these say, and these stay as they
    // are, so that they lead to the same bits again.
    bool known = false, given = false;
    std::shared_ptr<TracedCurves> given_curves;    // of the history, or null
    std::shared_ptr<TracedCurves> located_curves;  // for what they are on this mesh
    Buffer<SurfacePoint> sample_points;
};

Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<SurfacePoint>& points);
Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<uint32_t>& vertices);

// Gives loops the order and beginnings that are given, each the nearest of those that are left; or remembers what they are.
// Cost: where they are given, some ns for each edge and anchor.
Task<void> anchor_loops(Pace& pace, const Mesh& mesh, RegionLoops& loops, SeedAnchors& anchors);

}  // namespace flg
