// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_jobs.h"

#include <new>

#include "core/failure.h"
#include "surfaces/field_blend.h"
#include "surfaces/geodesic_seeds.h"
#include "surfaces/mesh_measures_normals.h"
#include "surfaces/perturbed_metric.h"
#include "surfaces/solve_field.h"
#include "surfaces/surface_inputs.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t build_chunk = 100;
constexpr uint32_t solve_chunk = 100;
constexpr uint32_t source_chunk = 20;
constexpr uint32_t border_chunk = 1000;
constexpr uint32_t merge_chunk = 1000;
constexpr uint32_t copy_chunk = 2000;
constexpr uint32_t normals_chunk = 200;
constexpr uint32_t perturb_chunk = 100;

bool touches(const Mesh& mesh, uint32_t vertex, const RegionSet& regions) {
    const Corner first = mesh.corner_of_vertex[vertex];
    Corner corner = first;
    do {
        if (regions.contains(mesh.regions[triangle_of(corner)])) return true;
        corner = mesh.turn(corner);
    } while (corner != first && corner != no_index);
    return false;
}

Task<void> collect_seeds(Pace& pace, const GeodesicRequest& request, GeodesicSeeds& seeds) {
    const Mesh& mesh = request.surface->mesh();
    const GeodesicSources& sources = request.sources;
    co_await check_vertices(pace, mesh, sources.vertices, "desc.vertices");
    co_await check_points(pace, mesh, sources.points, "desc.points");
    uint32_t label = 0;
    for (const uint32_t vertex : sources.vertices) {
        if (touches(mesh, vertex, request.regions)) seeds.add_vertex(vertex, label);
        if (++label % source_chunk == 0) co_await pace;
    }
    for (const SurfacePoint& point : sources.points) {
        seeds.add_point(point, label);
        if (++label % source_chunk == 0) co_await pace;
    }
    for (uint32_t c = 0; sources.curves && c < sources.curves->curves.curve_count(); ++c) {
        CurveSeedsKernel kernel(sources.curves->curves, c, label++, seeds);
        while (!kernel.run(source_chunk)) co_await pace;
    }
    for (const uint32_t region : sources.border_regions) {
        const RegionSet one(&region, 1, pace.memory());
        BorderSeedsKernel kernel(mesh, one, label++, seeds);
        while (!kernel.run(border_chunk)) co_await pace;
    }
    for (size_t i = 0; sources.edges && i < sources.edges->size(); ++i) {
        seeds.add_edge((*sources.edges)[i], label);
        if (i % source_chunk == 0) co_await pace;
    }
}

// A question without its accuracy.
struct Query {
    const Mesh& mesh;
    const RegionSet& regions;
    std::span<const Seed> seeds;
    const SolveLimits& limits;
    bool labelled;
    DistanceField& out;
};

Task<void> solve_refined(Pace& pace, const Query& query, const GeodesicBlocks& blocks, RefinedSolver& solver) {
    GeodesicRegion region(pace.memory());
    const GeodesicRegion* bound = co_await bound_region(pace, query.mesh, blocks, query.regions, region);
    solver.begin(query.seeds, query.limits, query.labelled, bound);
    while (!solver.run(solve_chunk)) co_await pace;
    co_await take_field(pace, solver, query.mesh.vertex_count(), query.labelled, query.out);
}

Task<void> solve_graph(Pace& pace, const Query& query, GraphSolver& solver) {
    solver.begin(query.seeds, query.limits, query.regions, query.labelled);
    while (!solver.run(solve_chunk)) co_await pace;
    co_await take_field(pace, solver, query.mesh.vertex_count(), query.labelled, query.out);
}

Task<void> fill_blocks(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicBlocks& blocks) {
    GeodesicBlocksKernel kernel(mesh, positions, blocks, pace.memory());
    while (!kernel.run(build_chunk)) co_await pace;
}

Task<void> fill_graph(Pace& pace, const Mesh& mesh, const GrowingBuffer<Position>& positions, GeodesicGraph& graph) {
    GeodesicGraphKernel kernel(mesh, positions, graph, pace.memory());
    while (!kernel.run(build_chunk)) co_await pace;
}

Task<GrowingBuffer<Position>> perturb_positions(Pace& pace, const Mesh& mesh, const Perturbation& perturbation) {
    VertexNormalsKernel normals_kernel(mesh, pace.memory());
    while (!normals_kernel.run(normals_chunk)) co_await pace;
    const Buffer<Position> normals = normals_kernel.take();
    GrowingBuffer<Position> positions(pace.memory());
    PerturbedMetricKernel kernel(mesh, normals, perturbation.amount, perturbation.frequency, perturbation.seed,
                                 positions, pace.memory());
    while (!kernel.run(perturb_chunk)) co_await pace;
    co_return positions;
}

