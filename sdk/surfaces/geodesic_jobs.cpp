// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_jobs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/geodesics/exact_sources.h"
#include "surfaces/geodesics/geodesic_seeds.h"
#include "surfaces/geodesics/perturbed_blocks.h"
#include "surfaces/mesh/region_cursor.h"
#include "surfaces/mesh/region_vertices.h"
#include "surfaces/surface_inputs.h"

namespace flg {

namespace {

bool touches(const Mesh& mesh, uint32_t vertex, const RegionSet& regions) {
    const Corner first = mesh.corner_of_vertex[vertex];
    Corner corner = first;
    do {
        if (regions.contains(mesh.regions[triangle_of(corner)])) return true;
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    return false;
}

// Into GeodesicSeeds or ExactSources.
template <class Seeds>
Task<void> collect_seeds(Pace& pace, const GeodesicRequest& request, Seeds& seeds) {
    const Mesh& mesh = request.surface->mesh();
    const GeodesicSources& sources = request.sources;
    co_await check_vertices(pace, mesh, sources.vertices, "desc.vertices");
    co_await check_points(pace, mesh, sources.points, "desc.points");
    uint32_t label = 0;
    co_await each(pace, sources.vertices.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        if (touches(mesh, sources.vertices[i], request.regions)) seeds.add_vertex(sources.vertices[i], label);
        ++label;
    });
    co_await each(pace, sources.points.size(), Cost::hundreds_of_ns,
                  [&](uint32_t i) { seeds.add_point(sources.points[i], label++); });
    for (uint32_t c = 0; sources.curves && c < sources.curves->curves.curve_count(); ++c) {
        co_await add_curve(pace, sources.curves->curves, c, label++, seeds);
    }
    for (const uint32_t region : sources.border_regions) {
        const RegionSet one(&region, 1, pace.memory());
        co_await add_border(pace, mesh, one, label++, seeds);
    }
    if (!sources.edges) co_return;
    co_await each(pace, sources.edges->size(), Cost::hundreds_of_ns,
                  [&](uint32_t i) { seeds.add_edge((*sources.edges)[i], sources.edges_apart ? label + i : label); });
}

Task<SolveLimits> read_limits(Pace& pace, const GeodesicRequest& request) {
    co_await check_vertices(pace, request.surface->mesh(), request.targets, "desc.targets");
    SolveLimits limits{.distance = request.max_distance, .targets = std::pmr::vector<uint32_t>(pace.memory())};
    limits.targets.reserve(request.targets.size());
    co_await each(pace, request.targets.size(), Cost::some_ns,
                  [&](uint32_t i) { limits.targets.push_back(request.targets[i]); });
    co_return limits;
}

struct Query {
    const Mesh& mesh;
    const GrowingBuffer<Position>& positions;  // of the metric
    const RegionSet& regions;
    const Buffer<Seed>& seeds;
    const SolveLimits& limits;
    bool labelled;
    bool may_be_local;
    DistanceField& out;
};

Task<void> take_local_field(Pace& pace, const Query& query, const RefinedSolver& solver) {
    DistanceField& out = query.out;
    out.local = true;
    out.vertices = co_await vertices_of(pace, query.mesh, query.regions, RegionRim::with);
    const uint32_t count = solver.vertex_count();
    out.distances = Buffer<float>(count, pace.memory());
    out.labels = Buffer<uint32_t>(query.labelled ? count : 0, pace.memory());
    co_await each_value(pace, out, Cost::tens_of_ns, [&](uint32_t v) {
        out.distances[v] = solver.distance(v);
        if (query.labelled) out.labels[v] = solver.label(v);
    });
}

Task<void> solve(Pace& pace, const Query& query, const GeodesicBlocks& blocks, RefinedSolver& solver) {
    const GeodesicRegion region = co_await bound_region(pace, query.mesh, query.positions, blocks, query.regions);
    const std::span<const Seed> seeds(query.seeds.data(), query.seeds.size());
    co_await solve_distances(pace, solver, seeds, query.limits, query.labelled, &region);
    if (query.may_be_local && RegionCursor(query.mesh, query.regions).is_local()) {
        co_await take_local_field(pace, query, solver);
    } else {
        co_await take_field(pace, solver, query.labelled, query.out);
    }
}

// No way over the surface is shorter than the straight line from its source. Of some points that is soon looked at; of
// many only if labels tell which one counts. `places`: of the sources, by label. What comes to lie beyond the limit is
// unreachable.
Task<void> keep_above_straight_lines(Pace& pace, const Mesh& mesh, const Buffer<Vec3>& places, float limit,
                                     DistanceField& field) {
    constexpr size_t max_unlabelled = 16;
    const bool labelled = !field.labels.empty();
    if (places.empty() || (!labelled && places.size() > max_unlabelled)) co_return;
    co_await each_value(pace, field, labelled ? Cost::some_ns : Cost::tens_of_ns, [&](uint32_t v) {
        if (field.distances[v] == unreachable) return;
        const Vec3 at = mesh.position(v);
        double nearest = std::numeric_limits<double>::infinity();
        if (labelled) {
            nearest = (places[field.labels[v]] - at).squaredNorm();
        } else {
            for (const Vec3& place : places) nearest = std::min(nearest, (place - at).squaredNorm());
        }
        const auto straight = static_cast<float>(std::sqrt(nearest));
        if (!(straight > field.distances[v])) return;
        field.distances[v] = straight <= limit ? straight : unreachable;
        if (labelled && !(straight <= limit)) field.labels[v] = no_index;
    });
}

// Of sources that are points alone.
Task<Buffer<Vec3>> source_places(Pace& pace, const Mesh& mesh, const GeodesicSources& sources) {
    if (sources.curves || sources.edges || !sources.border_regions.empty()) co_return Buffer<Vec3>();
    const size_t vertices = sources.vertices.size();
    Buffer<Vec3> places(vertices + sources.points.size(), pace.memory());
    co_await each(pace, places.size(), Cost::tens_of_ns, [&](uint32_t i) {
        places[i] = i < vertices ? mesh.position(sources.vertices[i]) : position_of(mesh, sources.points[i - vertices]);
    });
    co_return places;
}

Task<void> solve_on_surface(Pace& pace, const Query& query, const GeodesicBlocks& blocks, Surface& surface) {
    auto solver = surface.solvers.pool.lend(blocks);
    co_await solve(pace, query, blocks, *solver);
    solver.give_back();
}

Task<void> solve_exactly(Pace& pace, const GeodesicRequest& request, DistanceField& out) {
    if (request.perturbation.amount > 0) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "accuracy is exact, perturbation is %g and must be 0",
                      double{request.perturbation.amount});
    }
    const Mesh& mesh = request.surface->mesh();
    const SolveLimits limits = co_await read_limits(pace, request);
    ExactFaces faces(mesh, pace.memory());
    co_await lay_out_faces(pace, mesh, request.regions, faces);
    ExactSolver solver(mesh, faces, limits, pace.memory());
    co_await begin_exact(pace, solver);
    ExactSources sources(mesh, request.regions, solver);
    co_await collect_seeds(pace, request, sources);
    pace.stage("solve");
    co_await spread_exact(pace, solver);
    co_await take_exact_field(pace, solver, request.max_distance, request.labelled, out);
    const Buffer<Vec3> places = co_await source_places(pace, mesh, request.sources);
    co_await keep_above_straight_lines(pace, mesh, places, request.max_distance, out);
}

