// SPDX-License-Identifier: MIT
#include "tangles/stream_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/mesh/index_table.h"
#include "surfaces/mesh/surface_place.h"
#include "surfaces/tracing/integral_curves.h"
#include "tangles/voronoi_borders.h"

namespace flg {

namespace {

// ---- Where they start

// At `t` of the way from a point to one that lies in its triangle.
SurfacePoint between(const Mesh& mesh, const SurfacePoint& from, const SurfacePoint& to, double t) {
    const Triple& corners = mesh.triangles[from.triangle];
    const Vec3 origin = mesh.position(corners[0]);
    const Vec3 a = mesh.position(corners[1]) - origin, b = mesh.position(corners[2]) - origin;
    const Vec3 place = position_of(mesh, to) - origin, normal = a.cross(b);
    const double area = normal.squaredNorm();
    if (!(area > 0)) return from;
    const double u = std::clamp(place.cross(b).dot(normal) / area, 0.0, 1.0);
    const double v = std::clamp(a.cross(place).dot(normal) / area, 0.0, 1 - u);
    return {from.triangle, static_cast<float>(from.u + (u - from.u) * t),
            static_cast<float>(from.v + (v - from.v) * t)};
}

// Evenly along curves on the surface, begun half a step from their beginning.
Task<void> sample_lines(Pace& pace, const Mesh& mesh, const SurfaceCurves& lines, float spacing,
                        std::pmr::deque<SurfacePoint>& out) {
    Slice slice(Cost::hundreds_of_ns);
    for (uint32_t c = 0; c < lines.curve_count(); ++c) {
        const uint32_t first = lines.offsets[c], end = lines.offsets[c + 1];
        double due = spacing / 2;  // metres until the next point
        for (uint32_t i = first; i + 1 < end; ++i) {
            const double length = (position_of(mesh, lines.points[i + 1]) - position_of(mesh, lines.points[i])).norm();
            for (; due < length; due += spacing) {
                out.push_back(between(mesh, lines.points[i], lines.points[i + 1], due / length));
                if (slice.is_over()) co_await pace;
            }
            due -= length;
            if (slice.is_over()) co_await pace;
        }
    }
}

// So many groups take turns along a border.
uint32_t groups_in_turn(const FlgTangleDivideDesc& desc) {
    switch (desc.grouping) {
        case FLG_TANGLE_GROUPING_TWO: return 2;
        case FLG_TANGLE_GROUPING_CYCLE: return desc.cycle;
        default: return 1;
    }
}

Task<void> trace_from(Pace& pace, const Mesh& mesh, const DistanceField& field, const RegionSet& within,
                      const std::pmr::deque<SurfacePoint>& points, SurfaceCurves& curves) {
    if (points.empty()) co_return;
    Buffer<SurfacePoint> starts(points.size(), pace.memory());
    co_await each(pace, starts.size(), Cost::some_ns, [&](uint32_t i) { starts[i] = points[i]; });
    const std::span<const float> values(field.distances.data(), field.distances.size());
    const std::span<const SurfacePoint> from(starts.data(), starts.size());
    co_await add_integral_curves(pace, mesh, values, within, from, IntegralCurveOptions{}, curves);
}

// ---- Ridges

// A border's edges in their order: where along which loop each of them lies.
struct BorderEdges {
    explicit BorderEdges(Memory* memory) : edges(memory), places(memory) {}

    struct Place {
        uint32_t loop;
        double begin, end;  // metres along it
        double whole;       // its length
    };
    std::pmr::deque<Corner> edges;
    std::pmr::deque<Place> places;

