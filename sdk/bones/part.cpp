// SPDX-License-Identifier: MIT
#include "bones/part.h"

#include <algorithm>

#include "bones/axis.h"
#include "bones/axis_stubs.h"
#include "bones/blunt_valleys.h"
#include "bones/contour_sampling.h"
#include "bones/mirrored_axis.h"
#include "runtime/each.h"
#include "skeletons/contour_repair.h"
#include "skeletons/point2.h"
#include "skeletons/straight_skeleton.h"

namespace flg {
namespace {

constexpr double longest = 3;                // lengths of parts, by the diagonal of their boxes
constexpr double mirror_tolerance = 0.0015;  // of the length: how far a line may be from its mirror image

// A gap along the mirror axis, as between two legs, begins so many tolerances from where the line crosses the axis; a
// half stays so much of it on its side.
constexpr double gap_begins = 4, of_gap = 0.3;

constexpr double valley_edge = 0.0005;  // of the length: from a sharp valley to the ends of the edge across it

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

// The length of ring 0, closed, but not of a line that is all wrinkles.
Task<double> length_of(Pace& pace, const Contour& drawn) {
    const uint32_t end = drawn.offsets[1];
    double length = 0;
    Point2 low = drawn.points[0], high = low;
    co_await each(pace, drawn.size(), Cost::some_ns, [&](uint32_t i) {
        const Point2& at = drawn.points[i];
        if (i < end) length += distance(drawn.points[i == 0 ? end - 1 : i - 1], at);
        low = {std::min(low.x, at.x), std::min(low.y, at.y)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y)};
    });
    co_return std::min(length, longest * distance(low, high));
}

// Area, its middle, and the widest place.
Task<void> measure(Pace& pace, HeldPart& part) {
    const ContourArea within = co_await area_within(pace, part.outline);
    part.area = within.area;
    part.centroid = within.centroid;
    const auto& nodes = part.skeleton.graph.nodes;
    co_await each(pace, nodes.size(), Cost::some_ns,
                  [&](uint32_t i) { part.widest = std::max(part.widest, nodes[i].clearance); });
}

// Whether the outline has a skeleton; where it has none, the last attempt fails with what is wrong.
Task<bool> make_skeleton(Pace& pace, const Contour& outline, StraightSkeleton& skeleton, bool is_last) {
    try {
        co_await straight_skeleton(pace, outline, skeleton);
    } catch (const Failure& failure) {
        const bool is_drawing =
            failure.result() == FLG_ERROR_INVALID_ARGUMENT || failure.result() == FLG_ERROR_INTERNAL;
        if (is_last || !is_drawing) throw;
        co_return false;
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
    if (p.repair) p.drawn = co_await repair_contour(pace, p.drawn);
    p.change = co_await find_change(pace, p.drawn, p.change.input);
    p.length = co_await length_of(pace, p.drawn);
    if (p.spacing > 0) p.even = co_await even_contour(pace, p.drawn, p.spacing * p.length);
    std::optional<Contour> half, even_half;
    p.mirror = co_await find_mirror(pace, p.drawn, mirror_tolerance * p.length);
    if (p.mirror) half = co_await left_half(pace, p.drawn, *p.mirror);
    double gap = HUGE_VAL;
    if (half) gap = co_await gap_at_axis(pace, *half, *p.mirror, gap_begins * p.tolerance * p.length);
    if (half && p.spacing > 0) even_half = co_await even_contour(pace, *half, p.spacing * p.length);
    StraightSkeleton skeleton(pace.memory());
    bool is_found = false;
    for (const Attempt& attempt : attempts) {
        if (is_found) break;
        const bool is_even = attempt.is_even && p.spacing > 0;
        const double tolerance = attempt.tolerance * p.tolerance * p.length;
        if (half) {
            const double within = std::min(tolerance, of_gap * gap);
            const Contour simple = co_await simplified_contour(pace, is_even ? *even_half : *half, within);
            p.outline = co_await with_image(pace, simple, *p.mirror, within);
        }
        const bool is_mirrored = half && p.outline.size() >= 3;
        if (!is_mirrored) p.outline = co_await simplified_contour(pace, is_even ? p.even : p.drawn, tolerance);
        p.outline = co_await with_blunt_valleys(pace, std::move(p.outline), is_mirrored ? p.mirror : std::nullopt,
                                                valley_edge * p.length);
        pace.stage("straight_skeleton");
        skeleton = StraightSkeleton(pace.memory());
        is_found = co_await make_skeleton(pace, p.outline, skeleton, &attempt == std::end(attempts) - 1);
    }
    pace.stage("axis");
    AxisGraph whole = co_await axis_graph(pace, p.outline, skeleton, p.collapse);
    AxisGraph graph = co_await without_stubs(pace, p.outline, std::move(whole));
    const double spacing = (p.spacing > 0 ? p.spacing : default_spacing) * p.length;
    std::optional<PartSkeleton> mirrored;
    if (half && graph.nodes.size() > 1)
        mirrored = co_await mirrored_branches(pace, p.outline, graph, *p.mirror, spacing);
    if (mirrored) {
        p.skeleton = std::move(*mirrored);
    } else {
        p.mirror.reset();
        p.skeleton = co_await axis_branches(pace, p.outline, std::move(graph), spacing);
    }
    co_await measure(pace, p);
}

}  // namespace flg
