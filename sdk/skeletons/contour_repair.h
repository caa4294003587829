// SPDX-License-Identifier: MIT
// Contours that cross or touch themselves, made simple: the region around which ring 0 winds, either way, without
// what the other rings wind around; of its connected parts the largest one, with its holes.
//
// Points are put onto a grid of 2^26 cells or more across the drawing, where all signs are exact in whole numbers.
// Where edges cross both get a point, rounded to the grid; edges that pass a point nearer than a cell are led through
// it (Hobby: Practical segment intersection with finite precision output, 1999); that is done again until there is
// nothing to do. Edges that are drawn as often one way as the other go. What is left are the borders of faces, with a
// winding number each. Where the region touches itself in a point, its corners there are moved a few cells inwards,
// and all is checked again.
//
// Invariants
// - Rings stay closed: what is done to an edge leaves a way between its ends. So windings are those of whole rings.
// - In the end no two edges meet but at common points, and no point is nearer than a cell to another edge.
#pragma once

#include "runtime/host.h"
#include "runtime/task.h"
#include "skeletons/contour.h"

namespace flg {

// Among Contour::input_points: a point that is none of the input's.
inline constexpr uint32_t no_input_point = ~0u;

// Rings from gather_contour, which outlive the task. The result is as from clean_contour; its input_points are
// no_input_point where edges crossed. Where nothing met, points are where they were, else within 1e-7 of the drawing's
// size. Throws if nothing with an area is left. About linear in the points of drawings, 2 us each; quadratic where all
// edges are above each other.
Task<Contour> repair_contour(Pace& pace, const Contour& rings);

// What cleaning and repair did to a contour of so many input points.
struct ContourChange {
    uint32_t input = 0;    // points
    uint32_t dropped = 0;  // of them
    uint32_t added = 0;    // where edges crossed
    uint32_t pieces = 0;   // smaller than the one that is left

    // One sentence for the host's log about an object, such as "part"; none if nothing changed.
    void warn(const Host& host, const char* object, uint64_t handle) const noexcept;
};
Task<ContourChange> find_change(Pace& pace, const Contour& contour, uint32_t input_points);

}  // namespace flg
