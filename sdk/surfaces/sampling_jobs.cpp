// SPDX-License-Identifier: MIT
#include "surfaces/sampling_jobs.h"

#include "surfaces/geodesic_jobs.h"
#include "surfaces/sampling/border_sampling.h"
#include "surfaces/sampling/poisson_sampling.h"

namespace flg {

namespace {

Buffer<BorderStretch> whole_loops(const RegionLoops& loops, Memory* memory) {
    Buffer<BorderStretch> stretches(loops.count(), memory);
    for (uint32_t l = 0; l < loops.count(); ++l) stretches[l] = {.loop = l};
    return stretches;
}

}  // namespace

Task<void> sample_surface(Pace& pace, FlgSurfaceSampleDesc desc, RegionSet regions, std::shared_ptr<Field> out) {
    pace.stage("sample");
    Surface& surface = *out->surface;
    const Mesh& mesh = surface.mesh();
    const SolveLimits limits{.distance = unreachable, .targets = std::pmr::vector<uint32_t>(pace.memory())};
    const GeodesicBlocks& blocks = blocks_of(surface);
    const GeodesicRegion bound = co_await bound_region(pace, mesh, mesh.positions, blocks, regions);
    auto solver = surface.solvers.pool.lend(blocks);
    const std::span<const Seed> nothing;
    co_await solve_distances(pace, *solver, nothing, limits, true, &bound);
    const uint32_t most = desc.max_count == 0 ? UINT32_MAX : desc.max_count;
    out->samples = co_await sample_poisson(pace, mesh, regions, *solver, desc.radius, most, desc.seed);
    co_await take_field(pace, *solver, true, out->data);
    solver.give_back();
}

Task<void> sample_border(Pace& pace, uint32_t region, float spacing, std::shared_ptr<TracedCurves> out) {
    pace.stage("sample");
    const RegionSet regions(&region, 1, pace.memory());
    const Mesh& mesh = out->surface->mesh();
    const RegionLoops loops = co_await find_region_loops(pace, mesh, regions);
    const Buffer<BorderStretch> stretches = whole_loops(loops, pace.memory());
    co_await sample_stretches(pace, mesh, loops, stretches, spacing, 1, out->curves);
    co_await flatten_curves(pace, *out);
}

}  // namespace flg
