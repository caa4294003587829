// SPDX-License-Identifier: MIT
#include "surfaces/geodesic_jobs.h"

#include <new>

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/geodesics/geodesic_seeds.h"
#include "surfaces/mesh/mesh_measures.h"
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

Task<void> collect_seeds(Pace& pace, const GeodesicRequest& request, GeodesicSeeds& seeds) {
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
                  [&](uint32_t i) { seeds.add_edge((*sources.edges)[i], label); });
}

struct Query {
    const Mesh& mesh;
    const RegionSet& regions;
    const Buffer<Seed>& seeds;
    const SolveLimits& limits;
    bool labelled;
    DistanceField& out;
};

Task<void> solve(Pace& pace, const Query& query, const GeodesicBlocks& blocks, RefinedSolver& solver) {
    const GeodesicRegion region = co_await bound_region(pace, query.mesh, blocks, query.regions);
    const std::span<const Seed> seeds(query.seeds.data(), query.seeds.size());
    co_await solve_distances(pace, solver, seeds, query.limits, query.labelled, &region);
    co_await take_field(pace, solver, query.labelled, query.out);
}

Task<void> solve_on_surface(Pace& pace, const Query& query, Surface& surface) {
    const GeodesicBlocks& blocks = blocks_of(surface);
    auto solver = surface.solvers.pool.lend(blocks);
    co_await solve(pace, query, blocks, *solver);
    solver.give_back();
}

Task<void> solve_perturbed(Pace& pace, const Query& query, const GrowingBuffer<Position>& positions) {
    const GeodesicBlocks blocks = co_await make_blocks(pace, query.mesh, positions);
    RefinedSolver solver(blocks, pace.memory());
    co_await solve(pace, query, blocks, solver);
}

Task<GrowingBuffer<Position>> perturbed_positions(Pace& pace, const Mesh& mesh, Perturbation perturbation) {
    const Buffer<Position> normals = co_await find_vertex_normals(pace, mesh);
    co_return co_await perturb_positions(pace, mesh, normals, perturbation);
}

}  // namespace

Task<void> build_blocks(Pace& pace, std::shared_ptr<Surface> surface) {
    pace.stage("blocks");
    try {
        GeodesicBlocks blocks = co_await make_blocks(pace, surface->mesh(), surface->mesh().positions);
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
    const bool perturbed = request.perturbation.amount > 0;
    GrowingBuffer<Position> moved;
    if (perturbed) moved = co_await perturbed_positions(pace, mesh, request.perturbation);
    const GrowingBuffer<Position>& positions = perturbed ? moved : mesh.positions;
    GeodesicSeeds collected(mesh, positions, request.regions, pace.memory());
    co_await collect_seeds(pace, request, collected);
    const Buffer<Seed> seeds = co_await merge_seeds(pace, collected.found());
    co_await check_vertices(pace, mesh, request.targets, "desc.targets");
    SolveLimits limits{.distance = request.max_distance, .targets = std::pmr::vector<uint32_t>(pace.memory())};
    limits.targets.reserve(request.targets.size());
    co_await each(pace, request.targets.size(), Cost::some_ns,
                  [&](uint32_t i) { limits.targets.push_back(request.targets[i]); });

    pace.stage("solve");
    const Query query{mesh, request.regions, seeds, limits, request.labelled, out};
    if (perturbed) {
        co_await solve_perturbed(pace, query, moved);
    } else {
        co_await solve_on_surface(pace, query, *request.surface);
    }
}

Task<void> solve_between(Pace& pace, Surface& surface, const RegionSet& regions, SurfacePoint source,
                         SurfacePoint target, DistanceField& out) {
    const Mesh& mesh = surface.mesh();
    GeodesicSeeds collected(mesh, mesh.positions, regions, pace.memory());
    collected.add_point(source, 0);
    const Buffer<Seed> seeds = co_await merge_seeds(pace, collected.found());
    const Triple& around = mesh.triangles[target.triangle];
    const SolveLimits limits{
        .distance = unreachable,
        .targets = {around.begin(), around.end(), std::pmr::polymorphic_allocator<>(pace.memory())}};
    const Query query{mesh, regions, seeds, limits, false, out};
    co_await solve_on_surface(pace, query, surface);
}

Task<void> blend_fields(Pace& pace, std::shared_ptr<const Field> from, std::shared_ptr<const Field> to,
                        std::shared_ptr<Field> out) {
    const size_t count = from->data.distances.size();
    out->data.distances = Buffer<float>(count, pace.memory());
    co_await each(pace, count, Cost::some_ns,
                  [&](uint32_t v) { out->data.distances[v] = blend(from->data.distances[v], to->data.distances[v]); });
}

}  // namespace flg