    // Metres along a loop between two of its edges, the shorter way round.
    static double gap(const Place& a, const Place& b) {
        const double ahead = b.begin - a.end, behind = a.begin - b.end;
        return std::max(0.0, std::min(std::max(ahead, behind), std::min(ahead, behind) + a.whole));
    }
};

Task<void> add_loop_edges(Pace& pace, const Mesh& mesh, const RegionLoops& loops, uint32_t loop, BorderEdges& border) {
    double walked = 0;
    co_await each(pace, loops.offsets[loop], loops.offsets[loop + 1], Cost::tens_of_ns, [&](uint32_t i) {
        const double begin = walked;
        walked += edge_length(mesh, loops.edges[i]);
        border.edges.push_back(loops.edges[i]);
        border.places.push_back({loop, begin, walked, loops.lengths[loop]});
    });
}

// Where distances from whole loops meet that start far apart: so far that the fronts turn by some 30 degrees from one
// to the other.
Task<SurfaceCurves> trace_ridges(Pace& pace, const std::shared_ptr<Surface>& surface, const RegionSet& within,
                                 const RegionLoops& loops, const Buffer<BorderStretch>& stretches,
                                 Perturbation perturbation) {
    const Mesh& mesh = surface->mesh();
    BorderEdges border(pace.memory());
    for (const BorderStretch& stretch : stretches) co_await add_loop_edges(pace, mesh, loops, stretch.loop, border);
    GeodesicSources sources;
    sources.edges = &border.edges;
    sources.edges_apart = true;
    RegionSet regions = within;
    const GeodesicRequest request{.surface = surface,
                                  .sources = std::move(sources),
                                  .regions = std::move(regions),
                                  .max_distance = unreachable,
                                  .targets = {},
                                  .labelled = true,
                                  .perturbation = perturbation,
                                  .may_be_local = true};
    DistanceField cells;
    co_await solve_field(pace, request, cells);
    const auto apart = [&](uint32_t from, uint32_t to) {
        const BorderEdges::Place &a = border.places[cells.labels[from]], &b = border.places[cells.labels[to]];
        if (a.loop != b.loop) return true;
        const double edge = (mesh.position(to) - mesh.position(from)).norm();
        return BorderEdges::gap(a, b) > 0.5 * std::max(cells.distances[from], cells.distances[to]) + edge;
    };
    co_return co_await voronoi_borders(pace, mesh, within, cells, std::cref(apart));
}

// The points of an open curve are there.
void add_curve(const SurfaceCurves& from, uint32_t curve, SurfaceCurves& to) {
    to.offsets.push_back(static_cast<uint32_t>(to.points.size()));
    to.closed.push_back(false);
    to.values.push_back(from.values[curve]);
}

void add_segment(const SurfaceCurves& from, uint32_t curve, SurfaceCurves& to) {
    to.points.push_back(from.points[2 * curve]);
    to.points.push_back(from.points[2 * curve + 1]);
    add_curve(from, curve, to);
}

// Where ridges cross triangles.
class RidgeMap {
public:
    RidgeMap(const Mesh& mesh, const SurfaceCurves& ridges) : mesh_(mesh), ridges_(ridges) {}

    static Task<void> fill(Pace& pace, RidgeMap& map) {
        const SurfaceCurves& ridges = map.ridges_;
        co_await IndexTable::reserve(pace, map.first_, ridges.curve_count());
        co_await each(pace, ridges.curve_count(), Cost::tens_of_ns, [&](uint32_t r) {
            const uint32_t triangle = ridges.points[2 * r].triangle;
            if (r == 0 || ridges.points[2 * r - 2].triangle != triangle) map.first_.insert(triangle, r);
        });
    }

