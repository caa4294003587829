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

#include <memory_resource>
#include <optional>

#include "skeletons/contour.h"
#include "skeletons/skeleton_check.h"
#include "skeletons/skeleton_faces.h"
#include "skeletons/wavefront.h"

namespace flg {

class StraightSkeletonKernel {
public:
    // Of a contour from clean_contour. All outlive the kernel; `out` is complete when run() returns true. Memory is
    // taken when the three steps begin, about 900 bytes a point in all, and a little for stacks.
    StraightSkeletonKernel(const Contour& contour, StraightSkeleton& out, Memory* memory);

    // A unit is at most 0.5 us on the whole; where a step ends the next one has as many again. Throws, with a
    // sentence, for contours that are not simple, and where none of the tries came through. About n log n units: 2.5
    // us a point in all for a hundred points, 3.5 us for some thousand.
    bool run(uint32_t count);

private:
    enum class Pass { measure, place, triangulate, move, chain, check, finish, done };

    void begin_try();
    void place(uint32_t point);
    void end_triangulation();
    void begin_chaining();
    void begin_check();
    void try_again();
    void finish(uint32_t node);

    const Contour& contour_;
    StraightSkeleton& out_;
    // Of small contours all memory is taken at once: it is some thirty arrays that take longer to get than to fill.
    std::pmr::monotonic_buffer_resource arena_;
    Memory* memory_;
    Buffer<uint32_t> next_;
    Buffer<Point2> scaled_;    // the contour's points by a power of two, moved by the try's perturbation
    Buffer<Point2> centred_;   // the same about the middle of the box
    Buffer<Point2> original_;  // without the perturbation
    std::optional<ContourTriangulation> triangulation_;
    std::optional<Wavefront> wavefront_;
    std::optional<SkeletonFaces> faces_;
    std::optional<SkeletonCheck> check_;
    int exponent_ = 0;  // scaled = contour * 2^-exponent
    Point2 low_, high_;
    Point2 middle_{};
    double size_ = 0;
    uint32_t try_ = 0;
    Pass pass_ = Pass::measure;
    uint32_t at_ = 0;
};

}  // namespace flg
