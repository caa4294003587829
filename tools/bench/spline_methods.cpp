// SPDX-License-Identifier: MIT
// How many rounds the optimizer takes, against plain projected gradient descent and the paper's footpoint cone (the
// literal versions), from the same first chain to the same residual. Few nodes: the plain one's rounds grow with the
// fourth power of their number.
#include <algorithm>
#include <cmath>

#include "bench/splines.h"
#include "core/vec.h"
#include "reference/literal_splines.h"
#include "runtime/run_now.h"
#include "splines/manifolds/implicit_surfaces.h"
#include "splines/optimizer/spline_optimizer.h"

namespace flg::bench {
namespace {

constexpr uint32_t kMaxRounds = 5000;

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

uint32_t newton_rounds(const Manifold& torus, const Chain& chain) {
    Memory* const memory = std::pmr::new_delete_resource();
    SplineProblem problem;
    problem.manifold = &torus;
    problem.tolerance = kSplineTolerance;
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
    SplineOptimizer optimizer(problem, memory);
    run_now(memory, [&](Pace& pace) { return SplineOptimizer::minimize(pace, optimizer); });
    return optimizer.report().rounds;
}

reference::LiteralSpline literal_of(const Manifold& torus, const Chain& chain) {
    reference::LiteralSpline literal;
    literal.manifold = &torus;
    literal.steps.assign(chain.nodes.size() - 1, 1.0 / chain.intervals);
    literal.points.resize(3, static_cast<Eigen::Index>(chain.nodes.size()));
    for (size_t i = 0; i < chain.nodes.size(); ++i) {
        literal.points.col(static_cast<Eigen::Index>(i)) = chain.nodes[i];
        literal.fixed.push_back(i % chain.intervals == 0);
    }
    return literal;
}

}  // namespace

std::vector<Row> spline_methods() {
    const TorusSurface torus(1, 0.4);
    std::vector<Row> rows;
    char note[128];
    for (const uint32_t intervals : {4u, 8u}) {
        const Chain chain = chain_on(torus, intervals);
        const uint32_t newton = newton_rounds(torus, chain);
        reference::LiteralSpline by_cone = literal_of(torus, chain), by_descent = by_cone;
        const uint32_t cone = reference::minimize(by_cone, kSplineTolerance, kMaxRounds).rounds;
        const uint32_t plain = reference::minimize_by_gradient(by_descent, kSplineTolerance, kMaxRounds).rounds;
        const std::string about = std::to_string(intervals) + " intervals";
        std::snprintf(note, sizeof note, "%u rounds, plain %u%s, cone %u", newton, plain,
                      plain == kMaxRounds ? " and not there yet" : "", cone);
        rows.push_back(
            below("rounds over those of plain descent, " + about, static_cast<double>(newton) / plain, "", 0.1, note));
        rows.push_back(below("rounds over those of the footpoint cone, " + about, static_cast<double>(newton) / cone,
                             "", 1, note));
    }
    return rows;
}

}  // namespace flg::bench
