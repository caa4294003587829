// SPDX-License-Identifier: MIT
// The straight skeleton of a contour (Aichholzer, Aurenhammer, Alberts, Gaertner: A novel type of skeleton for
// polygons, 1995): triangulated, moved inwards, its arcs chained to faces, and checked.
//
// Robustness. Only the triangulation is exact; the front moves in doubles, by rules that keep it right where much
// happens at one time (wavefront.h). What comes out is checked (skeleton_check.h). If the check fails, or the front
// gets lost, it is tried again: with edges taken for face to face that are nearly, then with points moved by 1e-9 of
// the contour's size, then by 1e-7, a few times; the result says so. If that fails too there is no result: never one
// that is wrong and does not say so, and never a loop without end.
//
// Where a vertex of the front reaches two places at one time the skeleton is not continuous: contours that differ by
// rounding only can have skeletons that differ a lot, each right.
#pragma once

#include "runtime/task.h"
#include "skeletons/contour.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

// Of a contour from clean_contour. Both outlive the task. Throws, with a sentence, for contours that are not simple,
// and where none of the tries came through. About n log n: 2.5 us a point in all for a hundred points, 3.5 us for some
// thousand; 900 bytes a point.
Task<void> straight_skeleton(Pace& pace, const Contour& contour, StraightSkeleton& out);

}  // namespace flg
