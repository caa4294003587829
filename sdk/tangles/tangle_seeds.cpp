// SPDX-License-Identifier: MIT
#include "tangles/tangle_seeds.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "surfaces/geodesic_seeds.h"
#include "surfaces/poisson_sampling.h"
#include "surfaces/solve_field.h"
#include "surfaces/surface_inputs.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t loop_chunk = 500;
constexpr uint32_t scan_chunk = 3000;
constexpr uint32_t look_chunk = 20;
constexpr uint32_t seed_chunk = 50;
constexpr uint32_t merge_chunk = 1000;
constexpr uint32_t sample_chunk = 50;
constexpr uint32_t point_chunk = 2000;
constexpr uint32_t tree_chunk = 200;

Task<void> find_loops(Pace& pace, const Mesh& mesh, const RegionSet& leaves, const TangleSeeds& seeds,
                      const char* argument, RegionLoops& loops) {
    RegionLoopsKernel kernel(mesh, leaves, loops, pace.memory());
    while (!kernel.run(loop_chunk)) co_await pace;
    if (loops.count() == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s asks for borders, but the regions are all of a closed surface",
                      argument);
    }
    if (seeds.anchors) co_await anchor_loops(pace, mesh, loops, *seeds.anchors);
}

// The stretches asked for, or all loops whole.
Buffer<BorderStretch> choose_stretches(const RegionLoops& loops, const TangleSeeds& seeds, const char* argument,
                                       Memory* memory) {
    const bool all = seeds.stretches.empty();
    Buffer<BorderStretch> chosen(all ? loops.count() : seeds.stretches.size(), memory);
    for (uint32_t i = 0; i < chosen.size(); ++i) {
        chosen[i] = all ? BorderStretch{.loop = i} : seeds.stretches[i];
        if (chosen[i].loop >= loops.count()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.stretches[%u].loop is %u, the regions have %u borders",
                          argument, i, chosen[i].loop, loops.count());
        }
    }
    return chosen;
}

// The edges whose middle lies in the stretch.
Task<void> add_stretch(Pace& pace, const Mesh& mesh, const RegionLoops& loops, BorderStretch stretch,
                       std::pmr::deque<Corner>& edges) {
    const double whole = loops.lengths[stretch.loop];
    double walked = 0;
    for (uint32_t i = loops.offsets[stretch.loop]; i < loops.offsets[stretch.loop + 1]; ++i) {
        const double length = edge_length(mesh, loops.edges[i]);
        const double middle = whole > 0 ? (walked + length / 2) / whole : 0;
        walked += length;
        if (stretch.is_whole() || (middle >= stretch.begin && middle < stretch.end) || middle + 1 < stretch.end) {
            edges.push_back(loops.edges[i]);
        }
        if (i % loop_chunk == 0) co_await pace;
    }
}

// Edges where leaves end, seen from within; those between two leaves once.
Task<void> add_each_border(Pace& pace, const Mesh& mesh, const RegionSet& leaves, std::pmr::deque<Corner>& edges) {
    const auto is_border = [&](uint32_t t, uint32_t across) {
        if (across == no_index) return true;
        const uint32_t other = mesh.regions[across];
        return other != mesh.regions[t] && (t < across || !leaves.contains(other));
    };
    RegionCursor within(mesh, leaves);
    for (uint32_t passed = 1; !within.at_end(); ++passed) {
        within.next_64([&](uint32_t t) {
            for (uint32_t k = 0; k < 3; ++k) {
                if (is_border(t, mesh.neighbours[t][k])) edges.push_back(3 * t + k);
            }
        });
        if (passed % look_chunk == 0) co_await pace;
    }
}

// Half a radius from borders, by algorithm 2.
Task<void> begin_sampling(Pace& pace, Surface& surface, const RegionSet& leaves, float radius,
                          const GeodesicRegion* bound, RefinedSolver& solver) {
    const Mesh& mesh = surface.mesh();
    RegionLoops loops(pace.memory());
    RegionLoopsKernel find(mesh, leaves, loops, pace.memory());
    while (!find.run(loop_chunk)) co_await pace;
    GeodesicSeeds border(mesh, mesh.positions, leaves, pace.memory());
    for (size_t i = 0; i < loops.edges.size(); ++i) {
        border.add_edge(loops.edges[i], 0);
        if (i % seed_chunk == 0) co_await pace;
    }
    SeedMergeKernel merge(border.found(), pace.memory());
    while (!merge.run(merge_chunk)) co_await pace;
    Buffer<Seed> away(merge.seeds().size(), pace.memory());
    for (size_t i = 0; i < away.size(); ++i) {
        away[i] = merge.seeds()[i];
        away[i].distance += radius / 2;
        if (i % merge_chunk == 0) co_await pace;
    }
    const SolveLimits limits{.distance = unreachable, .targets = std::pmr::vector<uint32_t>(pace.memory())};
    solver.begin({away.data(), away.size()}, limits, false, bound);
    while (!solver.run(sample_chunk)) co_await pace;
}

