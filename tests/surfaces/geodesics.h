// SPDX-License-Identifier: MIT
// The refined solver on a test mesh, in one call.
#pragma once

#include "surfaces/geodesic_seeds.h"
#include "surfaces/refined_solver.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

inline std::vector<float> solve(RefinedSolver& solver, uint32_t vertex_count, uint32_t slice = 1000) {
    while (!solver.run(slice)) {}
    DistanceField field;
    DistanceFieldKernel copy(solver, vertex_count, false, field, test_memory());
    while (!copy.run(slice)) {}
    return {field.distances.begin(), field.distances.end()};
}

struct Geodesics {
    explicit Geodesics(const Mesh& mesh, uint32_t slice = 1000)
        : blocks(test_memory()), vertex_count(mesh.vertex_count()) {
        GeodesicBlocksKernel kernel(mesh, blocks, test_memory());
        while (!kernel.run(slice)) {}
    }
    std::vector<float> distances(const std::vector<Seed>& seeds, const SolveLimits& limits = {}, uint32_t slice = 1000,
                                 const GeodesicRegion* region = nullptr) {
        RefinedSolver solver(blocks, test_memory());
        solver.begin(seeds, limits, false, region);
        return solve(solver, vertex_count, slice);
    }

    GeodesicBlocks blocks;
    uint32_t vertex_count;
};

inline std::vector<Seed> merged(const GeodesicSeeds& seeds, uint32_t slice = 1000) {
    SeedMergeKernel kernel(seeds.found(), test_memory());
    while (!kernel.run(slice)) {}
    return {kernel.seeds().begin(), kernel.seeds().end()};
}

// Root mean square of relative errors.
inline double rms_error(const std::vector<float>& distances, const std::function<double(uint32_t)>& expected) {
    double sum = 0;
    uint32_t count = 0;
    for (uint32_t v = 0; v < distances.size(); ++v) {
        const double distance = expected(v);
        if (distance == 0) continue;
        const double error = distances[v] / distance - 1;
        sum += error * error;
        ++count;
    }
    return std::sqrt(sum / count);
}

}  // namespace flg::test