Task<void> solve_on_surface(Pace& pace, const Query& query, FlgAccuracy accuracy, Surface& surface) {
    GeodesicSolvers& solvers = surface.solvers;
    if (accuracy == FLG_ACCURACY_GRAPH) {
        auto solver = solvers.graphs.lend(query.mesh, query.mesh.positions, graph_of(surface), pace.memory());
        co_await solve_graph(pace, query, *solver);
        solver.give_back();
    } else {
        const GeodesicBlocks& blocks = blocks_of(surface);
        auto solver = solvers.refined.lend(blocks, pace.memory());
        co_await solve_refined(pace, query, blocks, *solver);
        solver.give_back();
    }
}

Task<void> solve_perturbed(Pace& pace, const Query& query, FlgAccuracy accuracy,
                           const GrowingBuffer<Position>& positions) {
    if (accuracy == FLG_ACCURACY_GRAPH) {
        GeodesicGraph graph(pace.memory());
        co_await fill_graph(pace, query.mesh, positions, graph);
        GraphSolver solver(query.mesh, positions, graph, pace.memory());
        co_await solve_graph(pace, query, solver);
    } else {
        GeodesicBlocks blocks(pace.memory());
        co_await fill_blocks(pace, query.mesh, positions, blocks);
        RefinedSolver solver(blocks, pace.memory());
        co_await solve_refined(pace, query, blocks, solver);
    }
}

}  // namespace

Task<void> build_blocks(Pace& pace, std::shared_ptr<Surface> surface) {
    pace.stage("blocks");
    try {
        GeodesicBlocks blocks(pace.memory());
        co_await fill_blocks(pace, surface->mesh(), surface->mesh().positions, blocks);
        surface->solvers.blocks.emplace(std::move(blocks));
        surface->solvers.has_blocks = true;
    } catch (const std::bad_alloc&) {}
}

Task<void> build_graph(Pace& pace, std::shared_ptr<Surface> surface) {
    pace.stage("graph");
    try {
        GeodesicGraph graph(pace.memory());
        co_await fill_graph(pace, surface->mesh(), surface->mesh().positions, graph);
        surface->solvers.graph.emplace(std::move(graph));
        surface->solvers.has_graph = true;
    } catch (const std::bad_alloc&) {}
}

Task<void> solve_geodesic(Pace& pace, GeodesicRequest request) {
    co_await solve_field(pace, request, request.out->data);
}

Task<void> solve_field(Pace& pace, const GeodesicRequest& request, DistanceField& out) {
    const Mesh& mesh = request.surface->mesh();
    pace.stage("sources");
    const bool perturbed = request.perturbation.amount > 0;
    GrowingBuffer<Position> moved;
    if (perturbed) moved = co_await perturb_positions(pace, mesh, request.perturbation);
    const GrowingBuffer<Position>& positions = perturbed ? moved : mesh.positions;
    GeodesicSeeds collected(mesh, positions, request.regions, pace.memory());
    co_await collect_seeds(pace, request, collected);
    SeedMergeKernel merge(collected.found(), pace.memory());
    while (!merge.run(merge_chunk)) co_await pace;
    co_await check_vertices(pace, mesh, request.targets, "desc.targets");
    SolveLimits limits{.distance = request.max_distance, .targets = std::pmr::vector<uint32_t>(pace.memory())};
    limits.targets.reserve(request.targets.size());
    for (const uint32_t target : request.targets) {
        limits.targets.push_back(target);
        if (limits.targets.size() % copy_chunk == 0) co_await pace;
    }

    pace.stage("solve");
    const Query query{mesh, request.regions, merge.seeds(), limits, request.labelled, out};
    if (perturbed) {
        co_await solve_perturbed(pace, query, request.accuracy, moved);
    } else {
        co_await solve_on_surface(pace, query, request.accuracy, *request.surface);
    }
}

Task<void> solve_between(Pace& pace, Surface& surface, const RegionSet& regions, SurfacePoint source,
                         SurfacePoint target, DistanceField& out) {
    const Mesh& mesh = surface.mesh();
    GeodesicSeeds collected(mesh, mesh.positions, regions, pace.memory());
    collected.add_point(source, 0);
    SeedMergeKernel merge(collected.found(), pace.memory());
    while (!merge.run(merge_chunk)) co_await pace;
    const Triple& around = mesh.triangles[target.triangle];
    const SolveLimits limits{
        .distance = unreachable,
        .targets = {around.begin(), around.end(), std::pmr::polymorphic_allocator<>(pace.memory())}};
    const Query query{mesh, regions, merge.seeds(), limits, false, out};
    co_await solve_on_surface(pace, query, FLG_ACCURACY_REFINED, surface);
}

Task<void> blend_fields(Pace& pace, std::shared_ptr<const Field> from, std::shared_ptr<const Field> to,
                        std::shared_ptr<Field> out) {
    const size_t count = from->data.distances.size();
    out->data.distances = Buffer<float>(count, pace.memory());
    for (size_t v = 0; v < count; ++v) {
        out->data.distances[v] = blend(from->data.distances[v], to->data.distances[v]);
        if (v % copy_chunk == 0) co_await pace;
    }
}

}  // namespace flg