// The vertices of sources and targets outside of the regions: where these are is asked for all the same.
Task<std::pmr::deque<uint32_t>> vertices_outside(Pace& pace, const GeodesicRequest& request) {
    const Mesh& mesh = request.surface->mesh();
    const GeodesicSources& sources = request.sources;
    co_await check_points(pace, mesh, sources.points, "desc.points");
    co_await check_vertices(pace, mesh, request.targets, "desc.targets");
    std::pmr::deque<uint32_t> vertices(pace.memory());
    const auto add = [&](const SurfacePoint& point) {
        if (request.regions.contains(mesh.regions[point.triangle])) return;
        for (const uint32_t vertex : mesh.triangles[point.triangle]) vertices.push_back(vertex);
    };
    co_await each(pace, sources.points.size(), Cost::tens_of_ns, [&](uint32_t i) { add(sources.points[i]); });
    if (sources.curves) {
        const std::pmr::deque<SurfacePoint>& points = sources.curves->curves.points;
        co_await each(pace, points.size(), Cost::tens_of_ns, [&](uint32_t i) { add(points[i]); });
    }
    co_await each(pace, request.targets.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        if (!touches(mesh, request.targets[i], request.regions)) vertices.push_back(request.targets[i]);
    });
    co_return vertices;
}

}  // namespace

