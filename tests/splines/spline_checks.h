// SPDX-License-Identifier: MIT
// Problems for the optimizer, and what holds for every curve it is done with.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "core/vec.h"
#include "runtime/run_now.h"
#include "splines/optimizer/spline_optimizer.h"

namespace flg::test {

// A chain through points of a manifold in R^3, straight between them, with so many intervals from one to the next.
inline SplineProblem chain_problem(const Manifold& manifold, const std::vector<Vec3>& given, uint32_t intervals,
                                   bool closed = false) {
    Memory* const memory = std::pmr::new_delete_resource();
    const uint32_t count = static_cast<uint32_t>(given.size()), segments = closed ? count : count - 1;
    const uint32_t nodes = segments * intervals + (closed ? 0 : 1);
    SplineProblem problem;
    problem.manifold = &manifold;
    problem.closed = closed;
    problem.points = Buffer<double>(size_t{3} * nodes, memory);
    problem.knots = Buffer<uint32_t>(count, memory);
    problem.given = Buffer<double>(size_t{3} * count, memory);
    std::vector<double> own(manifold.hint_size());
    std::vector<Vec3> at = given;
    for (uint32_t i = 0; i < count; ++i) {
        std::fill(own.begin(), own.end(), 0.0);
        EXPECT_TRUE(manifold.project(at[i].data(), own.data()));
        problem.knots[i] = i * intervals;
        std::copy_n(at[i].data(), 3, &problem.given[size_t{3} * i]);
    }
    for (uint32_t i = 0; i < nodes; ++i) {
        const double t = static_cast<double>(i % intervals) / intervals;
        const Vec3 x = at[i / intervals] * (1 - t) + at[(i / intervals + 1) % count] * t;
        std::copy_n(x.data(), 3, &problem.points[size_t{3} * i]);
    }
    return problem;
}

struct SolvedSpline {
    SplineReport report;
    std::vector<Vec3> points;
    std::vector<double> steps;
    std::vector<uint32_t> knots;
};

inline SolvedSpline solve_spline(SplineProblem& problem, bool haltingly = false) {
    Memory* const memory = std::pmr::new_delete_resource();
    SplineOptimizer optimizer(problem, memory);
    run_now(
        memory, [&](Pace& pace) { return SplineOptimizer::minimize(pace, optimizer); }, haltingly);
    SolvedSpline out;
    out.report = optimizer.report();
    for (uint32_t i = 0; i < optimizer.nodes(); ++i) {
        const double* const x = optimizer.points() + size_t{3} * i;
        out.points.emplace_back(x[0], x[1], x[2]);
        out.steps.push_back(optimizer.step_after(i));
    }
    out.knots.assign(problem.knots.begin(), problem.knots.end());
    return out;
}

// Points of a closed wave around the z-axis, near to a sphere of radius 1 and to a torus of 1 and something.
inline std::vector<Vec3> wave(uint32_t count, double radius, double height) {
    std::vector<Vec3> points;
    for (uint32_t i = 0; i < count; ++i) {
        const double a = 2 * M_PI * i / count;
        points.emplace_back(radius * std::cos(a), radius * std::sin(a), height * std::sin(2.3 * i));
    }
    return points;
}

}  // namespace flg::test
