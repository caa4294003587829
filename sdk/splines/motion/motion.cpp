// SPDX-License-Identifier: MIT
#include "splines/motion/motion.h"

#include <cmath>
#include <limits>

#include "core/failure.h"
#include "splines/manifolds/rotation_manifold.h"
#include "splines/manifolds/space_manifold.h"
#include "splines/optimizer/natural_cubic.h"

namespace flg {

namespace {

using Mat3 = Eigen::Matrix3d;

constexpr uint32_t coarse_intervals = 6;  // a segment
constexpr double coarse_tolerance = 1e-3;
constexpr uint32_t path_intervals = 16;  // a segment, at least, around obstacles

// The chain of positions, or a coarser one: where keys are, and when its nodes are passed.
struct Chain {
    uint32_t nodes;
    Buffer<uint32_t> knots;  // one a key
};

struct Scene {
    const MotionInput& input;
    const MotionKeys& keys;
    const RotationManifold& rotations;
    uint32_t segments() const { return static_cast<uint32_t>(keys.times().size()) - 1; }
    uint32_t key_after(uint32_t segment) const { return segment + 1 == keys.count() ? 0 : segment + 1; }
};

// Positions that are not keys are shared by segments as their durations are.
Chain fine_chain(const Scene& scene, Memory* memory) {
    const std::span<const double> times = scene.keys.times();
    const uint32_t more = scene.input.desc.position_count - static_cast<uint32_t>(scene.keys.count());
    Chain chain{scene.input.desc.position_count, Buffer<uint32_t>(scene.keys.count(), memory)};
    for (uint32_t i = 0; i < chain.knots.size(); ++i) {
        const double share = (times[i] - times.front()) / (times.back() - times.front());
        chain.knots[i] = i + static_cast<uint32_t>(std::lround(share * more));
    }
    return chain;
}

Chain coarse_chain(const Scene& scene, Memory* memory) {
    Chain chain{coarse_intervals * scene.segments() + (scene.input.desc.closed ? 0 : 1),
                Buffer<uint32_t>(scene.keys.count(), memory)};
    for (uint32_t i = 0; i < chain.knots.size(); ++i) chain.knots[i] = coarse_intervals * i;
    return chain;
}

// Goes along the nodes of a chain: each one's segment, and its share of that.
class ChainWalk {
public:
    ChainWalk(const Scene& scene, const Chain& chain) : scene_(scene), chain_(chain) {}

    void go_to(uint32_t node) {
        while (segment + 1 < chain_.knots.size() && node >= chain_.knots[segment + 1]) ++segment;
        const bool at_end = segment == scene_.segments();
        const uint32_t first = chain_.knots[segment];
        const uint32_t end = segment + 1 < chain_.knots.size() ? chain_.knots[segment + 1] : chain_.nodes;
        share = node == first ? 0 : static_cast<double>(node - first) / (end - first);
        const std::span<const double> times = scene_.keys.times();
        time = share == 0 ? times[segment] : times[segment] + share * (times[segment + 1] - times[segment]);
        if (at_end) segment = scene_.segments();
    }

