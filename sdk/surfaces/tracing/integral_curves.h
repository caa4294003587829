// SPDX-License-Identifier: MIT
// Integral curves of a field's gradient: the lines of the stream operator and the first guess of geodesic paths, sec.
// 3.3 and 4.2 (Line tracing) of Nazzaro, Puppo, Pellacini: geoTangle (2021).
//
// Invariants
// - The value rises strictly from point to point (uphill; falls if downhill), in double arithmetic and whatever the
//   rounding: a curve never returns and always ends. Only plateaus are crossed level (below).
// - Straight in each triangle along its gradient; along an edge where the gradients of both sides lead to it; at a
//   vertex along the steepest edge or triangle of its fan.
// - Where nothing near is higher, but vertices of exactly this value lie around (flat triangles, level ridges), the
//   curve goes along edges between them to the nearest, by edges, that has something higher or is a target; among at
//   most 128.
#pragma once

#include <optional>
#include <span>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

struct IntegralCurveOptions {
    bool downhill = false;
    std::optional<float> level;         // curves end where they reach this value
    std::span<const uint32_t> targets;  // and at these vertices; rising
    // What happens where a curve reaches the border of the mesh, of the regions or of the finite values. false: it
    // ends. true: it goes on along the border as long as that leads further.
    bool along_borders = false;
};

enum class IntegralCurveStop : uint8_t {
    level,
    target,
    border,    // also if the start lies outside, or at a border where the field would rise beyond it
    extremum,  // nothing near is higher
};

struct IntegralCurveEnd {
    IntegralCurveStop stop;
    uint32_t curve;  // of `out`; no_index if the start is also the end
};

// `values`: one a vertex, linear in each triangle; triangles with one that is not finite are outside. Starts are moved
// by less than 1e-6 of their triangle onto an edge or a vertex that is so near. Appends to `out`, values being those
// at the end of the curves. Returns how they ended, one a start. About 100 ns a triangle.
Task<std::pmr::deque<IntegralCurveEnd>> add_integral_curves(Pace& pace, const Mesh& mesh, std::span<const float> values,
                                                            const RegionSet& regions,
                                                            std::span<const SurfacePoint> starts,
                                                            IntegralCurveOptions options, SurfaceCurves& out);

}  // namespace flg
