// SPDX-License-Identifier: MIT
// The optimizer against closed forms, what characterizes minimizers (Hofer, Pottmann 2004, sec. 2), and the paper's own
// steps.
#include "splines/optimizer/spline_optimizer.h"

#include "reference/literal_splines.h"
#include "splines/manifolds/implicit_surfaces.h"
#include "splines/manifolds/space_manifold.h"
#include "splines/optimizer/natural_cubic.h"
#include "splines/spline_checks.h"

namespace flg::test {
namespace {

const std::vector<Vec3> zigzag = {{0, 0, 0}, {0.3, 0.5, 0}, {1, -0.2, 0}, {1.2, 0.7, 0}, {2, 0.1, 0}, {2.1, -0.6, 0}};

// The classical spline with the parameters that the optimizer settled on, at all its nodes.
void expect_classical(const SolvedSpline& solved, const SplineProblem& problem, double tension, double tolerance) {
    std::vector<double> knots{0};
    for (size_t i = 0; i < solved.steps.size(); ++i) {
        if (solved.steps[i] > 0) knots.push_back(knots.back() + solved.steps[i]);
    }
    const std::vector<double> times = knots;
    std::vector<double> at_knots;
    for (const uint32_t knot : solved.knots) at_knots.push_back(times[knot]);
    if (problem.closed) at_knots.push_back(times.back());
    CubicData data{.knots = at_knots, .values = {problem.given.data(), problem.given.size()}};
    data.ends = problem.closed ? CubicEnds::periodic : problem.has_slope[0] ? CubicEnds::clamped : CubicEnds::natural;
    const double slopes[6] = {problem.slopes[0][0], problem.slopes[0][1], problem.slopes[0][2],
                              problem.slopes[1][0], problem.slopes[1][1], problem.slopes[1][2]};
    data.slopes = slopes;
    data.tension = tension;
    const NaturalCubic classical =
        run_now(std::pmr::new_delete_resource(), [&](Pace& pace) { return natural_cubic(pace, data); });
    for (size_t i = 0; i < solved.points.size(); ++i) {
        Vec3 exact;
        classical.evaluate(times[i], 0, exact.data());
        EXPECT_LT((exact - solved.points[i]).norm(), tolerance) << i;
    }
    if (tension == 0) {
        EXPECT_NEAR(solved.report.bending, classical.energy(), 1e-9 * classical.energy());
    }
}

TEST(SplineOptimizer, InThePlaneTheEnergyGivesTheNaturalCubic) {
    const PlaneSurface plane(2);
    for (const bool closed : {false, true}) {
        SplineProblem problem = chain_problem(plane, zigzag, 29, closed);
        const SolvedSpline solved = solve_spline(problem);
        EXPECT_EQ(solved.report.ending, SplineEnding::converged);
        expect_classical(solved, problem, 0, 1e-9);
    }
}

TEST(SplineOptimizer, InSpaceTheEnergyGivesTheNaturalCubicAndPrescribedSlopes) {
    const SpaceManifold space(3, 2);
    std::vector<Vec3> points = zigzag;
    for (size_t i = 0; i < points.size(); ++i) points[i].z() = 0.3 * std::cos(2.0 * i);
    SplineProblem natural = chain_problem(space, points, 17);
    expect_classical(solve_spline(natural), natural, 0, 1e-9);
    SplineProblem clamped = chain_problem(space, points, 17);
    const double slopes[2][3] = {{0.2, 1, -0.4}, {1, 0, 0.5}};
    for (int e = 0; e < 2; ++e) {
        clamped.has_slope[e] = true;
        std::copy_n(slopes[e], 3, clamped.slopes[e]);
    }
    expect_classical(solve_spline(clamped), clamped, 0, 1e-9);
}

// E1 of the chain is that of the polyline: the error is of the second order.
TEST(SplineOptimizer, WithTensionThePlanesCurveConvergesToTheSplineInTension) {
    const PlaneSurface plane(2);
    double last = 0;
    for (const uint32_t intervals : {20u, 40u}) {
        SplineProblem problem = chain_problem(plane, zigzag, intervals);
        problem.tension = 30;
        const SolvedSpline solved = solve_spline(problem);
        expect_classical(solved, problem, 30, intervals == 20 ? 4e-4 : 1e-4);
        last = solved.report.residual;
    }
    EXPECT_LT(last, 1e-6);
}

// The plane with a winding step in it: points are projected straight down, and jump where they pass the step.
class SteppedPlane final : public Manifold {
public:
    explicit SteppedPlane(double edge) : Manifold(3, 2, 0, 2), edge_(edge) {}
    bool project(double* x, double*) const override {
        x[2] = x[0] < edge_ + 0.2 * std::sin(9 * x[1]) ? 0 : 0.1;
        return true;
    }
    void tangent_basis(const double*, double*, double* basis) const override {
        const double rows[6] = {1, 0, 0, 0, 1, 0};
        std::copy_n(rows, 6, basis);
    }

private:
    double edge_;
};

// No step of the whole curve leads down once a node would have to jump; held there, the others come to rest.
TEST(SplineOptimizer, NodesAreHeldWhereTheSurfaceHasAStep) {
    uint32_t held = 0, stalled = 0;
    for (int i = 0; i < 100; ++i) {
        const SteppedPlane stepped(0.2 + 0.017 * i);
        SplineProblem holding = chain_problem(stepped, zigzag, 29), plain = chain_problem(stepped, zigzag, 29);
        holding.holds_nodes = true;
        const SolvedSpline solved = solve_spline(holding);
        stalled += solve_spline(plain).report.ending == SplineEnding::stalled ? 1 : 0;
        EXPECT_EQ(solved.report.ending, SplineEnding::converged) << i;
        EXPECT_LE(solved.report.held, 6u) << i;
        held += solved.report.held;
    }
    EXPECT_GT(stalled, 3u);
    EXPECT_GE(held, stalled);
    const PlaneSurface plane(2);
    SplineProblem smooth = chain_problem(plane, zigzag, 29);
    smooth.holds_nodes = true;
    EXPECT_EQ(solve_spline(smooth).report.held, 0u);
}

TEST(SplineOptimizer, TwoPointsOfASphereAreJoinedByAGreatCircleAtConstantSpeed) {
    const SphereSurface sphere(2);
    const Vec3 a = Vec3(2, 0, 0), b = Vec3(-0.7, 1.2, 0.9).normalized() * 2;
    const double angle = std::acos(a.dot(b) / 4);
    for (const double bending : {0.0, 1.0}) {
        SplineProblem problem = chain_problem(sphere, {a, b}, 50);
        problem.bending = bending;
        problem.tension = bending > 0 ? 0 : 1;
        problem.tolerance = 1e-10;
        const SolvedSpline solved = solve_spline(problem);
        const Vec3 across = (b - b.dot(a) / 4 * a).normalized();
        double worst = 0;
        for (int i = 0; i <= 50; ++i) {
            const double t = angle * i / 50;
            worst = std::max(worst, (solved.points[i] - (std::cos(t) * a + 2 * std::sin(t) * across)).norm());
        }
        // E1's chain is exact; E2's is off by how the spline of R^3 leaves the circle between nodes.
        EXPECT_LT(worst, bending > 0 ? 2e-5 : 1e-10);
    }
}

struct Case {
    const char* name;
    std::function<std::unique_ptr<Hypersurface>()> make;
    std::vector<Vec3> given;
};

std::vector<Case> cases() {
    return {{"sphere", [] { return std::make_unique<SphereSurface>(1.0); }, wave(9, 1, 0.5)},
            {"torus", [] { return std::make_unique<TorusSurface>(2.0, 0.8); }, wave(10, 2.4, 0.7)}};
}

// The tangential part of plain fourth differences, over the largest one; not beside given points, where they say
// something else.
double tangential_share(const Hypersurface& surface, const SolvedSpline& solved, uint32_t intervals) {
    const size_t nodes = solved.points.size();
    double largest = 0, tangential = 0;
    for (size_t i = 0; i < nodes; ++i) {
        double value = 0;
        Vec3 normal;
        EXPECT_TRUE(surface.evaluate(solved.points[i].data(), nullptr, &value, normal.data(), nullptr));
        EXPECT_LT(std::abs(value), 1e-12);
        if (i % intervals < 2 || i % intervals > intervals - 2) continue;
        const auto x = [&](int d) { return solved.points[(i + d + nodes) % nodes]; };
        const Vec3 fourth = (x(-2) - 4 * x(-1) + 6 * x(0) - 4 * x(1) + x(2)) / std::pow(solved.steps[i], 4);
        largest = std::max(largest, fourth.norm());
        tangential = std::max(tangential, (fourth - fourth.dot(normal) / normal.squaredNorm() * normal).norm());
    }
    return tangential / largest;
}

// Plain differences are off by the square of the step.
TEST(SplineOptimizer, WhatIsTangentOfTheFourthDerivativeVanishes) {
    for (const Case& a : cases()) {
        for (const bool closed : {false, true}) {
            SCOPED_TRACE(a.name);
            const auto surface = a.make();
            double shares[2];
            for (const uint32_t intervals : {24u, 48u}) {
                SplineProblem problem = chain_problem(*surface, a.given, intervals, closed);
                problem.tolerance = 1e-7;
                const SolvedSpline solved = solve_spline(problem);
                EXPECT_EQ(solved.report.ending, SplineEnding::converged);
                EXPECT_LE(solved.report.rounds, 12u);
                shares[intervals / 48] = tangential_share(*surface, solved, intervals);
            }
            EXPECT_LT(shares[0], 0.02);
            EXPECT_LT(shares[1], 0.35 * shares[0]);
        }
    }
}

TEST(SplineOptimizer, NaturalEndsHaveNoTangentCurvatureAndPrescribedOnesTheirSlope) {
    const TorusSurface torus(2, 0.8);
    for (const bool prescribed : {false, true}) {
        SplineProblem problem = chain_problem(torus, wave(10, 2.4, 0.7), 60);
        Vec3 normal;
        double value;
        torus.evaluate(problem.given.data(), nullptr, &value, normal.data(), nullptr);
        const Vec3 slope = 0.8 * normal.cross(Vec3(0.3, 0.2, 1)).normalized();
        problem.has_slope[0] = prescribed;
        std::copy_n(slope.data(), 3, problem.slopes[0]);
        const SolvedSpline solved = solve_spline(problem);
        const double h = solved.steps[0];
        const auto x = [&](int i) { return solved.points[i]; };
        // One-sided differences of the second order.
        const Vec3 first = (-1.5 * x(0) + 2 * x(1) - 0.5 * x(2)) / h;
        const Vec3 second = (2 * x(0) - 5 * x(1) + 4 * x(2) - x(3)) / (h * h);
        const Vec3 tangential = second - second.dot(normal) * normal;
        if (prescribed) {
            EXPECT_LT((first - slope).norm(), 5e-3);
            EXPECT_GT(tangential.norm(), 0.5);
        } else {
            EXPECT_LT(tangential.norm(), 0.02 * second.norm());
        }
    }
}

// What holds a given point is all that may turn the third derivative: the second one goes through.
TEST(SplineOptimizer, SecondDerivativesAreContinuousAtGivenPoints) {
    const SphereSurface sphere(1);
    double last = HUGE_VAL;
    for (const uint32_t intervals : {40u, 80u}) {
        SplineProblem problem = chain_problem(sphere, wave(7, 1, 0.4), intervals);
        const SolvedSpline solved = solve_spline(problem);
        double jump = 0;
        for (uint32_t k = 1; k + 1 < 7; ++k) {
            const auto x = [&](int d) { return solved.points[k * intervals + d]; };
            const double b = solved.steps[k * intervals - 1], a = solved.steps[k * intervals];
            const Vec3 before = (2 * x(0) - 5 * x(-1) + 4 * x(-2) - x(-3)) / (b * b);
            const Vec3 after = (2 * x(0) - 5 * x(1) + 4 * x(2) - x(3)) / (a * a);
            jump = std::max(jump, (after - before).norm() / after.norm());
        }
        EXPECT_LT(jump, 0.3 * last);
        last = jump;
    }
    EXPECT_LT(last, 0.01);
}

TEST(SplineOptimizer, GivenPointsStayToTheBitAndLargeSmoothingLetsThemGo) {
    const TorusSurface torus(2, 0.8);
    SplineProblem exact = chain_problem(torus, wave(10, 2.4, 0.7), 16);
    const SolvedSpline interpolated = solve_spline(exact);
    for (size_t k = 0; k < 10; ++k) {
        for (int c = 0; c < 3; ++c) EXPECT_EQ(interpolated.points[16 * k][c], exact.given[3 * k + c]);
    }
    double last_misfit = 0, last_bending = interpolated.report.bending;
    for (const double smoothing : {1e-6, 1e-3, 1e-1, 10.0}) {
        SplineProblem problem = chain_problem(torus, wave(10, 2.4, 0.7), 16);
        problem.smoothing = smoothing;
        const SolvedSpline solved = solve_spline(problem);
        double misfit = 0;
        for (size_t k = 0; k < 10; ++k) {
            misfit +=
                (solved.points[16 * k] - Vec3(problem.given[3 * k], problem.given[3 * k + 1], problem.given[3 * k + 2]))
                    .squaredNorm();
        }
        EXPECT_GT(misfit, last_misfit);
        EXPECT_LT(solved.report.bending, last_bending * (1 + 1e-6));
        last_misfit = misfit;
        last_bending = solved.report.bending;
        if (smoothing == 1e-6) {
            EXPECT_LT(misfit, 1e-5);
        }
    }
}

// The plane's smoothing spline has no forces left that could be compared with: it converges all the same.
TEST(SplineOptimizer, SmoothingInThePlaneConverges) {
    const PlaneSurface plane(2);
    for (const double smoothing : {1e-4, 1e-1, 10.0}) {
        SplineProblem problem = chain_problem(plane, zigzag, 20);
        problem.smoothing = smoothing;
        const SolvedSpline solved = solve_spline(problem);
        EXPECT_EQ(solved.report.ending, SplineEnding::converged) << smoothing;
        EXPECT_LT(solved.report.residual, 1e-6);
    }
}

TEST(SplineOptimizer, EnergiesAreOrderedAsWhatTheyMinimize) {
    const TorusSurface torus(2, 0.8);
    double last_stretching = HUGE_VAL, last_bending = 0;
    // Fixed parameters, so that energies can be compared.
    for (const double tension : {0.0, 1.0, 30.0, 1000.0}) {
        SplineProblem problem = chain_problem(torus, wave(8, 2.4, 0.7), 24);
        problem.parameters = Buffer<double>(8, std::pmr::new_delete_resource());
        for (int i = 0; i < 8; ++i) problem.parameters[i] = 2 * i;
        problem.tension = tension;
        const SolvedSpline solved = solve_spline(problem);
        EXPECT_EQ(solved.report.ending, SplineEnding::converged);
        EXPECT_LT(solved.report.stretching, last_stretching);
        EXPECT_GT(solved.report.bending, last_bending);
        last_stretching = solved.report.stretching;
        last_bending = solved.report.bending;
    }
}

TEST(SplineOptimizer, HomotopyLeadsToTheSameCurve) {
    const TorusSurface torus(2, 0.8);
    SplineProblem direct = chain_problem(torus, wave(10, 2.4, 0.7), 24),
                  led = chain_problem(torus, wave(10, 2.4, 0.7), 24);
    for (SplineProblem* problem : {&direct, &led}) {
        problem->parameters = Buffer<double>(10, std::pmr::new_delete_resource());
        for (int i = 0; i < 10; ++i) problem->parameters[i] = i;
        problem->tolerance = 1e-9;
    }
    led.first_tension = 1000;
    const SolvedSpline a = solve_spline(direct), b = solve_spline(led);
    EXPECT_GT(b.report.rounds, a.report.rounds);
    for (size_t i = 0; i < a.points.size(); ++i) EXPECT_LT((a.points[i] - b.points[i]).norm(), 1e-8);
}

TEST(SplineOptimizer, TheSameBitsWhateverTheSlices) {
    const TorusSurface torus(2, 0.8);
    for (const bool closed : {false, true}) {
        std::vector<SolvedSpline> solved;
        for (const bool haltingly : {false, true}) {
            SplineProblem problem = chain_problem(torus, wave(10, 2.4, 0.7), 12, closed);
            solved.push_back(solve_spline(problem, haltingly));
        }
        for (size_t i = 0; i < solved[0].points.size(); ++i) EXPECT_EQ(solved[0].points[i], solved[1].points[i]);
        EXPECT_EQ(solved[0].report.rounds, solved[1].report.rounds);
    }
}

TEST(SplineOptimizer, MovingEverythingMovesTheCurve) {
    const SphereSurface sphere(1);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
    std::vector<Vec3> points = wave(8, 1, 0.5), turned;
    for (const Vec3& p : points) turned.push_back(turn * p);
    SplineProblem first = chain_problem(sphere, points, 20), second = chain_problem(sphere, turned, 20);
    first.tolerance = second.tolerance = 1e-10;
    const SolvedSpline a = solve_spline(first), b = solve_spline(second);
    for (size_t i = 0; i < a.points.size(); ++i) EXPECT_LT((turn * a.points[i] - b.points[i]).norm(), 1e-9);
}

// E2 of the spline through a chain's points as a quadratic function of their coordinates, node by node; its ends are
// clamped along these normals.
Eigen::MatrixXd spline_energy_matrix(const std::vector<double>& steps, const Vec3& first, const Vec3& last) {
    const auto nodes = static_cast<uint32_t>(steps.size() + 1);
    Moments moments(nodes, 3, false, 0, std::pmr::new_delete_resource());
    std::copy(steps.begin(), steps.end(), moments.steps().begin());
    Eigen::Map<Eigen::Matrix3d>(moments.end(false).normals) = first * first.transpose();
    Eigen::Map<Eigen::Matrix3d>(moments.end(true).normals) = last * last.transpose();
    Eigen::MatrixXd moment(3 * nodes, 3 * nodes), bend(3 * nodes, 3 * nodes);
    run_now(std::pmr::new_delete_resource(), [&](Pace& pace) { return Moments::factorize(pace, moments); });
    for (uint32_t k = 0; k < 3 * nodes; ++k) {
        const Eigen::VectorXd points = Eigen::VectorXd::Unit(3 * nodes, k);
        run_now(std::pmr::new_delete_resource(),
                [&](Pace& pace) { return Moments::solve(pace, moments, points.data(), moment.col(k).data()); });
        for (uint32_t i = 0; i < nodes; ++i) moments.bend(i, points.data(), bend.col(k).data() + size_t{3} * i);
    }
    const Eigen::MatrixXd energy = moment.transpose() * bend;
    return 0.5 * (energy + energy.transpose());
}

Vec3 normal_of(const Hypersurface& surface, const Vec3& x) {
    double value = 0;
    Vec3 gradient;
    EXPECT_TRUE(surface.evaluate(x.data(), nullptr, &value, gradient.data(), nullptr));
    return gradient.normalized();
}

// The paper's method and Newton's go to one curve; plain descent needs at least ten times as many rounds as either.
TEST(SplineOptimizer, TheFootpointConeGoesToTheSameCurveAndPlainDescentTakesTenTimesTheRounds) {
    for (const Case& a : cases()) {
        SCOPED_TRACE(a.name);
        const auto surface = a.make();
        SplineProblem newton = chain_problem(*surface, a.given, 6);
        newton.parameters = Buffer<double>(a.given.size(), std::pmr::new_delete_resource());
        for (size_t i = 0; i < a.given.size(); ++i) newton.parameters[i] = static_cast<double>(i);
        newton.tolerance = 1e-5;
        const SolvedSpline solved = solve_spline(newton);
        EXPECT_EQ(solved.report.ending, SplineEnding::converged);
        SplineProblem problem = chain_problem(*surface, a.given, 6);
        reference::LiteralSpline literal;
        literal.manifold = surface.get();
        literal.steps.assign(solved.steps.begin(), solved.steps.end() - 1);
        const size_t nodes = solved.points.size();
        literal.points = Eigen::Map<const Eigen::MatrixXd>(problem.points.data(), 3, nodes);
        for (size_t i = 0; i < nodes; ++i) {
            literal.fixed.push_back(i % 6 == 0);
            if (i % 6 == 0) literal.points.col(i) = Eigen::Map<const Vec3>(&problem.given[i / 6 * 3]);
            surface->project(literal.points.col(i).data(), nullptr);
        }
        reference::LiteralSpline same_energy = literal, cone = literal;
        reference::minimize(same_energy, 1e-5, 200,
                            spline_energy_matrix(literal.steps, normal_of(*surface, literal.points.col(0)),
                                                 normal_of(*surface, literal.points.rightCols(1))));
        for (size_t i = 0; i < nodes; ++i) {
            EXPECT_LT((solved.points[i] - same_energy.points.col(static_cast<Eigen::Index>(i))).norm(), 1e-4);
        }
        const reference::LiteralRun by_cone = reference::minimize(cone, 1e-5, 200);
        const reference::LiteralRun by_gradient = reference::minimize_by_gradient(literal, 1e-5, 10 * by_cone.rounds);
        EXPECT_LT(by_cone.rounds, 60u);
        EXPECT_LE(solved.report.rounds, by_cone.rounds);
        EXPECT_EQ(by_gradient.rounds, 10 * by_cone.rounds);  // and not there yet
        EXPECT_GT(by_gradient.energy, by_cone.energy);
    }
}

// The paper's differences against the spline's own energy: the curves approach each other with the step.
TEST(SplineOptimizer, AgreesWithTheLiteralStepsAsTheChainGetsFiner) {
    const TorusSurface torus(2, 0.8);
    const std::vector<Vec3> given = wave(6, 2.5, 0.6);
    double last = 0;
    for (const uint32_t intervals : {6u, 12u}) {
        SplineProblem problem = chain_problem(torus, given, intervals, true);
        problem.tolerance = 1e-9;
        problem.parameters = Buffer<double>(7, std::pmr::new_delete_resource());
        for (int i = 0; i < 7; ++i) problem.parameters[i] = 2.5 * i;
        SplineProblem start = chain_problem(torus, given, intervals, true);
        const SolvedSpline solved = solve_spline(problem);
        reference::LiteralSpline literal;
        literal.manifold = &torus;
        literal.closed = true;
        literal.steps = solved.steps;
        literal.points = Eigen::Map<const Eigen::MatrixXd>(start.points.data(), 3, start.points.size() / 3);
        for (uint32_t i = 0; i < literal.points.cols(); ++i) {
            literal.fixed.push_back(i % intervals == 0);
            torus.project(literal.points.col(i).data(), nullptr);
        }
        reference::minimize(literal, 1e-8, 300);
        double worst = 0;
        for (size_t i = 0; i < solved.points.size(); ++i)
            worst = std::max(worst, (solved.points[i] - literal.points.col(i)).norm());
        if (last > 0) {
            EXPECT_LT(worst, 0.35 * last);
        }
        last = worst;
    }
    EXPECT_LT(last, 0.03);
}

// A few rounds of fairing take noise out and leave the shape (Remark 5).
double largest_turn(const double* points, size_t nodes) {
    double turn = 0;
    for (size_t i = 1; i + 1 < nodes; ++i) {
        const auto x = [&](size_t at) { return Eigen::Map<const Vec3>(points + 3 * at); };
        turn = std::max(turn, (x(i + 1) - 2 * x(i) + x(i - 1)).norm());
    }
    return turn;
}

TEST(SplineOptimizer, AFewRoundsOfFairingTakeNoiseOut) {
    const SphereSurface sphere(1);
    SplineProblem problem = chain_problem(sphere, {Vec3(1, 0, 0), Vec3(0, 1, 0.3), Vec3(-1, 0.2, 0)}, 40);
    for (uint32_t i = 0; i < problem.points.size(); ++i) problem.points[i] += 0.01 * std::sin(37.0 * i * i);
    problem.max_rounds = 2;
    const double before = largest_turn(problem.points.data(), 81);
    const SolvedSpline solved = solve_spline(problem);
    EXPECT_EQ(solved.report.rounds, 2u);
    EXPECT_EQ(solved.report.ending, SplineEnding::rounds);
    EXPECT_LT(largest_turn(solved.points[0].data(), 81), 0.2 * before);
}

TEST(SplineOptimizer, AStraightLineIsFoundAndHasNoEnergy) {
    const SpaceManifold space(3, 1);
    SplineProblem straight = chain_problem(space, {Vec3(0, 0, 0), Vec3(1, 0, 0)}, 10);
    const SolvedSpline line = solve_spline(straight);
    EXPECT_EQ(line.report.residual, 0);
    EXPECT_NEAR(line.report.bending, 0, 1e-20);
    EXPECT_NEAR(line.report.length, 1, 1e-15);
}

}  // namespace
}  // namespace flg::test