Task<Buffer<uint32_t>> sample(Pace& pace, Surface& surface, const RegionSet& leaves, const TangleSeeds& seeds) {
    const GeodesicBlocks& blocks = blocks_of(surface);
    GeodesicRegion region(pace.memory());
    const GeodesicRegion* bound = co_await bound_region(pace, surface.mesh(), blocks, leaves, region);
    auto solver = surface.solvers.refined.lend(blocks, pace.memory());
    co_await begin_sampling(pace, surface, leaves, seeds.sample_radius, bound, *solver);
    const uint32_t most = seeds.sample_count == 0 ? no_index : seeds.sample_count;
    PoissonSamplingKernel kernel(surface.mesh(), leaves, *solver, seeds.sample_radius, most, seeds.seed, pace.memory());
    while (!kernel.run(sample_chunk)) co_await pace;
    solver.give_back();
    co_return co_await flatten(pace, kernel.samples());
}

Task<void> sample_loops(Pace& pace, const Mesh& mesh, const RegionLoops& loops, const Buffer<BorderStretch>& stretches,
                        float spacing, SurfaceCurves& curves) {
    BorderSamplingKernel kernel(mesh, loops, {stretches.data(), stretches.size()}, spacing, curves);
    while (!kernel.run(loop_chunk)) co_await pace;
}

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
    for (uint32_t c = 0; c < lines.curve_count(); ++c) {
        const uint32_t first = lines.offsets[c], end = lines.offsets[c + 1];
        double due = spacing / 2;  // metres until the next point
        for (uint32_t i = first; i + 1 < end; ++i) {
            const double length = (position_of(mesh, lines.points[i + 1]) - position_of(mesh, lines.points[i])).norm();
            for (; due < length; due += spacing) {
                out.push_back(between(mesh, lines.points[i], lines.points[i + 1], due / length));
                co_await pace;
            }
            due -= length;
            if (i % point_chunk == 0) co_await pace;
        }
    }
}

}  // namespace

Task<LeafSet> list_leaves(Pace& pace, const RegionTree& tree, const std::pmr::vector<RegionId>& regions,
                          const char* argument) {
    Buffer<uint64_t> found((size_t{tree.size()} + 63) / 64, pace.memory());
    std::fill(found.begin(), found.end(), uint64_t{0});
    for (size_t i = 0; i < regions.size(); ++i) {
        if (regions[i] >= tree.size()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s[%zu] is %u, the tangle has %u regions", argument, i,
                          regions[i], tree.size());
        }
        RegionTree::Leaves leaves(tree, regions[i], pace.memory());
        uint32_t passed = 0;
        for (RegionId leaf = leaves.next(); leaf != no_region; leaf = leaves.next()) {
            found[leaf / 64] |= uint64_t{1} << leaf % 64;
            if (++passed % tree_chunk == 0) co_await pace;
        }
        co_await pace;
    }
    LeafSet leaves(pace.memory());
    for (RegionId r = 0; r < tree.size(); ++r) {
        if ((found[r / 64] >> r % 64 & 1) != 0) leaves.list.push_back(r);
        if (r % scan_chunk == 0) co_await pace;
    }
    leaves.set = RegionSet(leaves.list.data(), static_cast<uint32_t>(leaves.list.size()), pace.memory());
    co_return leaves;
}

