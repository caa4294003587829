// SPDX-License-Identifier: MIT
#include "skeletons/straight_skeleton.h"

#include <algorithm>
#include <cmath>
#include <memory_resource>
#include <span>

#include "core/random.h"
#include "skeletons/node_clusters.h"
#include "skeletons/passes.h"
#include "skeletons/skeleton_check.h"
#include "skeletons/wavefront.h"

namespace flg {

namespace {

// ---- Faces of the arcs that a wavefront drew: arcs without length are contracted, and those of each face are chained
// from its edge's end to its beginning. There are none if the arcs of a face are not one such chain that uses each
// once, or if a node has no time.

constexpr uint32_t none = ~0u;
constexpr double contracted_length = 1e-9;  // arcs up to this share of the diagonal are contracted

// Fills in nodes, arcs and faces; true if they are sound. `points` are the contour's as they were given, which may have
// been moved for the wavefront, about the wavefront's origin, with a diagonal of `size`. All outlive the task, whose
// scratch is in `memory`. About 0.1 us an arc.
Task<bool> chain_faces(Pace& pace, std::span<const SkeletonNode> nodes, std::span<const SkeletonArc> arcs,
                       std::span<const Point2> points, std::span<const uint32_t> next, double size,
                       StraightSkeleton& out, Memory* memory) {
    NodeClusters clusters(nodes.size(), memory);
    Buffer<uint32_t> number(nodes.size(), memory);
    Buffer<uint32_t> following(nodes.size(), memory);  // on the face at hand
    out.nodes.clear();
    out.arcs.clear();
    out.face_offsets.clear();
    out.face_nodes.clear();
    out.nodes.reserve(nodes.size());
    out.arcs.reserve(arcs.size());
    out.face_offsets.reserve(points.size() + 1);
    out.face_nodes.reserve(2 * arcs.size() + points.size());
    co_await pass(pace, nodes.size(), Cost::some_ns, [&](uint32_t i) {
        clusters.begin(i);
        following[i] = none;
    });
    // The ends of arcs without length are one; the contour's points stay by themselves.
    co_await pass(pace, arcs.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const SkeletonArc& arc = arcs[i];
        if (arc.a < points.size() || arc.b < points.size()) return;
        const SkeletonNode &from = nodes[arc.a], &to = nodes[arc.b];
        if (std::fabs(from.at.x - to.at.x) + std::fabs(from.at.y - to.at.y) <= contracted_length * size)
            clusters.join(arc.a, arc.b);
    });
    // The least of those that are one comes first, so it has its number when the others ask for it.
    bool has_times = true;
    co_await pass(pace, nodes.size(), Cost::tens_of_ns, [&](uint32_t node) {
        const uint32_t first = clusters.first(node);
        if (first != node) {
            number[node] = number[first];
            return;
        }
        has_times &= node < points.size() || nodes[node].time > 0;
        number[node] = static_cast<uint32_t>(out.nodes.size());
        out.nodes.push_back(nodes[node]);
        if (node < points.size()) out.nodes.back().at = points[node];
    });
    if (!has_times) co_return false;
    co_await pass(pace, arcs.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t a = number[arcs[i].a], b = number[arcs[i].b];
        if (a != b) out.arcs.push_back({a, b, arcs[i].left, arcs[i].right});
    });
    // Each arc is of two faces: half 2 i leads from its beginning to its end, half 2 i + 1 back.
    const auto face_of = [&](uint32_t half) {
        const SkeletonArc& arc = out.arcs[half / 2];
        return half % 2 == 0 ? arc.left : arc.right;
    };
    const Groups halves = co_await group_by(pace, 2 * out.arcs.size(), points.size(), face_of);
    Slice slice(Cost::tens_of_ns);
    for (uint32_t face = 0; face < points.size(); ++face) {
        const std::span<const uint32_t> own = halves.of(face);
        out.face_offsets.push_back(static_cast<uint32_t>(out.face_nodes.size()));
        out.face_nodes.push_back(face);
        for (const uint32_t half : own) {
            const SkeletonArc& arc = out.arcs[half / 2];
            uint32_t& after = following[half % 2 == 0 ? arc.a : arc.b];
            if (after != none) co_return false;
            after = half % 2 == 0 ? arc.b : arc.a;
            if (slice.is_over()) co_await pace;
        }
        uint32_t node = next[face];
        size_t used = 0;
        for (; used < own.size() && node != face && node != none; ++used) {
            out.face_nodes.push_back(node);
            node = following[node];
            if (slice.is_over()) co_await pace;
        }
        if (node != face || used != own.size()) co_return false;
        for (const uint32_t half : own) {
            const SkeletonArc& arc = out.arcs[half / 2];
            following[half % 2 == 0 ? arc.a : arc.b] = none;
            if (slice.is_over()) co_await pace;
        }
    }
    out.face_offsets.push_back(static_cast<uint32_t>(out.face_nodes.size()));
    co_return true;
}

// What one try takes of a contour that small.
constexpr uint32_t arena_points = 300;
constexpr size_t arena_bytes = 8192, arena_bytes_a_point = 1400;

// By how much of the contour's diagonal points are moved, and below what |n1 + n2| edges face each other. Measured on
// grids and pixels whose points were moved by 1e-13 to 1e-5, where the first fails for up to one in three: the second
// comes through for nine of ten of those, and each of the last ones for nearly all.
struct Try {
    double perturbation, facing;
};
constexpr Try tries[] = {{0, 1e-8},    {0, 1e-6},    {1e-9, 1e-6}, {1e-7, 1e-8}, {1e-7, 1e-6},
                         {1e-7, 1e-8}, {1e-7, 1e-6}, {1e-7, 1e-8}, {1e-7, 1e-6}, {1e-7, 1e-8}};

