// SPDX-License-Identifier: MIT
#include "surfaces/sampling_jobs.h"

#include "surfaces/border_sampling.h"
#include "surfaces/poisson_sampling.h"
#include "surfaces/solve_field.h"

namespace flg {

namespace {

// Each about 10 us.
constexpr uint32_t sample_chunk = 50;
constexpr uint32_t border_chunk = 500;

Buffer<BorderStretch> whole_loops(const RegionLoops& loops, Memory* memory) {
    Buffer<BorderStretch> stretches(loops.count(), memory);
    for (uint32_t l = 0; l < loops.count(); ++l) stretches[l] = {.loop = l};
    return stretches;
}

}  // namespace

Task<void> sample_surface(Pace& pace, SamplingRequest request) {
    pace.stage("sample");
    const Mesh& mesh = request.surface->mesh();
    const SolveLimits limits{.distance = unreachable, .targets = std::pmr::vector<uint32_t>(pace.memory())};
    const GeodesicBlocks& blocks = blocks_of(*request.surface);
    GeodesicRegion region(pace.memory());
    const GeodesicRegion* bound = co_await bound_region(pace, mesh, blocks, request.regions, region);
    auto solver = request.surface->solvers.refined.lend(blocks, pace.memory());
    solver->begin({}, limits, true, bound);
    while (!solver->run(sample_chunk)) co_await pace;
    PoissonSamplingKernel kernel(mesh, request.regions, *solver, request.radius, request.max_count, request.seed,
                                 pace.memory());
    while (!kernel.run(sample_chunk)) co_await pace;
    Field& out = *request.out;
    out.samples = co_await flatten(pace, kernel.samples());
    co_await take_field(pace, *solver, mesh.vertex_count(), true, out.data);
    solver.give_back();
}

Task<void> sample_border(Pace& pace, uint32_t region, float spacing, std::shared_ptr<TracedCurves> out) {
    pace.stage("sample");
    const RegionSet regions(&region, 1, pace.memory());
    const Mesh& mesh = out->surface->mesh();
    RegionLoops loops(pace.memory());
    RegionLoopsKernel find(mesh, regions, loops, pace.memory());
    while (!find.run(border_chunk)) co_await pace;
    const Buffer<BorderStretch> stretches = whole_loops(loops, pace.memory());
    BorderSamplingKernel kernel(mesh, loops, {stretches.data(), stretches.size()}, spacing, out->curves);
    while (!kernel.run(border_chunk)) co_await pace;
    FlattenCurvesKernel flatten_curves(*out, pace.memory());
    while (!flatten_curves.run(border_chunk)) co_await pace;
}

}  // namespace flg
