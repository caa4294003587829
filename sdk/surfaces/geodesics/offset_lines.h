// SPDX-License-Identifier: MIT
// Lines beside a curve on a mesh: where the shortest way from the curve is so long and leaves it on that side. They are
// a level of the exact distances (exact_solver.h), so they neither cross themselves nor come nearer to the curve
// anywhere: bends tighter than they are away leave corners, and beside narrow places they may be more than one.
//
// Triangles that the level may pass are divided, edge by edge and so alike on both sides, until their edges are an
// eighth as long as it is away, and finer where it may cross one twice. There it is found by the signs at their
// corners, so what is smaller may be missed, but lines never break off. Along edges it is found to rounding; between
// them points are added until it is within a tolerance.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// Lines are so far from the curve, of that distance: points on edges exactly, others by the middle of a stretch.
constexpr double offset_tolerance = 1e-3;

// Of curve 0 of `curves`, `offset` metres to the left of it, below 0 to its right; not 0. Lines run as the curve does,
// in its order, and end beside its ends and at borders. Closed ones shorter than the offset are left out. Appends them
// to `out`, values being their lengths in metres, and to `pieces` for each point that of the curve's stretches that is
// nearest. About 0.3 us a triangle, and as exact distances as far as that.
Task<void> add_offset_lines(Pace& pace, const Mesh& mesh, const SurfaceCurves& curves, double offset,
                            SurfaceCurves& out, std::pmr::deque<uint32_t>& pieces);

}  // namespace flg