// The contour as it is worked on.
struct Scaled {
    Scaled(uint32_t count, Memory* of_memory)
        : next_values(count, of_memory),
          scaled_values(count, of_memory),
          centred_values(count, of_memory),
          original_values(count, of_memory),
          memory(of_memory) {}

    void measure(const Point2& low_corner, const Point2& high_corner) {
        exponent = std::ilogb(std::hypot(high_corner.x - low_corner.x, high_corner.y - low_corner.y));
        const Point2 low = {std::ldexp(low_corner.x, -exponent), std::ldexp(low_corner.y, -exponent)};
        const Point2 high = {std::ldexp(high_corner.x, -exponent), std::ldexp(high_corner.y, -exponent)};
        middle = {(low.x + high.x) / 2, (low.y + high.y) / 2};
        size = std::hypot(high.x - low.x, high.y - low.y);
    }
    void place(const Contour& contour, uint32_t point, uint32_t attempt) {
        next_values[point] = contour.next(point);
        const Point2 at = {std::ldexp(contour.points[point].x, -exponent),
                           std::ldexp(contour.points[point].y, -exponent)};
        const double reach = tries[attempt].perturbation * size;
        const auto moved = [&](double value, uint32_t axis) {
            return reach == 0 ? value : value + reach * (2 * random_unit(attempt, point, axis) - 1);
        };
        scaled_values[point] = {moved(at.x, 0), moved(at.y, 1)};
        centred_values[point] = {scaled_values[point].x - middle.x, scaled_values[point].y - middle.y};
        original_values[point] = {at.x - middle.x, at.y - middle.y};
    }
    std::span<const uint32_t> next() const { return {next_values.data(), next_values.size()}; }
    // The contour's points by a power of two, moved by the try's perturbation.
    std::span<const Point2> scaled() const { return {scaled_values.data(), scaled_values.size()}; }
    // The same about the middle of the box.
    std::span<const Point2> centred() const { return {centred_values.data(), centred_values.size()}; }
    // Without the perturbation.
    std::span<const Point2> original() const { return {original_values.data(), original_values.size()}; }

    Buffer<uint32_t> next_values;
    Buffer<Point2> scaled_values, centred_values, original_values;
    Memory* memory;
    int exponent = 0;  // scaled = contour * 2^-exponent
    Point2 middle{};
    double size = 0;
};

// Whether it came through. What a step took is given back when the next has what it needs of it.
Task<bool> come_through(Pace& pace, const Contour& contour, const Scaled& points, uint32_t attempt,
                        StraightSkeleton& out) {
    FrontTrace trace;
    {
        const ContourTriangulation triangulation =
            co_await triangulate_contour(pace, points.scaled(), points.next(), points.memory);
        if (triangulation.fault.kind != ContourFault::Kind::none) {
            if (attempt == 0) throw describe_fault(contour, triangulation.fault);
            co_return false;
        }
        trace = co_await move_front(pace, triangulation, points.centred(), points.next(), points.size,
                                    tries[attempt].facing, points.memory);
        if (trace.has_failed) co_return false;
    }
    const bool is_chained = co_await chain_faces(pace, trace.nodes(), trace.arcs(), points.original(), points.next(),
                                                 points.size, out, points.memory);
    trace = FrontTrace();
    if (!is_chained) co_return false;
    const bool is_good =
        co_await can_be_straight_skeleton(pace, points.original(), points.next(), contour.ring_count(), points.size,
                                          tries[attempt].perturbation, out, points.memory);
    co_return is_good;
}

}  // namespace

Task<void> straight_skeleton(Pace& pace, const Contour& contour, StraightSkeleton& out) {
    const uint32_t count = contour.size();
    // Of small contours all memory is taken at once: it is some thirty arrays that take longer to get than to fill.
    std::pmr::monotonic_buffer_resource arena(arena_bytes + arena_bytes_a_point * std::min(count, arena_points),
                                              pace.memory());
    Scaled points(count, count <= arena_points ? &arena : pace.memory());
    Point2 low = contour.points[0], high = low;
    co_await pass(pace, count, Cost::some_ns, [&](uint32_t i) {
        const Point2& p = contour.points[i];
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    });
    points.measure(low, high);
    for (uint32_t attempt = 0; attempt < std::size(tries); ++attempt) {
        co_await pass(pace, count, Cost::tens_of_ns, [&](uint32_t i) { points.place(contour, i, attempt); });
        const bool is_through = co_await come_through(pace, contour, points, attempt, out);
        if (!is_through) continue;
        out.perturbation = tries[attempt].perturbation;
        co_await pass(pace, out.nodes.size(), Cost::tens_of_ns, [&](uint32_t i) {
            SkeletonNode& node = out.nodes[i];
            const Point2 at = {node.at.x + points.middle.x, node.at.y + points.middle.y};
            node.at = i < count ? contour.points[i]
                                : Point2{std::ldexp(at.x, points.exponent), std::ldexp(at.y, points.exponent)};
            node.time = std::ldexp(node.time, points.exponent);
        });
        co_return;
    }
    throw Failure(FLG_ERROR_INTERNAL, "contour: its %u points have too many changes at one time: no skeleton was found",
                  count);
}

}  // namespace flg
