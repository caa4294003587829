// SPDX-License-Identifier: MIT
#include "bones/part.h"

#include "bones/axis_branches.h"
#include "bones/contour_sampling.h"
#include "skeletons/contour_repair.h"
#include "skeletons/plane.h"
#include "skeletons/straight_skeleton.h"

namespace flg {
namespace {

constexpr uint32_t chunk = 32;  // about 10 us
constexpr double longest = 3;   // lengths of parts, by the diagonal of their boxes

// Hosts see all of it as plain numbers.
static_assert(sizeof(Point2) == 2 * sizeof(double) && sizeof(AxisNode) == 3 * sizeof(double));
static_assert(sizeof(AxisSample) == sizeof(FlgAxisSample) && sizeof(AxisBranch) == 4 * sizeof(uint32_t));
static_assert(sizeof(std::array<uint32_t, 2>) == 2 * sizeof(uint32_t));

// Outlines are tried in this order until one does not cross itself: shares of the tolerance, of the even line or the
// drawn one.
struct Attempt {
    bool is_even;
    double tolerance;
};
constexpr Attempt attempts[] = {{true, 1},  {true, 0.25},  {true, 0.0625}, {true, 0},
                                {false, 1}, {false, 0.25}, {false, 0}};

Task<void> make_outline(Pace& pace, HeldPart& part, const Attempt& attempt) {
    const Contour& line = attempt.is_even ? part.line() : part.drawn;
    part.outline = Contour(pace.memory());
    SimplifiedContour kernel(line, attempt.tolerance * part.tolerance * part.length, part.outline, pace.memory());
    while (!kernel.run(16 * chunk)) co_await pace;
}

// Whether the outline has a skeleton; where it has none, the last attempt fails with what is wrong.
Task<bool> make_skeleton(Pace& pace, const Contour& outline, StraightSkeleton& skeleton, bool is_last) {
    StraightSkeletonKernel kernel(outline, skeleton, pace.memory());
    for (bool is_done = false; !is_done;) {
        try {
            is_done = kernel.run(chunk);
        } catch (const Failure& failure) {
            const bool is_drawing =
                failure.result() == FLG_ERROR_INVALID_ARGUMENT || failure.result() == FLG_ERROR_INTERNAL;
            if (is_last || !is_drawing) throw;
            co_return false;
        }
        if (!is_done) co_await pace;
    }
    co_return true;
}

}  // namespace

void HeldPart::show() noexcept {
    view_ = {.struct_size = sizeof view_,
             .outline_count = outline.size(),
             .outline = &outline.points.data()->x,
             .outline_rings = outline.offsets.data(),
             .ring_count = outline.ring_count(),
             .node_count = static_cast<uint32_t>(skeleton.graph.nodes.size()),
             .nodes = &skeleton.graph.nodes.data()->at.x,
             .arcs = skeleton.graph.arcs.empty() ? nullptr : skeleton.graph.arcs.data()->data(),
             .samples = reinterpret_cast<const FlgAxisSample*>(skeleton.samples.data()),
             .branches = skeleton.branches.empty() ? nullptr : &skeleton.branches.data()->from,
             .sample_count = static_cast<uint32_t>(skeleton.samples.size()),
             .branch_count = static_cast<uint32_t>(skeleton.branches.size()),
             .length = length};
}

Task<void> make_part(Pace& pace, std::shared_ptr<HeldPart> part) {
    pace.stage("contour");
    HeldPart& p = *part;
    if (p.repair) {
        ContourRepair repaired(p.drawn, pace.memory());
        while (!repaired.run(chunk)) co_await pace;
        p.drawn = repaired.take_contour();
    }
    RingLength length(p.drawn, 0);
    while (!length.run(64 * chunk)) co_await pace;
    Point2 low = p.drawn.points[0], high = low;
    for (uint32_t i = 0; i < p.drawn.size(); ++i) {
        const Point2& at = p.drawn.points[i];
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
        if (i % (64 * chunk) == 0) co_await pace;
    }
    p.length = std::min(length.length(), longest * distance(low, high));
    if (p.spacing > 0) {
        EvenContour kernel(p.drawn, p.spacing * p.length, p.even);
        while (!kernel.run(16 * chunk)) co_await pace;
    }
    StraightSkeleton skeleton(pace.memory());
    bool is_found = false;
    for (const Attempt& attempt : attempts) {
        if (is_found) break;
        co_await make_outline(pace, p, attempt);
        pace.stage("straight_skeleton");
        skeleton = StraightSkeleton(pace.memory());
        is_found = co_await make_skeleton(pace, p.outline, skeleton, &attempt == std::end(attempts) - 1);
    }
    pace.stage("axis");
    AxisGraphKernel graph(p.outline, skeleton, p.collapse, p.skeleton.graph, pace.memory());
    while (!graph.run(chunk)) co_await pace;
    const double spacing = (p.spacing > 0 ? p.spacing : default_spacing) * p.length;
    AxisBranchesKernel branches(p.outline, spacing, p.skeleton, pace.memory());
    while (!branches.run(chunk)) co_await pace;
}

}  // namespace flg