    uint32_t segment = 0;  // at the end of an open chain the number of segments
    double share = 0, time = 0;

private:
    const Scene& scene_;
    const Chain& chain_;
};

double min_tension(const MotionInput& input) {
    return input.bending() > 0 ? input.tension() : std::numeric_limits<double>::infinity();
}

void set_options(const MotionInput& input, SplineProblem& problem) {
    problem.closed = input.desc.closed != 0;
    problem.bending = input.bending();
    problem.tension = input.tension();
    problem.smoothing = input.desc.smoothing;
    problem.tolerance = input.desc.tolerance;
    problem.max_rounds = input.desc.max_rounds;
}

// What the two splines have in common.
SplineProblem problem_of(const Scene& scene, const Manifold& manifold, const Chain& chain, Memory* memory) {
    SplineProblem problem;
    problem.manifold = &manifold;
    set_options(scene.input, problem);
    const size_t n = manifold.ambient(), count = scene.keys.count();
    problem.points = Buffer<double>(n * chain.nodes, memory);
    problem.knots = Buffer<uint32_t>(count, memory);
    problem.given = Buffer<double>(n * count, memory);
    problem.parameters = Buffer<double>(scene.keys.times().size(), memory);
    return problem;
}

Task<void> set_knots(Pace& pace, const Scene& scene, const Chain& chain, SplineProblem& problem) {
    co_await each(pace, scene.keys.times().size(), Cost::some_ns, [&](uint32_t i) {
        problem.parameters[i] = scene.keys.times()[i];
        if (i < problem.knots.size()) problem.knots[i] = chain.knots[i];
    });
}

// The classical spline through values at knots, or with E1 the polyline, at the nodes of a chain.
Task<double> sample_spline(Pace& pace, const Scene& scene, const CubicData& data, const Chain& chain, double* out) {
    const NaturalCubic spline = co_await natural_cubic(pace, data);
    ChainWalk walk(scene, chain);
    co_await each(pace, chain.nodes, Cost::hundreds_of_ns, [&](uint32_t i) {
        walk.go_to(i);
        spline.evaluate(walk.time, 0, out + data.dimension * i);
    });
    co_return spline.energy();
}

CubicEnds ends_of(const MotionInput& input) {
    return input.desc.closed ? CubicEnds::periodic : CubicEnds::natural;
}

// Keys that no path around the obstacles can pass through are named as such.
Task<void> check_clearance(Pace& pace, const Scene& scene) {
    const PlacedObstacles placed(scene.input.obstacles, scene.input.origin, pace.memory());
    const ObstacleSet& set = placed.set();
    co_await each_by_work(pace, scene.keys.count(), Cost::hundreds_of_ns, [&](uint32_t key) {
        const double* const at = &scene.keys.barycentres()[size_t{3} * key];
        for (uint32_t i = 0; i < set.count(); ++i) {
            if (set.evaluate(i, at, nullptr, nullptr) >= 0) continue;
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "keys[%u] has its barycentre in obstacle %u or nearer to it than the clearance", key, i);
        }
        return set.count();
    });
}

// The path around obstacles: a chain that is finer than segments need to be told apart.
Task<double> find_path_around(Pace& pace, const Scene& scene, const Chain& chain, Buffer<double>& path) {
    co_await check_clearance(pace, scene);
    const std::pmr::polymorphic_allocator<> allocator(pace.memory());
    const auto space = std::allocate_shared<ManifoldProduct>(allocator);
    space->manifold = std::allocate_shared<SpaceManifold>(allocator, 3, 1.0);
    space->kind = ManifoldKind::space;
    SplineRequest request;
    request.out = std::allocate_shared<Spline>(allocator, space);
    request.out->origin = scene.input.origin;
    request.obstacles = scene.input.obstacles;
    request.desc.obstacle_radius = scene.input.desc.obstacle_radius;
    request.sides = Buffer<ObstacleSide>(scene.input.sides.size(), pace.memory());
    for (size_t i = 0; i < request.sides.size(); ++i) request.sides[i] = scene.input.sides[i];
    request.desc.node_count =
        std::min(std::max(chain.nodes, path_intervals * scene.segments() + 1), FLG_SPLINE_MAX_NODES);
    SplineProblem& problem = request.problem;
    set_options(scene.input, problem);
    request.points = Buffer<double>(3 * scene.keys.count(), pace.memory());
    problem.parameters = Buffer<double>(scene.keys.times().size(), pace.memory());
    co_await each(pace, scene.keys.times().size(), Cost::some_ns, [&](uint32_t i) {
        problem.parameters[i] = scene.keys.times()[i];
        for (size_t c = size_t{3} * i; c < size_t{3} * (i + 1) && c < request.points.size(); ++c)
            request.points[c] = scene.keys.barycentres()[c];
    });
    const std::shared_ptr<Spline> around = request.out;
    co_await make_spline(pace, std::move(request));
    const Spline::Chain& found = around->chain;
    const size_t nodes = found.nodes.size() / 3;
    const CubicData data{.knots = {found.parameters.data(), nodes + (scene.input.desc.closed ? 1 : 0)},
                         .values = {found.nodes.data(), 3 * nodes},
                         .ends = ends_of(scene.input),
                         .tension = min_tension(scene.input)};
    co_await sample_spline(pace, scene, data, chain, path.data());
    co_return found.report.energy;
}

// Places of the barycentre, 3 a node; returns the energy of the path.
Task<double> find_path(Pace& pace, const Scene& scene, const Chain& chain, Buffer<double>& path) {
    const CubicData data{.knots = scene.keys.times(),
                         .values = scene.keys.barycentres(),
                         .ends = ends_of(scene.input),
                         .tension = min_tension(scene.input)};
    const double energy = co_await sample_spline(pace, scene, data, chain, path.data());
    if (scene.input.desc.smoothing == 0) co_return scene.input.bending() > 0 ? energy : scene.input.tension() * energy;

    double size = 0;
    for (const double value : scene.keys.barycentres()) size = std::max(size, std::abs(value));
    const SpaceManifold space(3, size > 0 ? size : 1);
    SplineProblem problem = problem_of(scene, space, chain, pace.memory());
    co_await set_knots(pace, scene, chain, problem);
    co_await each(pace, path.size(), Cost::some_ns, [&](uint32_t i) {
        problem.points[i] = path[i];
        if (i < problem.given.size()) problem.given[i] = scene.keys.barycentres()[i];
    });
    SplineOptimizer optimizer(problem, pace.memory());
    co_await SplineOptimizer::minimize(pace, optimizer);
    co_await each(pace, path.size(), Cost::some_ns, [&](uint32_t i) { path[i] = optimizer.points()[i]; });
    co_return optimizer.report().energy;
}

// Turns at constant speed from key to key.
Task<void> turn_evenly(Pace& pace, const Scene& scene, const Chain& chain, double* points) {
    ChainWalk walk(scene, chain);
    co_await each(pace, chain.nodes, Cost::hundreds_of_ns, [&](uint32_t i) {
        walk.go_to(i);
        const uint32_t from = walk.segment, to = scene.key_after(from);
        const Mat3 rotation = walk.share == 0
                                  ? scene.keys.rotation(from)
                                  : rotation_between(scene.keys.rotation(from), scene.keys.rotation(to), walk.share);
        scene.rotations.point_of(rotation, points + size_t{9} * i);
    });
}

Task<void> set_rotations(Pace& pace, const Scene& scene, const Chain& chain, SplineProblem& problem) {
    co_await set_knots(pace, scene, chain, problem);
    co_await each(pace, scene.keys.count(), Cost::tens_of_ns, [&](uint32_t i) {
        scene.rotations.point_of(scene.keys.rotation(i), problem.given.data() + size_t{9} * i);
    });
}

// The rotations of the chain, from those of a coarse one: its spline in R^9, which is near the manifold.
Task<void> begin_coarsely(Pace& pace, const Scene& scene, const Chain& chain, double* points) {
    const Chain coarse = coarse_chain(scene, pace.memory());
    SplineProblem problem = problem_of(scene, scene.rotations, coarse, pace.memory());
    problem.tolerance = std::max(coarse_tolerance, problem.tolerance);
    co_await set_rotations(pace, scene, coarse, problem);
    co_await turn_evenly(pace, scene, coarse, problem.points.data());
    SplineOptimizer optimizer(problem, pace.memory());
    co_await SplineOptimizer::minimize(pace, optimizer);

    const bool closed = scene.input.desc.closed != 0;
    Buffer<double> times(coarse.nodes + (closed ? 1 : 0), pace.memory());
    ChainWalk coarse_walk(scene, coarse);
    co_await each(pace, coarse.nodes, Cost::tens_of_ns, [&](uint32_t i) {
        coarse_walk.go_to(i);
        times[i] = coarse_walk.time;
    });
    if (closed) times[coarse.nodes] = scene.keys.times().back();
    const CubicData data{.knots = {times.data(), times.size()},
                         .values = {optimizer.points(), size_t{9} * coarse.nodes},
                         .dimension = 9,
                         .ends = ends_of(scene.input),
                         .tension = min_tension(scene.input)};
    co_await sample_spline(pace, scene, data, chain, points);
}

// Puts barycentres and rotations together, and shows that.
Task<void> show_state(Pace& pace, const Scene& scene, const Buffer<double>& path, const double* rotations,
                      const SplineReport& report, double path_energy, TripleBuffer<MotionState>& states) {
    MotionState& state = states.write();
    state.report = report;
    state.barycentre_energy = path_energy;
    Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
    co_await each(pace, scene.input.desc.position_count, Cost::hundreds_of_ns, [&](uint32_t i) {
        const Mat3 turn = scene.rotations.rotation_of(rotations + size_t{9} * i);
        const Vec3 at(path[3 * i], path[3 * i + 1], path[3 * i + 2]);
        pose_of(scene.input.body, at, turn, state.poses.data() + MotionKeys::pose_size * i);
        Eigen::Quaterniond q(turn * scene.input.body.axes.transpose());
        if (q.dot(before) < 0) q.coeffs() *= -1;
        before = q;
        for (int c = 0; c < 4; ++c) state.quaternions[4 * i + c] = q.coeffs()[c];
    });
    states.hand_over();
}

}  // namespace