Task<void> build_blocks(Pace& pace, std::shared_ptr<Surface> surface) {
    pace.stage("blocks");
    try {
        GeodesicBlocks blocks = co_await make_blocks(pace, surface->mesh(), surface->mesh().positions);
        blocks.edges.fix_mean(surface->solvers.fixed_edge);
        surface->solvers.blocks.emplace(std::move(blocks));
        surface->solvers.has_blocks = true;
    } catch (const std::bad_alloc&) {}
}

const GeodesicBlocks& blocks_of(const Surface& surface) {
    if (!surface.solvers.blocks) {
        throw Failure(FLG_ERROR_OUT_OF_MEMORY,
                      "memory ran out when what distances are computed with was built, or followed a cut");
    }
    return *surface.solvers.blocks;
}

Task<void> solve_geodesic(Pace& pace, GeodesicRequest request, std::shared_ptr<Field> out) {
    co_await solve_field(pace, request, out->data);
}

Task<void> solve_field(Pace& pace, const GeodesicRequest& request, DistanceField& out) {
    const Mesh& mesh = request.surface->mesh();
    pace.stage("sources");
    if (request.exact) {
        co_await solve_exactly(pace, request, out);
        co_return;
    }
    const bool perturbed = request.perturbation.amount > 0;
    std::optional<PerturbedMetric> metric;
    if (perturbed) {
        const std::pmr::deque<uint32_t> also = co_await vertices_outside(pace, request);
        metric.emplace(co_await perturb_metric(pace, mesh, blocks_of(*request.surface), request.regions, also,
                                               request.perturbation));
    }
    const GrowingBuffer<Position>& positions = perturbed ? metric->positions : mesh.positions;
    const GeodesicBlocks& blocks = perturbed ? metric->blocks : blocks_of(*request.surface);
    GeodesicSeeds collected(mesh, positions, request.regions, pace.memory(), &blocks.flipped);
    co_await collect_seeds(pace, request, collected);
    const Buffer<Seed> seeds = co_await merge_seeds(pace, collected.found());
    const SolveLimits limits = co_await read_limits(pace, request);

    pace.stage("solve");
    const Query query{mesh, positions, request.regions, seeds, limits, request.labelled, request.may_be_local, out};
    if (perturbed) {
        RefinedSolver solver(blocks, pace.memory());
        co_await solve(pace, query, blocks, solver);
        co_return;
    }
    co_await solve_on_surface(pace, query, blocks, *request.surface);
    const Buffer<Vec3> places = co_await source_places(pace, mesh, request.sources);
    co_await keep_above_straight_lines(pace, mesh, places, request.max_distance, out);
}

Task<void> solve_between(Pace& pace, Surface& surface, const RegionSet& regions, SurfacePoint source,
                         SurfacePoint target, DistanceField& out) {
    const Mesh& mesh = surface.mesh();
    const GeodesicBlocks& blocks = blocks_of(surface);
    GeodesicSeeds collected(mesh, mesh.positions, regions, pace.memory(), &blocks.flipped);
    collected.add_point(source, 0);
    const Buffer<Seed> seeds = co_await merge_seeds(pace, collected.found());
    const Triple& around = mesh.triangles[target.triangle];
    const SolveLimits limits{
        .distance = unreachable,
        .targets = {around.begin(), around.end(), std::pmr::polymorphic_allocator<>(pace.memory())}};
    const Query query{mesh, mesh.positions, regions, seeds, limits, false, false, out};
    co_await solve_on_surface(pace, query, blocks, surface);
    Buffer<Vec3> places(1, pace.memory());
    places[0] = collected.place(source);
    co_await keep_above_straight_lines(pace, mesh, places, unreachable, out);
}

Task<void> blend_fields(Pace& pace, std::shared_ptr<const Field> from, std::shared_ptr<const Field> to,
                        std::shared_ptr<Field> out) {
    const size_t count = from->data.distances.size();
    out->data.distances = Buffer<float>(count, pace.memory());
    co_await each(pace, count, Cost::some_ns,
                  [&](uint32_t v) { out->data.distances[v] = blend(from->data.distances[v], to->data.distances[v]); });
}

}  // namespace flg
