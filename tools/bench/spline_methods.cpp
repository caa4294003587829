// SPDX-License-Identifier: MIT
// How many rounds the optimizer takes, against plain projected gradient descent (the literal version) and the paper's footpoint
// cone, from the same first chain to the same residual. Few nodes: the plain one's rounds grow with the fourth power of their number.
#include <algorithm>
#include <cmath>

#include "bench/splines.h"
#include "core/vec.h"
#include "reference/literal_splines.h"
#include "splines/implicit_surfaces.h"
#include "splines/spline_kernel.h"

namespace flg::bench {
namespace {

constexpr uint32_t kMostRounds = 5000, kTimedRounds = 2000, kTimedIntervals = 32;

struct Chain {
    uint32_t intervals;
    std::vector<Vec3> given;
    std::vector<Vec3> nodes;
};

// Straight from point to point, projected.
Chain chain_on(const Manifold& torus, uint32_t intervals) {
    Chain chain{intervals, {}, {}};
    const std::vector<double> at = winding_points();
    for (uint32_t i = 0; i < kSplinePoints; ++i) {
        Vec3 point(at[size_t{3} * i], at[size_t{3} * i + 1], at[size_t{3} * i + 2]);
        torus.project(point.data(), nullptr);
        chain.given.push_back(point);
    }
    for (uint32_t i = 0; i <= (kSplinePoints - 1) * intervals; ++i) {
        const double t = static_cast<double>(i % intervals) / intervals;
        const size_t next = std::min<size_t>(i / intervals + 1, kSplinePoints - 1);
        Vec3 point = chain.given[i / intervals] * (1 - t) + chain.given[next] * t;
        if (t > 0) torus.project(point.data(), nullptr);
        chain.nodes.push_back(point);
    }
    return chain;
}

struct Run {
    uint32_t rounds = 0;
    double ms = 0;
};

Run run_kernel(const Manifold& torus, const Chain& chain, SplineMethod method) {
    Memory* const memory = std::pmr::new_delete_resource();
    SplineProblem problem;
    problem.manifold = &torus;
    problem.method = method;
    problem.tolerance = kSplineTolerance;
    problem.max_rounds = kTimedRounds;
    problem.points = Buffer<double>(3 * chain.nodes.size(), memory);
    problem.knots = Buffer<uint32_t>(kSplinePoints, memory);
    problem.given = Buffer<double>(size_t{3} * kSplinePoints, memory);
    problem.parameters = Buffer<double>(kSplinePoints, memory);
    for (size_t i = 0; i < chain.nodes.size(); ++i) std::copy_n(chain.nodes[i].data(), 3, &problem.points[3 * i]);
    for (uint32_t i = 0; i < kSplinePoints; ++i) {
        problem.knots[i] = i * chain.intervals;
        std::copy_n(chain.given[i].data(), 3, &problem.given[size_t{3} * i]);
        problem.parameters[i] = i;
    }
    Run run;
    run.ms = time_ms([&] {
        SplineKernel kernel(problem, memory);
        while (!kernel.run(1000)) continue;
        run.rounds = kernel.report().rounds;
    });
    return run;
}

uint32_t plain_rounds(const Manifold& torus, const Chain& chain) {
    reference::LiteralSpline literal;
    literal.manifold = &torus;
    literal.steps.assign(chain.nodes.size() - 1, 1.0 / chain.intervals);
    literal.points.resize(3, static_cast<Eigen::Index>(chain.nodes.size()));
    for (size_t i = 0; i < chain.nodes.size(); ++i) {
        literal.points.col(static_cast<Eigen::Index>(i)) = chain.nodes[i];
        literal.fixed.push_back(i % chain.intervals == 0);
    }
    return reference::minimize_by_gradient(literal, kSplineTolerance, kMostRounds).rounds;
}

}  // namespace

std::vector<Row> spline_methods() {
    const TorusSurface torus(1, 0.4);
    std::vector<Row> rows;
    char note[128];
    for (const uint32_t intervals : {4u, 8u}) {
        const Chain chain = chain_on(torus, intervals);
        const uint32_t newton = run_kernel(torus, chain, SplineMethod::newton).rounds;
        const uint32_t cone = run_kernel(torus, chain, SplineMethod::footpoint_cone).rounds;
        const uint32_t plain = plain_rounds(torus, chain);
        std::snprintf(note, sizeof note, "%u rounds, plain %u%s, cone %u", newton, plain,
                      plain == kMostRounds ? " and not there yet" : "", cone);
        rows.push_back(below("rounds over those of plain descent, " + std::to_string(intervals) + " intervals",
                             static_cast<double>(newton) / plain, "", 0.1, note));
    }
    const Chain chain = chain_on(torus, kTimedIntervals);
    Run newton, cone;
    const double newton_ms =
        median_ms(21, [&] { return (newton = run_kernel(torus, chain, SplineMethod::newton)).ms; });
    const double cone_ms =
        median_ms(5, [&] { return (cone = run_kernel(torus, chain, SplineMethod::footpoint_cone)).ms; });
    std::snprintf(note, sizeof note, "%u rounds of %u, %.3g ms of %.3g", newton.rounds, cone.rounds, newton_ms,
                  cone_ms);
    rows.push_back(below("Newton over the footpoint cone, M = 279, time", newton_ms / cone_ms, "", 1, note));
    return rows;
}

}  // namespace flg::bench