Motion::Motion(MotionInput given, Memory* memory)
    : input(std::move(given)),
      times(input.desc.position_count + (input.desc.closed ? 1 : 0), memory),
      key_positions(input.times.size(), memory) {
    for (MotionState& state : states.all()) {
        state.poses = Buffer<double>(MotionKeys::pose_size * input.desc.position_count, memory);
        state.quaternions = Buffer<double>(size_t{4} * input.desc.position_count, memory);
    }
}

void Motion::publish_partial() noexcept {
    if (!states.take()) return;
    show();
    show_early();
}

void Motion::show() noexcept {
    states.take();
    const MotionState& state = states.read();
    const SplineReport& report = state.report;
    view_ = {};
    view_.struct_size = sizeof view_;
    write_origin(input.origin, view_.origin);
    view_.position_count = input.desc.position_count;
    view_.key_count = static_cast<uint32_t>(input.times.size());
    view_.closed = input.desc.closed ? 1 : 0;
    view_.times = times.data();
    view_.poses = state.poses.data();
    view_.quaternions = state.quaternions.data();
    view_.key_positions = key_positions.data();
    view_.mass = input.body.mass;
    for (int i = 0; i < 3; ++i) {
        view_.barycentre[i] = input.body.barycentre[i];
        view_.inertia[i] = input.body.f[static_cast<size_t>(i)];
        for (int j = 0; j < 3; ++j) view_.axes[3 * i + j] = input.body.axes(j, i);
    }
    view_.radius = input.body.radius;
    view_.greatest_stretch = greatest_stretch;
    view_.ending = report.ending == SplineEnding::converged  ? FLG_SPLINE_ENDING_CONVERGED
                   : report.ending == SplineEnding::rounding ? FLG_SPLINE_ENDING_ROUNDING
                   : report.ending == SplineEnding::rounds   ? FLG_SPLINE_ENDING_ROUNDS
                                                             : FLG_SPLINE_ENDING_RUNNING;
    view_.rounds = report.rounds;
    view_.barycentre_energy = input.body.mass * state.barycentre_energy;
    view_.rotation_energy = report.energy;
    view_.energy = view_.barycentre_energy + view_.rotation_energy;
    view_.residual = report.residual;
}