Task<GeodesicSources> find_sources(Pace& pace, Surface& surface, const RegionSet& leaves, const TangleSeeds& seeds,
                                   const char* argument, SeedPlaces& places) {
    const Mesh& mesh = surface.mesh();
    co_await check_points(pace, mesh, seeds.points, argument);
    GeodesicSources sources;
    sources.curves = seeds.curves;
    const bool located = seeds.anchors && seeds.anchors->given;
    if (seeds.sample_radius > 0 && !located) {
        sources.vertices = co_await sample(pace, surface, leaves, seeds);
        if (seeds.anchors) seeds.anchors->samples = co_await positions_of(pace, mesh, sources.vertices);
    }
    SurfaceCurves spaced(pace.memory());
    const bool outer = seeds.borders == FLG_TANGLE_BORDERS_OUTER;
    if (outer || seeds.other_loops || !seeds.stretches.empty() || seeds.border_spacing > 0) {
        RegionLoops loops(pace.memory());
        co_await find_loops(pace, mesh, leaves, seeds, argument, loops);
        if (seeds.other_loops && loops.count() < 2) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the regions have one border, two are needed to go between them");
        }
        for (uint32_t l = 1; seeds.other_loops && l < loops.count(); ++l) {
            co_await add_stretch(pace, mesh, loops, {.loop = l}, places.edges);
        }
        if (outer || !seeds.stretches.empty()) {
            const Buffer<BorderStretch> stretches = choose_stretches(loops, seeds, argument, pace.memory());
            for (const BorderStretch& stretch : stretches) {
                co_await add_stretch(pace, mesh, loops, outer ? BorderStretch{.loop = stretch.loop} : stretch,
                                     places.edges);
            }
        }
        if (seeds.border_spacing > 0) {
            Buffer<BorderStretch> whole(loops.count(), pace.memory());
            for (uint32_t l = 0; l < loops.count(); ++l) whole[l] = {.loop = l};
            co_await sample_loops(pace, mesh, loops, whole, seeds.border_spacing, spaced);
        }
    }
    if (seeds.borders == FLG_TANGLE_BORDERS_EACH) co_await add_each_border(pace, mesh, leaves, places.edges);
    if (!places.edges.empty()) sources.edges = &places.edges;
    const size_t samples = located ? seeds.anchors->sample_points.size() : 0, own = samples + seeds.points.size();
    sources.points = Buffer<SurfacePoint>(own + spaced.points.size(), pace.memory());
    for (size_t i = 0; i < sources.points.size(); ++i) {
        sources.points[i] = i < samples ? seeds.anchors->sample_points[i]
                            : i < own   ? seeds.points[i - samples]
                                        : spaced.points[i - own];
        if (i % point_chunk == 0) co_await pace;
    }
    // Where no sample fits there is nothing to begin at; but borders that are not there are a mistake.
    const bool none = sources.vertices.empty() && sources.points.empty() && !sources.edges && !sources.curves;
    if (none && seeds.sample_radius == 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s comes to nothing: the regions have no borders", argument);
    }
    co_return sources;
}

Task<void> solve_seeds(Pace& pace, const RegionTree& tree, const std::shared_ptr<Surface>& surface,
                       const LeafSet& leaves, const TangleSeeds& seeds, const char* argument, Perturbation perturbation,
                       bool labelled, DistanceField& field) {
    LeafSet own(pace.memory());
    if (!seeds.regions.empty()) own = co_await list_leaves(pace, tree, seeds.regions, argument);
    const RegionSet& within = seeds.regions.empty() ? leaves.set : own.set;
    SeedPlaces places(pace.memory());
    // What may fail comes first: GCC 12 frees members of an aggregate twice if a later one throws.
    GeodesicSources sources = co_await find_sources(pace, *surface, within, seeds, argument, places);
    RegionSet bound = leaves.set;
    const GeodesicRequest request{.surface = surface,
                                  .accuracy = FLG_ACCURACY_REFINED,
                                  .sources = std::move(sources),
                                  .regions = std::move(bound),
                                  .max_distance = unreachable,
                                  .targets = {},
                                  .labelled = labelled,
                                  .perturbation = perturbation,
                                  .out = nullptr};
    co_await solve_field(pace, request, field);
}

Task<Buffer<SurfacePoint>> find_stream_starts(Pace& pace, Surface& surface, const RegionSet& leaves,
                                              const TangleSeeds& seeds, float spacing, const char* argument) {
    const Mesh& mesh = surface.mesh();
    std::pmr::deque<SurfacePoint> points(pace.memory());
    if (seeds.borders == FLG_TANGLE_BORDERS_OUTER || !seeds.stretches.empty()) {
        RegionLoops loops(pace.memory());
        co_await find_loops(pace, mesh, leaves, seeds, argument, loops);
        const Buffer<BorderStretch> stretches = choose_stretches(loops, seeds, argument, pace.memory());
        SurfaceCurves sampled(pace.memory());
        co_await sample_loops(pace, mesh, loops, stretches, spacing, sampled);
        points = std::move(sampled.points);
    }
    if (seeds.curves) co_await sample_lines(pace, mesh, seeds.curves->curves, spacing, points);
    if (points.empty()) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s has neither outer borders nor curves for streams to begin on",
                      argument);
    }
    Buffer<SurfacePoint> starts(points.size(), pace.memory());
    for (size_t i = 0; i < starts.size(); ++i) {
        starts[i] = points[i];
        if (i % point_chunk == 0) co_await pace;
    }
    co_return starts;
}

}  // namespace flg
