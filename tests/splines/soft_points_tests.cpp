// SPDX-License-Identifier: MIT
// Given points with a smoothing of their own, and segments with a tension of their own.
#include <Eigen/Dense>

#include "splines/manifolds/space_manifold.h"
#include "splines/spline_checks.h"

namespace flg::test {
namespace {

Memory* const memory = std::pmr::new_delete_resource();

const std::vector<Vec3> points = {{0, 0, 0}, {1, 0.6, 0.2}, {1.8, -0.3, 0.4}, {3, 0.5, -0.1}, {4.1, 0.1, 0.3}};
const std::vector<double> times = {0, 1, 2.2, 3, 4.5};

SplineProblem problem_of(const Manifold& manifold, uint32_t intervals = 12) {
    SplineProblem problem = chain_problem(manifold, points, intervals);
    problem.parameters = Buffer<double>(times.size(), memory);
    std::copy(times.begin(), times.end(), problem.parameters.begin());
    return problem;
}

Buffer<double> buffer(const std::vector<double>& values) {
    Buffer<double> out(values.size(), memory);
    std::copy(values.begin(), values.end(), out.begin());
    return out;
}

// Where the points come to, by Reinsch's equations with the weights on the diagonal of W:
// (R + Q^T W Q) M = Q^T y, x = y - W Q M.
Eigen::MatrixXd literal_soft(const std::vector<double>& softness) {
    const auto n = static_cast<Eigen::Index>(points.size());
    Eigen::MatrixXd r = Eigen::MatrixXd::Zero(n - 2, n - 2), q = Eigen::MatrixXd::Zero(n, n - 2), y(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) y.row(i) = points[size_t(i)].transpose();
    for (Eigen::Index i = 1; i + 1 < n; ++i) {
        const double h = times[size_t(i)] - times[size_t(i - 1)], k = times[size_t(i + 1)] - times[size_t(i)];
        r(i - 1, i - 1) = (h + k) / 3;
        if (i + 2 < n) r(i - 1, i) = r(i, i - 1) = k / 6;
        q(i - 1, i - 1) = 1 / h;
        q(i, i - 1) = -1 / h - 1 / k;
        q(i + 1, i - 1) = 1 / k;
    }
    const Eigen::VectorXd w = Eigen::Map<const Eigen::VectorXd>(softness.data(), n);
    const Eigen::MatrixXd moments = (r + q.transpose() * w.asDiagonal() * q).ldlt().solve(q.transpose() * y);
    return y - w.asDiagonal() * q * moments;
}

TEST(SoftPoints, ComeToWhereReinschsEquationsSay) {
    const SpaceManifold space(3, 4);
    for (const std::vector<double>& softness :
         {std::vector<double>{0, 0.1, 0, 0.5, 0}, {0.2, 0.2, 0.2, 0.2, 0.2}, {0.3, 0, 1e-3, 0, 2}}) {
        SplineProblem problem = problem_of(space);
        problem.softness = buffer(softness);
        const SolvedSpline solved = solve_spline(problem);
        EXPECT_EQ(solved.report.ending, SplineEnding::converged);
        const Eigen::MatrixXd expected = literal_soft(softness);
        for (size_t k = 0; k < points.size(); ++k) {
            const Vec3 off = solved.points[solved.knots[k]] - expected.row(Eigen::Index(k)).transpose();
            EXPECT_LT(off.norm(), 1e-7) << k;
            if (softness[k] == 0) {
                EXPECT_EQ(solved.points[solved.knots[k]], points[k]);
            }
        }
    }
}

TEST(SoftPoints, AllAlikeAreOneSmoothingToTheBit) {
    const SpaceManifold space(3, 4);
    SplineProblem one = problem_of(space), each = problem_of(space);
    one.smoothing = 0.2;
    each.softness = buffer({0.2, 0.2, 0.2, 0.2, 0.2});
    EXPECT_EQ(solve_spline(one).points, solve_spline(each).points);
}

double excess(const SolvedSpline& solved, size_t segment) {
    double length = 0;
    for (uint32_t i = solved.knots[segment]; i < solved.knots[segment + 1]; ++i)
        length += (solved.points[i + 1] - solved.points[i]).norm();
    return length / (points[segment + 1] - points[segment]).norm() - 1;
}

// The energy by trapezoids of what is minimized, so that no step of one node leads down.
TEST(LocalTension, DrawsItsSegmentTautAndLeavesTheOthers) {
    const SpaceManifold space(3, 4);
    SplineProblem even = problem_of(space, 32), shares = problem_of(space, 32), taut = problem_of(space, 32);
    even.tension = shares.tension = taut.tension = 2;
    shares.tensions = buffer({1, 1, 1, 1});
    taut.tensions = buffer({1, 1, 500, 0});
    const SolvedSpline plain = solve_spline(even), same = solve_spline(shares), drawn = solve_spline(taut);
    for (size_t i = 0; i < plain.points.size(); ++i) EXPECT_LT((plain.points[i] - same.points[i]).norm(), 1e-9);
    EXPECT_EQ(drawn.report.ending, SplineEnding::converged);
    EXPECT_LT(excess(drawn, 2), 0.1 * excess(plain, 2));
    EXPECT_GT(excess(drawn, 3), excess(plain, 3));
}

// Between two points with tension w the second derivative solves M'' = w M: in the plane, with slopes given at both
// ends, the curve is a cubic's relative in hyperbolic functions.
TEST(LocalTension, OfOneSegmentIsTheSplineInTension) {
    const SpaceManifold space(3, 2);
    SplineProblem problem = chain_problem(space, {{0, 0, 0}, {1, 0, 0}}, 400);
    problem.parameters = buffer({0, 1});
    problem.tension = 4;
    problem.tensions = buffer({9});
    for (int e = 0; e < 2; ++e) {
        problem.has_slope[e] = true;
        problem.slopes[e][0] = 1;
        problem.slopes[e][1] = e == 0 ? 1 : -1;
    }
    const SolvedSpline solved = solve_spline(problem);
    // y'' = a cosh(p (t - 1/2)): y' from 1 to -1, y(0) = y(1) = 0.
    const double p = 6, a = -p / std::sinh(p / 2);
    for (uint32_t i = 0; i <= 400; i += 40) {
        const double t = i / 400.0;
        const double y = a / (p * p) * (std::cosh(p * (t - 0.5)) - std::cosh(p / 2));
        EXPECT_NEAR(solved.points[i].y(), y, 2e-5) << t;
    }
}

}  // namespace
}  // namespace flg::test
