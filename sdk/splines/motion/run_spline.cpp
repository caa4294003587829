// SPDX-License-Identifier: MIT
#include "splines/motion/run_spline.h"

#include <cmath>
#include <limits>

#include "core/failure.h"
#include "splines/manifolds/space_manifold.h"

namespace flg {

namespace {

using Mat3 = Eigen::Matrix3d;

constexpr uint32_t coarse_intervals = 6;  // a segment
constexpr double coarse_tolerance = 1e-3;
constexpr uint32_t path_intervals = 16;  // a segment, at least, around obstacles
constexpr uint32_t n = 9;

// With this many intervals a segment, or twice as many as another chain.
Task<RunChain> chain_like(Pace& pace, const RunScene& scene, const RunChain& chain, uint32_t intervals,
                          uint32_t times) {
    const uint32_t nodes =
        intervals > 0 ? intervals * scene.segments() : times * (chain.nodes - (scene.run.closed ? 0 : 1));
    RunChain made{nodes + (scene.run.closed ? 0 : 1), Buffer<uint32_t>(chain.knots.size(), pace.memory()),
                  Buffer<double>(chain.times.size(), pace.memory())};
    co_await each(pace, chain.times.size(), Cost::some_ns, [&](uint32_t i) {
        made.times[i] = chain.times[i];
        if (i < made.knots.size()) made.knots[i] = intervals > 0 ? intervals * i : times * chain.knots[i];
    });
    co_return made;
}

void set_options(const RunScene& scene, SplineProblem& problem) {
    problem.closed = scene.run.closed;
    problem.bending = scene.input.bending();
    problem.tension = scene.input.tension();
    problem.smoothing = scene.input.desc.smoothing;
    problem.tolerance = scene.input.desc.tolerance;
    problem.max_rounds = scene.input.desc.max_rounds;
    // A slope of 0.
    problem.has_slope[0] = scene.run.rests[0];
    problem.has_slope[1] = scene.run.rests[1];
}

// What the two splines have in common.
Task<SplineProblem> problem_of(Pace& pace, const RunScene& scene, const Manifold& manifold, const RunChain& chain) {
    SplineProblem problem;
    problem.manifold = &manifold;
    set_options(scene, problem);
    const size_t ambient = manifold.ambient(), count = scene.run.keys;
    problem.points = Buffer<double>(ambient * chain.nodes, pace.memory());
    problem.knots = Buffer<uint32_t>(count, pace.memory());
    problem.given = Buffer<double>(ambient * count, pace.memory());
    problem.parameters = Buffer<double>(chain.times.size(), pace.memory());
    co_await each(pace, chain.times.size(), Cost::some_ns, [&](uint32_t i) {
        problem.parameters[i] = chain.times[i];
        if (i < problem.knots.size()) problem.knots[i] = chain.knots[i];
    });
    co_return problem;
}

// The classical spline through values at knots, or with E1 the polyline, at the nodes of a chain.
Task<double> sample_spline(Pace& pace, CubicData data, const RunChain& chain, double* out) {
    const double rest[2 * n] = {};
    data.slopes = rest;
    const NaturalCubic spline = co_await natural_cubic(pace, data);
    ChainWalk walk(chain);
    co_await each(pace, chain.nodes, Cost::hundreds_of_ns, [&](uint32_t i) {
        walk.go_to(i);
        spline.evaluate(walk.time, 0, out + data.dimension * i);
    });
    co_return spline.energy();
}

// Keys that no path around the obstacles can pass through are named as such.
Task<void> check_clearance(Pace& pace, const RunScene& scene) {
    const PlacedObstacles placed(scene.input.obstacles, scene.input.origin, scene.input.desc.clearance, pace.memory());
    const ObstacleSet& set = placed.set();
    co_await each_by_work(pace, scene.run.keys, Cost::hundreds_of_ns, [&](uint32_t k) {
        const size_t key = scene.key(k);
        const double* const at = &scene.keys.barycentres()[3 * key];
        for (uint32_t i = 0; i < set.count(); ++i) {
            if (set.evaluate(i, at, nullptr, nullptr) >= 0) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "keys[%zu] has its barycentre in obstacle %u or nearer to it than the clearance", key, i);
        }
        return set.count();
    });
}

// The path around obstacles: a chain that is finer than segments need to be told apart.
Task<double> find_path_around(Pace& pace, const RunScene& scene, const RunChain& chain, double* path) {
    co_await check_clearance(pace, scene);
    const std::pmr::polymorphic_allocator<> allocator(pace.memory());
    const auto space = std::allocate_shared<ManifoldProduct>(allocator);
    space->manifold = std::allocate_shared<SpaceManifold>(allocator, 3, 1.0);
    space->kind = ManifoldKind::space;
    SplineRequest request;
    request.out = std::allocate_shared<Spline>(allocator, space);
    request.out->origin = scene.input.origin;
    request.obstacles = scene.input.obstacles;
    request.more_clearance = scene.input.desc.clearance;
    request.desc.obstacle_radius = scene.input.desc.obstacle_radius;
    request.sides = Buffer<ObstacleSide>(scene.input.sides.size(), pace.memory());
    for (size_t i = 0; i < request.sides.size(); ++i) request.sides[i] = scene.input.sides[i];
    request.desc.node_count =
        std::min(std::max(chain.nodes, path_intervals * scene.segments() + 1), FLG_SPLINE_MAX_NODES);
    SplineProblem& problem = request.problem;
    set_options(scene, problem);
    request.points = Buffer<double>(size_t{3} * scene.run.keys, pace.memory());
    problem.parameters = Buffer<double>(chain.times.size(), pace.memory());
    co_await each(pace, chain.times.size(), Cost::some_ns, [&](uint32_t i) {
        problem.parameters[i] = chain.times[i];
        if (i >= scene.run.keys) return;
        std::copy_n(&scene.keys.barycentres()[3 * scene.key(i)], 3, &request.points[size_t{3} * i]);
    });
    const std::shared_ptr<Spline> around = request.out;
    co_await make_spline(pace, std::move(request));
    const Spline::Chain& found = around->chain;
    const size_t nodes = found.nodes.size() / 3;
    const CubicData data{.knots = {found.parameters.data(), nodes + (scene.run.closed ? 1 : 0)},
                         .values = {found.nodes.data(), 3 * nodes},
                         .ends = scene.ends(),
                         .tension = scene.tension()};
    co_await sample_spline(pace, data, chain, path);
    co_return found.report.energy;
}

// Turns at constant speed from key to key.
Task<void> turn_evenly(Pace& pace, const RunScene& scene, const RunChain& chain, double* points) {
    ChainWalk walk(chain);
    co_await each(pace, chain.nodes, Cost::hundreds_of_ns, [&](uint32_t i) {
        walk.go_to(i);
        const size_t from = scene.key(walk.segment);
        const Mat3 rotation = walk.share == 0
                                  ? scene.keys.rotation(from)
                                  : rotation_between(scene.keys.rotation(from),
                                                     scene.keys.rotation(scene.key(walk.segment + 1)), walk.share);
        scene.rotations.point_of(rotation, points + size_t{n} * i);
    });
}

Task<SplineProblem> rotation_problem(Pace& pace, const RunScene& scene, const RunChain& chain) {
    SplineProblem problem = co_await problem_of(pace, scene, scene.rotations, chain);
    co_await each(pace, scene.run.keys, Cost::tens_of_ns, [&](uint32_t i) {
        scene.rotations.point_of(scene.keys.rotation(scene.key(i)), problem.given.data() + size_t{n} * i);
    });
    co_return problem;
}

// The rotations of the chain, from those of a coarse one: its spline in R^9, which is near the manifold.
Task<void> begin_coarsely(Pace& pace, const RunScene& scene, const RunChain& chain, double* points) {
    const RunChain coarse = co_await chain_like(pace, scene, chain, coarse_intervals, 0);
    SplineProblem problem = co_await rotation_problem(pace, scene, coarse);
    problem.tolerance = std::max(coarse_tolerance, problem.tolerance);
    co_await turn_evenly(pace, scene, coarse, problem.points.data());
    SplineOptimizer optimizer(problem, pace.memory());
    co_await SplineOptimizer::minimize(pace, optimizer);
    co_await SplineOptimizer::give_back(pace, optimizer);

    Buffer<double> times(coarse.nodes + (scene.run.closed ? 1 : 0), pace.memory());
    ChainWalk coarse_walk(coarse);
    co_await each(pace, coarse.nodes, Cost::tens_of_ns, [&](uint32_t i) {
        coarse_walk.go_to(i);
        times[i] = coarse_walk.time;
    });
    if (scene.run.closed) times[coarse.nodes] = chain.times[scene.run.keys];
    const CubicData data{.knots = {times.data(), times.size()},
                         .values = {optimizer.points(), size_t{n} * coarse.nodes},
                         .dimension = n,
                         .ends = scene.ends(),
                         .tension = scene.tension()};
    co_await sample_spline(pace, data, chain, points);
}

Task<SplineReport> solve_rotations(Pace& pace, const RunScene& scene, const RunChain& chain, double* rotations,
                                   RoundWatch* watch) {
    SplineProblem problem = co_await rotation_problem(pace, scene, chain);
    const bool coarse_first = scene.input.desc.smoothing == 0 && chain.nodes > 2 * coarse_intervals * scene.segments();
    if (coarse_first) {
        co_await begin_coarsely(pace, scene, chain, problem.points.data());
    } else {
        co_await turn_evenly(pace, scene, chain, problem.points.data());
    }
    SplineOptimizer optimizer(problem, pace.memory());
    for (;;) {
        const bool goes_on = co_await SplineOptimizer::next_round(pace, optimizer);
        const SplineReport& report = optimizer.report();
        if (report.ending == SplineEnding::failed)
            throw Failure(FLG_ERROR_INTERNAL, "position %u has no nearest rotation", report.failed_node);
        if (watch || !goes_on) {
            const double* const points = optimizer.points();
            co_await each(pace, size_t{n} * chain.nodes, Cost::some_ns, [=](uint32_t i) { rotations[i] = points[i]; });
        }
        if (!goes_on) {
            const SplineReport last = report;
            co_await SplineOptimizer::give_back(pace, optimizer);
            co_return last;
        }
        if (watch) co_await watch->show(pace, report);
    }
}

// Richardson's extrapolation, from the chain's rotations and those of twice as many intervals.
Task<SplineReport> extrapolate(Pace& pace, const RunScene& scene, const RunChain& chain, SplineReport coarse,
                               double* rotations) {
    const RunChain fine = co_await chain_like(pace, scene, chain, 0, 2);
    Buffer<double> finer(size_t{n} * fine.nodes, pace.memory());
    SplineReport report = co_await solve_rotations(pace, scene, fine, finer.data(), nullptr);
    uint32_t knot = 0;
    co_await each(pace, chain.nodes, Cost::hundreds_of_ns, [&](uint32_t i) {
        const bool given = knot < chain.knots.size() && chain.knots[knot] == i;
        if (given) ++knot;
        if (given) return;
        double* const x = rotations + size_t{n} * i;
        const double* const y = &finer[size_t{2 * n} * i];
        double sum[n];
        for (uint32_t c = 0; c < n; ++c) sum[c] = y[c] + (y[c] - x[c]) / 3;
        if (scene.rotations.project(sum, nullptr)) std::copy_n(sum, n, x);
    });
    report.energy += (report.energy - coarse.energy) / 3;
    report.rounds += coarse.rounds;
    co_return report;
}

}  // namespace