    struct Found {
        SurfacePoint point;  // of a ridge
        double square;       // of how far it is away
    };
    // Of the points of ridges in a triangle, the nearest to a place; null if no ridge crosses it.
    std::optional<Found> nearest(uint32_t triangle, const Vec3& to) const {
        std::optional<Found> nearest;
        const uint32_t first = first_.find(triangle);
        if (first == no_index) return nearest;
        for (uint32_t i = 2 * first; i < ridges_.points.size() && ridges_.points[i].triangle == triangle; ++i) {
            const double square = (position_of(mesh_, ridges_.points[i]) - to).squaredNorm();
            if (!nearest || square < nearest->square) nearest = {ridges_.points[i], square};
        }
        return nearest;
    }
    // Of those in all triangles around a place.
    std::optional<Found> nearest_around(const SurfacePlace& place, const Vec3& at) const {
        std::optional<Found> nearest;
        const auto look_at = [&](Corner corner) {
            if (corner == no_index) return;
            const std::optional<Found> found = this->nearest(triangle_of(corner), at);
            if (found && (!nearest || found->square < nearest->square)) nearest = found;
        };
        if (place.on == SurfacePlace::On::triangle) look_at(3 * place.index);
        if (place.on == SurfacePlace::On::edge) look_at(place.index), look_at(mesh_.opposite(place.index));
        if (place.on != SurfacePlace::On::vertex) return nearest;
        const Corner first = mesh_.corner_of_vertex[place.index];
        Corner corner = first;
        do {
            look_at(corner);
            corner = mesh_.turn(corner);
        } while (corner != first && corner != no_index);
        return nearest;
    }

private:
    const Mesh& mesh_;
    const SurfaceCurves& ridges_;
    IndexTable first_;  // ridge, by triangle
};

// Streams as they are, up to where they meet a ridge; then the ridges. A stream meets one at a point of it; in the
// first triangle that it crosses, by going straight to it; or where the stream ends beside it.
class EndedStreams {
public:
    EndedStreams(const Mesh& mesh, const RidgeMap& map, const SurfaceCurves& streams, SurfaceCurves& out)
        : mesh_(mesh), map_(map), streams_(streams), out_(out) {}

    void add_point(uint32_t i) {
        const bool is_last = i + 1 == streams_.offsets[stream_ + 1];
        if (!has_met_) add(streams_.points[i], is_last ? nullptr : &streams_.points[i + 1]);
        if (!is_last) return;
        add_curve(streams_, stream_++, out_);
        has_met_ = false;
    }

private:
    void add(const SurfacePoint& point, const SurfacePoint* ahead) {
        constexpr double on_ridge = 1e-4;  // square of the share of the way to the next point
        const Vec3 at = position_of(mesh_, point);
        const bool is_first = out_.points.size() == out_.offsets.back();
        const Vec3 next = ahead ? position_of(mesh_, *ahead) : at;
        const SurfacePlace place = place_in(mesh_, point);
        const auto around = is_first ? std::nullopt : map_.nearest_around(place, at);
        if (around && (!ahead || around->square <= on_ridge * (next - at).squaredNorm())) return end(place, *around);
        out_.points.push_back(point);
        if (!ahead) return;
        const auto crossed = map_.nearest(point.triangle, next);
        if (!crossed || (crossed->point.u == point.u && crossed->point.v == point.v)) return;
        out_.points.push_back(crossed->point);
        has_met_ = true;
    }
    // From a place, seen in the triangle where the ridge is, to it.
    void end(const SurfacePlace& place, const RidgeMap::Found& found) {
        has_met_ = true;
        SurfacePoint point{};
        find_in(mesh_, place, found.point.triangle, point);
        out_.points.push_back(point);
        if (point.u != found.point.u || point.v != found.point.v) out_.points.push_back(found.point);
    }

