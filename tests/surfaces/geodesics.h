// SPDX-License-Identifier: MIT
// The refined solver on a test mesh, in one call.
#pragma once

#include "runtime/run_now.h"
#include "surfaces/geodesics/geodesic_seeds.h"
#include "surfaces/geodesics/refined_solver.h"
#include "surfaces/test_meshes.h"

namespace flg::test {

// The field that a solver has, copied out.
inline std::vector<float> read(const RefinedSolver& solver, bool haltingly = false) {
    DistanceField field;
    run_now(
        test_memory(), [&](Pace& pace) { return take_field(pace, solver, false, field); }, haltingly);
    return {field.distances.begin(), field.distances.end()};
}

inline void solve(RefinedSolver& solver, const std::vector<Seed>& seeds, const SolveLimits& limits,
                  bool labelled = false, const GeodesicRegion* region = nullptr, bool haltingly = false) {
    run_now(
        test_memory(), [&](Pace& pace) { return solve_distances(pace, solver, seeds, limits, labelled, region); },
        haltingly);
}

struct Geodesics {
    explicit Geodesics(const Mesh& mesh, bool haltingly = false)
        : blocks(run_now(
              test_memory(), [&](Pace& pace) { return make_blocks(pace, mesh, mesh.positions); }, haltingly)) {}

    std::vector<float> distances(const std::vector<Seed>& seeds, const SolveLimits& limits = {}, bool haltingly = false,
                                 const GeodesicRegion* region = nullptr) const {
        RefinedSolver solver(blocks, test_memory());
        solve(solver, seeds, limits, false, region, haltingly);
        return read(solver, haltingly);
    }

    GeodesicBlocks blocks;
};

inline std::vector<Seed> merged(const std::pmr::deque<Seed>& found, bool haltingly = false) {
    const Buffer<Seed> seeds = run_now(
        test_memory(), [&](Pace& pace) { return merge_seeds(pace, found); }, haltingly);
    return {seeds.begin(), seeds.end()};
}

inline std::vector<Seed> merged(const GeodesicSeeds& seeds, bool haltingly = false) {
    return merged(seeds.found(), haltingly);
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