double RunScene::tension() const {
    return input.bending() > 0 ? input.tension() : std::numeric_limits<double>::infinity();
}

CubicEnds RunScene::ends() const {
    if (run.closed) return CubicEnds::periodic;
    if (run.rests[0]) return run.rests[1] ? CubicEnds::clamped : CubicEnds::clamped_begin;
    return run.rests[1] ? CubicEnds::clamped_end : CubicEnds::natural;
}

void ChainWalk::go_to(uint32_t node) {
    while (segment + 1 < chain_.knots.size() && node >= chain_.knots[segment + 1]) ++segment;
    const uint32_t first = chain_.knots[segment];
    const uint32_t end = segment + 1 < chain_.knots.size() ? chain_.knots[segment + 1] : chain_.nodes;
    share = node == first ? 0 : static_cast<double>(node - first) / (end - first);
    time = share == 0 ? chain_.times[segment]
                      : chain_.times[segment] + share * (chain_.times[segment + 1] - chain_.times[segment]);
}

Task<double> run_path(Pace& pace, const RunScene& scene, const RunChain& chain, double* path) {
    if (scene.input.obstacles) co_return co_await find_path_around(pace, scene, chain, path);
    Buffer<double> keys(size_t{3} * scene.run.keys, pace.memory());
    co_await each(pace, scene.run.keys, Cost::some_ns, [&](uint32_t i) {
        std::copy_n(&scene.keys.barycentres()[3 * scene.key(i)], 3, &keys[size_t{3} * i]);
    });
    const CubicData data{.knots = {chain.times.data(), chain.times.size()},
                         .values = {keys.data(), keys.size()},
                         .ends = scene.ends(),
                         .tension = scene.tension()};
    const double energy = co_await sample_spline(pace, data, chain, path);
    if (scene.input.desc.smoothing == 0) co_return scene.input.bending() > 0 ? energy : scene.input.tension() * energy;

    double size = 0;
    co_await each(pace, keys.size(), Cost::some_ns, [&](uint32_t i) { size = std::max(size, std::abs(keys[i])); });
    const SpaceManifold space(3, size > 0 ? size : 1);
    SplineProblem problem = co_await problem_of(pace, scene, space, chain);
    co_await each(pace, size_t{3} * chain.nodes, Cost::some_ns, [&](uint32_t i) {
        problem.points[i] = path[i];
        if (i < problem.given.size()) problem.given[i] = keys[i];
    });
    SplineOptimizer optimizer(problem, pace.memory());
    co_await SplineOptimizer::minimize(pace, optimizer);
    co_await each(pace, size_t{3} * chain.nodes, Cost::some_ns, [&](uint32_t i) { path[i] = optimizer.points()[i]; });
    co_await SplineOptimizer::give_back(pace, optimizer);
    co_return optimizer.report().energy;
}

Task<SplineReport> run_rotations(Pace& pace, const RunScene& scene, const RunChain& chain, double* rotations,
                                 RoundWatch* watch) {
    const SplineReport report = co_await solve_rotations(pace, scene, chain, rotations, watch);
    const bool polyline = scene.input.bending() == 0 && scene.input.desc.smoothing == 0;
    if (!polyline) co_return report;
    co_return co_await extrapolate(pace, scene, chain, report, rotations);
}

}  // namespace flg
