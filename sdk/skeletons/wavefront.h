// SPDX-License-Identifier: MIT
// The wavefront of a contour whose edges all move inwards at unit speed, in a triangulation that moves with it: a
// change of the front is a triangle that collapses, so nothing is searched (Aichholzer, Aurenhammer: Straight
// skeletons for general polygonal figures in the plane, 1996; with the rules for events at one time of Palfrader,
// Held, Huber: On computing straight skeletons by means of kinetic triangulations, 2012). Its vertices draw the
// straight skeleton's arcs.
//
// Rules that keep it right in double precision, beside those of the second paper
// - A front edge without length vanishes now, whatever its ends' speeds: after a chain of edges collapsed at one
//   point rounding gives those left any sign. So do two vertices at one place that share a diagonal.
// - A vertex between edges that meet face to face is infinitely fast: it waits until all else at its time is done. So
//   does one that would move out of its only triangle.
// - Of triangles that are flat together the one with the longest side is flipped first. The way to it is kept: what is
//   flat behind it comes next.
// - A flip whose new side would be flipped back tells that a triangle is flat, whatever its area.
// - A diagonal that closes as its triangle gets flat is a double root of the area: when it closes is found by itself,
//   and stands for the flattening up to closing_lead before.
// - Each vertex is put onto its two lines where these are far from parallel, so errors do not add up.
// - Bounds for areas are products of two lengths at hand, never one for all.
// All lengths are in units of the contour's diagonal, about 1.
#pragma once

#include <cstdint>
#include <span>

#include "core/memory.h"
#include "skeletons/contour_triangulation.h"
#include "skeletons/skeleton_graph.h"

namespace flg {

// What the front has drawn. The contour's points come first. Arcs may be without length.
struct FrontTrace {
    std::span<const SkeletonNode> nodes() const { return {all_nodes.data(), node_count}; }
    std::span<const SkeletonArc> arcs() const { return {all_arcs.data(), arc_count}; }

    Buffer<SkeletonNode> all_nodes;
    Buffer<SkeletonArc> all_arcs;
    uint32_t node_count = 0, arc_count = 0;
    bool has_failed = false;  // events came without end, or left triangles that no event takes away
};

// The triangulation is complete and without fault, its points have a diagonal of about `size`. Edges face each other,
// and their vertex is infinitely fast, where their normals add up to less than `facing`. All outlive the task; the
// trace is in `memory`. About 1.5 us a point.
Task<FrontTrace> move_front(Pace& pace, const ContourTriangulation& triangulation, std::span<const Point2> points,
                            std::span<const uint32_t> next, double size, double facing, Memory* memory);

}  // namespace flg