Task<void> make_motion(Pace& pace, std::shared_ptr<Motion> out) {
    const MotionInput& input = out->input;
    pace.stage("keys");
    const MotionKeyInput given{input.times, input.poses, input.desc.closed != 0, input.desc.end_time};
    const MotionKeys keys = co_await check_keys(pace, given, input.body);
    out->greatest_stretch = keys.greatest_stretch();
    const RotationManifold rotations(input.body.f);
    const Scene scene{input, keys, rotations};
    const Chain chain = fine_chain(scene, pace.memory());
    ChainWalk walk(scene, chain);
    co_await each(pace, chain.nodes, Cost::tens_of_ns, [&](uint32_t i) {
        walk.go_to(i);
        out->times[i] = walk.time;
    });
    if (input.desc.closed) out->times[chain.nodes] = keys.times().back();
    co_await each(pace, keys.count(), Cost::some_ns, [&](uint32_t i) { out->key_positions[i] = chain.knots[i]; });

    pace.stage("barycentre");
    Buffer<double> path(size_t{3} * chain.nodes, pace.memory());
    double path_energy = 0;
    if (input.obstacles) {
        path_energy = co_await find_path_around(pace, scene, chain, path);
    } else {
        path_energy = co_await find_path(pace, scene, chain, path);
    }

    pace.stage("rotations");
    SplineProblem problem = problem_of(scene, rotations, chain, pace.memory());
    co_await set_rotations(pace, scene, chain, problem);
    const bool coarse_first = input.desc.smoothing == 0 && chain.nodes > 2 * coarse_intervals * scene.segments();
    if (coarse_first) {
        co_await begin_coarsely(pace, scene, chain, problem.points.data());
    } else {
        co_await turn_evenly(pace, scene, chain, problem.points.data());
    }
    SplineOptimizer optimizer(problem, pace.memory());
    const bool partial = pace.job().partial_results;
    for (;;) {
        const bool goes_on = co_await SplineOptimizer::next_round(pace, optimizer);
        const SplineReport& report = optimizer.report();
        if (report.ending == SplineEnding::failed)
            throw Failure(FLG_ERROR_INTERNAL, "position %u has no nearest rotation", report.failed_node);
        if (partial || !goes_on)
            co_await show_state(pace, scene, path, optimizer.points(), report, path_energy, out->states);
        if (!goes_on) break;
    }
}

}  // namespace flg