    const Mesh& mesh_;
    const RidgeMap& map_;
    const SurfaceCurves& streams_;
    SurfaceCurves& out_;
    uint32_t stream_ = 0;
    bool has_met_ = false;
};

Task<void> end_at_ridges(Pace& pace, const Mesh& mesh, const SurfaceCurves& streams, const SurfaceCurves& ridges,
                         SurfaceCurves& out) {
    RidgeMap map(mesh, ridges);
    co_await RidgeMap::fill(pace, map);
    EndedStreams ended(mesh, map, streams, out);
    co_await each(pace, streams.points.size(), Cost::hundreds_of_ns, [&](uint32_t i) { ended.add_point(i); });
    co_await each(pace, ridges.curve_count(), Cost::tens_of_ns, [&](uint32_t r) { add_segment(ridges, r, out); });
}

// ---- Both

struct Bed {
    Tangle& tangle;
    const DivideRequest& request;
    const DistanceField& field;
};

// `within`: what the curves stay in; the loops bound it, or more than that.
Task<void> trace_from_loops(Pace& pace, const Bed& bed, const RegionSet& within, const RegionLoops& loops,
                            const Buffer<BorderStretch>& stretches, StreamLines& streams, SurfaceCurves& ridges) {
    const Mesh& mesh = bed.tangle.surface->mesh();
    const FlgTangleDivideDesc& desc = bed.request.desc;
    SurfaceCurves starts(pace.memory());
    co_await sample_stretches(pace, mesh, loops, stretches, desc.delta, groups_in_turn(desc), starts);
    co_await trace_from(pace, mesh, bed.field, within, starts.points, streams.curves);
    const bool all_whole = std::all_of(stretches.begin(), stretches.end(), [](const auto& s) { return s.is_whole(); });
    if (!bed.request.b.empty() || !all_whole) co_return;
    const SurfaceCurves found =
        co_await trace_ridges(pace, bed.tangle.surface, within, loops, stretches, bed.request.perturbation());
    co_await each(pace, found.curve_count(), Cost::tens_of_ns, [&](uint32_t r) { add_segment(found, r, ridges); });
}

}  // namespace

Task<StreamLines> trace_streams(Pace& pace, Tangle& tangle, const LeafSet& leaves, const DivideRequest& request,
                                const DistanceField& field) {
    pace.stage("streams");
    const Mesh& mesh = tangle.surface->mesh();
    const TangleSeeds& a = request.a;
    const Bed bed{tangle, request, field};
    LeafSet own(pace.memory());
    if (!a.regions.empty()) own = co_await list_leaves(pace, tangle.tree, a.regions, "desc.a");
    const LeafSet& of_seeds = a.regions.empty() ? leaves : own;
    StreamLines streams{SurfaceCurves(pace.memory())};
    SurfaceCurves ridges(pace.memory());
    const bool has_outer =
        a.borders == FLG_TANGLE_BORDERS_OUTER || !a.stretches.empty() || a.loops == TangleSeeds::Loops::leading;
    if (a.borders == FLG_TANGLE_BORDERS_EACH) {
        for (const RegionId leaf : of_seeds.list) {
            const RegionSet one(&leaf, 1, pace.memory());
            const RegionLoops loops = co_await find_region_loops(pace, mesh, one);
            Buffer<BorderStretch> whole(loops.count(), pace.memory());
            co_await each(pace, loops.count(), Cost::some_ns, [&](uint32_t l) { whole[l] = {.loop = l}; });
            co_await trace_from_loops(pace, bed, one, loops, whole, streams, ridges);
        }
    } else if (has_outer) {
        const SeedLoops found = co_await find_loops(pace, mesh, of_seeds.set, a, "desc.a");
        const Buffer<BorderStretch> stretches = co_await choose_stretches(pace, found, a, "desc.a");
        co_await trace_from_loops(pace, bed, leaves.set, found.loops, stretches, streams, ridges);
    }
    if (a.curves) {
        std::pmr::deque<SurfacePoint> points(pace.memory());
        co_await sample_lines(pace, mesh, a.curves->curves, request.desc.delta, points);
        co_await trace_from(pace, mesh, field, leaves.set, points, streams.curves);
    } else if (a.borders == FLG_TANGLE_BORDERS_NONE && !has_outer) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.a has neither borders nor curves for streams to begin on");
    }
    streams.stream_count = streams.curves.curve_count();
    if (ridges.curve_count() == 0) co_return streams;
    SurfaceCurves ended(pace.memory());
    co_await end_at_ridges(pace, mesh, streams.curves, ridges, ended);
    streams.curves = std::move(ended);
    co_return streams;
}

}  // namespace flg
