// SPDX-License-Identifier: MIT
#include "splines/motion/motion.h"

#include <cmath>
#include <optional>

#include "core/failure.h"
#include "splines/manifolds/rotation_manifold.h"
#include "splines/motion/run_spline.h"
#include "splines/optimizer/natural_cubic.h"

namespace flg {

namespace {

using Mat3 = Eigen::Matrix3d;

constexpr uint32_t law_intervals = 16;  // a segment, at least, where limits are looked at
constexpr double min_segment = 1e-9;    // of the whole duration, from key to key

struct Scene {
    const MotionInput& input;
    const MotionKeys& keys;
    const RotationManifold& rotations;

    bool closed() const { return input.desc.closed != 0; }
    bool turns() const { return input.look.kind == LookKind::keys; }
};

// All nodes of a motion, with the barycentre's places and the rotations (rotation_manifold.h): 3 and 9 numbers each.
struct Nodes {
    RunChain chain;
    Buffer<double> places, rotations;
};

// Nodes that are not keys are shared by segments as their durations are.
Task<RunChain> share_nodes(Pace& pace, uint32_t nodes, size_t keys, std::span<const double> times) {
    const uint32_t more = nodes - static_cast<uint32_t>(keys);
    RunChain chain{nodes, Buffer<uint32_t>(keys, pace.memory()), Buffer<double>(times.size(), pace.memory())};
    co_await each(pace, times.size(), Cost::tens_of_ns, [&](uint32_t i) {
        chain.times[i] = times[i];
        if (i >= keys) return;
        const double share = (times[i] - times.front()) / (times.back() - times.front());
        chain.knots[i] = i + static_cast<uint32_t>(std::lround(share * more));
    });
    co_return chain;
}

// When nodes are passed; of closed motions also the end.
Task<Buffer<double>> node_times(Pace& pace, const RunChain& chain) {
    const bool closed = chain.times.size() > chain.knots.size();
    Buffer<double> times(chain.nodes + (closed ? 1 : 0), pace.memory());
    ChainWalk walk(chain);
    co_await each(pace, chain.nodes, Cost::tens_of_ns, [&](uint32_t i) {
        walk.go_to(i);
        times[i] = walk.time;
    });
    if (closed) times[chain.nodes] = chain.times[chain.knots.size()];
    co_return times;
}

// A run's part of all nodes: where it begins among them, its own chain.
struct RunPart {
    uint32_t first;
    RunChain chain;
};

Task<RunPart> part_of(Pace& pace, const Scene& scene, const RunChain& chain, MotionRun run) {
    const size_t count = scene.keys.count();
    const double period = chain.times[chain.times.size() - 1] - chain.times[0];
    RunPart part{
        chain.knots[run.first],
        {0, Buffer<uint32_t>(run.keys, pace.memory()), Buffer<double>(run.keys + (run.closed ? 1 : 0), pace.memory())}};
    co_await each(pace, run.keys, Cost::some_ns, [&](uint32_t i) {
        const size_t key = run.first + i;
        const bool again = key >= count;
        part.chain.knots[i] = chain.knots[key % count] + (again ? chain.nodes : 0) - part.first;
        part.chain.times[i] = chain.times[key % count] + (again ? period : 0);
    });
    if (run.closed) part.chain.times[run.keys] = chain.times[count];
    part.chain.nodes = run.closed ? chain.nodes : part.chain.knots[run.keys - 1] + 1;
    co_return part;
}

// Numbers of a run, `size` a node, from those of all nodes or back.
Task<void> copy_part(Pace& pace, const RunPart& part, uint32_t all, uint32_t size, double* run, double* whole,
                     bool back) {
    co_await each(pace, part.chain.nodes, Cost::tens_of_ns, [=, first = part.first](uint32_t i) {
        double* const in_run = run + size_t{size} * i;
        double* const in_whole = whole + size_t{size} * ((first + i) % all);
        if (back)
            std::copy_n(in_run, size, in_whole);
        else
            std::copy_n(in_whole, size, in_run);
    });
}

// Every node where the key before it is; what pauses keep.
Task<void> stand(Pace& pace, const Scene& scene, Nodes& nodes) {
    ChainWalk walk(nodes.chain);
    co_await each(pace, nodes.chain.nodes, Cost::tens_of_ns, [&](uint32_t i) {
        walk.go_to(i);
        std::copy_n(&scene.keys.barycentres()[size_t{3} * walk.segment], 3, &nodes.places[size_t{3} * i]);
        scene.rotations.point_of(scene.keys.rotation(walk.segment), &nodes.rotations[size_t{9} * i]);
    });
}

Task<Nodes> stand_at(Pace& pace, const Scene& scene, RunChain chain) {
    const size_t count = chain.nodes;
    Nodes nodes{std::move(chain), Buffer<double>(3 * count, pace.memory()), Buffer<double>(9 * count, pace.memory())};
    co_await stand(pace, scene, nodes);
    co_return nodes;
}

// What derivatives are taken of.
struct Steps {
    Buffer<double> moved, turned;
};

Vec3 turn_between(const Mat3& from, const Mat3& to) {
    const Eigen::AngleAxisd turn(Mat3(from.transpose() * to));
    return turn.angle() * turn.axis();
}

Task<Steps> steps_of(Pace& pace, const Scene& scene, const Nodes& nodes) {
    const uint32_t count = nodes.chain.nodes, steps = scene.closed() ? count : count - 1;
    Steps made{Buffer<double>(size_t{3} * steps, pace.memory()), Buffer<double>(size_t{3} * steps, pace.memory())};
    co_await each(pace, steps, Cost::hundreds_of_ns, [&](uint32_t i) {
        const uint32_t next = (i + 1) % count;
        for (size_t c = 0; c < 3; ++c)
            made.moved[size_t{3} * i + c] = nodes.places[size_t{3} * next + c] - nodes.places[size_t{3} * i + c];
        const Vec3 turn = turn_between(scene.rotations.rotation_of(&nodes.rotations[size_t{9} * i]),
                                       scene.rotations.rotation_of(&nodes.rotations[size_t{9} * next]));
        std::copy_n(turn.data(), 3, &made.turned[size_t{3} * i]);
    });
    co_return made;
}

// Puts barycentres and rotations together, and shows that.
Task<void> show_state(Pace& pace, const Scene& scene, const double* path, const double* rotations, MotionState& state) {
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
}

// Rounds of a motion that is one run and stays as it is.
class ShowRounds final : public RoundWatch {
public:
    ShowRounds(const Scene& scene, const Nodes& nodes, double path_energy, TripleBuffer<MotionState>& states)
        : scene_(scene), nodes_(nodes), path_energy_(path_energy), states_(states) {}

    Task<void> show(Pace& pace, const SplineReport& report) override { return show_round(pace, *this, report); }

private:
    static Task<void> show_round(Pace& pace, ShowRounds& self, const SplineReport& report) {
        MotionState& state = self.states_.write();
        state.report = report;
        state.barycentre_energy = self.path_energy_;
        co_await show_state(pace, self.scene_, self.nodes_.places.data(), self.nodes_.rotations.data(), state);
        self.states_.hand_over();
    }

    const Scene& scene_;
    const Nodes& nodes_;
    double path_energy_;
    TripleBuffer<MotionState>& states_;
};

struct Solution {
    SplineReport report;
    double path_energy = 0;
};

SplineEnding worse(SplineEnding a, SplineEnding b) {
    if (a == SplineEnding::rounds || b == SplineEnding::rounds) return SplineEnding::rounds;
    return a == SplineEnding::rounding || b == SplineEnding::rounding ? SplineEnding::rounding : a;
}

// The splines of all runs.
Task<Solution> solve(Pace& pace, const Scene& scene, Nodes& nodes, TripleBuffer<MotionState>* states) {
    Solution found;
    found.report.ending = SplineEnding::converged;
    pace.stage("barycentre");
    for (const MotionRun& run : scene.keys.runs()) {
        const RunScene of_run{scene.input, scene.keys, scene.rotations, run};
        const RunPart part = co_await part_of(pace, scene, nodes.chain, run);
        if (part.chain.nodes == nodes.chain.nodes) {
            found.path_energy += co_await run_path(pace, of_run, part.chain, nodes.places.data());
            continue;
        }
        Buffer<double> path(size_t{3} * part.chain.nodes, pace.memory());
        found.path_energy += co_await run_path(pace, of_run, part.chain, path.data());
        co_await copy_part(pace, part, nodes.chain.nodes, 3, path.data(), nodes.places.data(), true);
        // Around obstacles keys are passed to rounding: what stands is one place.
        co_await each(pace, run.keys, Cost::some_ns, [&](uint32_t k) {
            const size_t key = of_run.key(k);
            std::copy_n(&scene.keys.barycentres()[3 * key], 3, &nodes.places[size_t{3} * nodes.chain.knots[key]]);
        });
    }
    pace.stage("rotations");
    if (!scene.turns()) co_return found;
    for (const MotionRun& run : scene.keys.runs()) {
        const RunScene of_run{scene.input, scene.keys, scene.rotations, run};
        const RunPart part = co_await part_of(pace, scene, nodes.chain, run);
        SplineReport report;
        if (part.chain.nodes == nodes.chain.nodes) {
            std::optional<ShowRounds> watch;
            if (states) watch.emplace(scene, nodes, found.path_energy, *states);
            report =
                co_await run_rotations(pace, of_run, part.chain, nodes.rotations.data(), watch ? &*watch : nullptr);
        } else {
            Buffer<double> rotations(size_t{9} * part.chain.nodes, pace.memory());
            report = co_await run_rotations(pace, of_run, part.chain, rotations.data(), nullptr);
            co_await copy_part(pace, part, nodes.chain.nodes, 9, rotations.data(), nodes.rotations.data(), true);
        }
        found.report.ending = worse(report.ending, found.report.ending);
        found.report.rounds = std::max(found.report.rounds, report.rounds);
        found.report.residual = std::max(found.report.residual, report.residual);
        found.report.energy += report.energy;
    }
    co_return found;
}

// The cubics through a run's nodes: of places, and of rotations in R^9.
class RunCurve {
public:
    static Task<RunCurve> make(Pace& pace, const RunScene& scene, const RunPart& part, Nodes& nodes) {
        RunCurve curve(part.chain, pace.memory());
        curve.times_ = co_await node_times(pace, part.chain);
        const uint32_t all = nodes.chain.nodes;
        co_await copy_part(pace, part, all, 3, curve.places_.data(), nodes.places.data(), false);
        co_await copy_part(pace, part, all, 9, curve.rotations_.data(), nodes.rotations.data(), false);
        CubicData data{.knots = {curve.times_.data(), curve.times_.size()},
                       .values = {curve.places_.data(), curve.places_.size()},
                       .ends = scene.ends(),
                       .slopes = still,
                       .tension = scene.tension()};
        curve.place_.emplace(co_await natural_cubic(pace, data));
        data.values = {curve.rotations_.data(), curve.rotations_.size()};
        data.dimension = 9;
        curve.rotation_.emplace(co_await natural_cubic(pace, data));
        co_return curve;
    }
    double begin() const { return times_[0]; }
    double end() const { return times_[times_.size() - 1]; }
    std::span<const double> times() const { return {times_.data(), times_.size()}; }
    const NaturalCubic& place() const { return *place_; }
    const NaturalCubic& rotation() const { return *rotation_; }

private:
    static constexpr double still[18] = {};
    RunCurve(const RunChain& chain, Memory* memory)
        : places_(size_t{3} * chain.nodes, memory), rotations_(size_t{9} * chain.nodes, memory) {}
    Buffer<double> times_, places_, rotations_;
    std::optional<NaturalCubic> place_, rotation_;
};

// Nodes of another chain, where the path is at these parameters.
Task<Nodes> resample(Pace& pace, const Scene& scene, Nodes& from, RunChain chain, const Buffer<double>& parameters) {
    Nodes to = co_await stand_at(pace, scene, std::move(chain));
    const double period = from.chain.times[from.chain.times.size() - 1] - from.chain.times[0];
    for (const MotionRun& run : scene.keys.runs()) {
        const RunScene of_run{scene.input, scene.keys, scene.rotations, run};
        const RunPart part = co_await part_of(pace, scene, from.chain, run);
        const RunPart target = co_await part_of(pace, scene, to.chain, run);
        const RunCurve curve = co_await RunCurve::make(pace, of_run, part, from);
        uint32_t knot = 0;
        co_await each(pace, target.chain.nodes, Cost::microseconds, [&](uint32_t i) {
            const uint32_t node = (target.first + i) % to.chain.nodes;
            if (knot < target.chain.knots.size() && target.chain.knots[knot] == i) {
                ++knot;  // a key; with smoothing the path is elsewhere
                if (scene.input.desc.smoothing == 0) return;
            }
            const bool again = target.first + i >= to.chain.nodes;
            const double parameter = std::clamp(parameters[node] + (again ? period : 0), curve.begin(), curve.end());
            curve.place().evaluate(parameter, 0, &to.places[size_t{3} * node]);
            double* const rotation = &to.rotations[size_t{9} * node];
            curve.rotation().evaluate(parameter, 0, rotation);
            scene.rotations.project(rotation, nullptr);
        });
    }
    co_return to;
}

// Constant speed from pause to pause: of the barycentre, or the root mean square of the body's points.
Task<TimeLaw> even_law(Pace& pace, const Scene& scene, Nodes& nodes) {
    const Buffer<double> times = co_await node_times(pace, nodes.chain);
    const uint32_t all = nodes.chain.nodes;
    const auto steps = static_cast<uint32_t>(times.size()) - 1;
    const bool body = scene.input.desc.pacing == FLG_MOTION_PACING_BODY;
    TimeLaw law(times.size(), pace.memory());
    Buffer<double> lengths(steps, pace.memory());  // below 0: of a pause
    co_await each(pace, steps, Cost::some_ns, [&](uint32_t i) { lengths[i] = -1; });
    co_await each(pace, law.rates.size(), Cost::some_ns, [&](uint32_t i) { law.rates[i] = 0; });
    double whole = 0, moving = 0;
    for (const MotionRun& run : scene.keys.runs()) {
        const RunScene of_run{scene.input, scene.keys, scene.rotations, run};
        const RunPart part = co_await part_of(pace, scene, nodes.chain, run);
        const RunCurve curve = co_await RunCurve::make(pace, of_run, part, nodes);
        const auto speed_at = [&](double time) {
            double velocity[9], square = 0;
            curve.place().evaluate(time, 1, velocity);
            for (size_t c = 0; c < 3; ++c) square += velocity[c] * velocity[c];
            if (body) {
                curve.rotation().evaluate(time, 1, velocity);
                for (const double v : velocity) square += v * v / scene.input.body.mass;
            }
            return std::sqrt(square);
        };
        const auto own = static_cast<uint32_t>(curve.times().size()) - 1;
        co_await each(pace, own, Cost::microseconds, [&](uint32_t i) {
            const uint32_t step = (part.first + i) % all;
            const double a = curve.times()[i], b = curve.times()[i + 1], middle = 0.5 * (a + b);
            // A polyline has one speed from node to node.
            const bool bends = scene.input.bending() > 0;
            const double inner = speed_at(middle), first = bends ? speed_at(a) : inner,
                         last = bends ? speed_at(b) : inner;
            lengths[step] = (b - a) / 6 * (first + 4 * inner + last);
            law.rates[2 * size_t{step} + 1] = first;
            law.rates[2 * size_t{step} + 2] = last;
            whole += lengths[step];
        });
        moving += curve.end() - curve.begin();
    }
    const double speed = scene.input.desc.speed > 0 ? scene.input.desc.speed : whole / moving;
    co_await each(pace, steps, Cost::some_ns, [&](uint32_t i) {
        if (lengths[i] < 0) law.rates[2 * size_t{i} + 1] = law.rates[2 * size_t{i} + 2] = speed;
    });
    law.times[0] = times[0];
    co_await each(pace, times.size(), Cost::tens_of_ns, [&](uint32_t i) {
        law.parameters[i] = times[i];
        for (size_t side = 2 * size_t{i}; side < 2 * size_t{i} + 2; ++side) law.rates[side] = speed / law.rates[side];
        if (i == steps) return;
        const double step = times[i + 1] - times[i];
        law.times[i + 1] = law.times[i] + (lengths[i] < 0 ? step : lengths[i] / speed);
    });
    co_return law;
}

// One law after another: each one's parameters are the next one's times.
struct Laws {
    std::optional<TimeLaw> even, eased, limited;
    std::optional<RunChain> grid;  // of the limits
    bool any() const { return even || eased || limited; }
};

class LawsWalk {
public:
    explicit LawsWalk(const Laws& laws) {
        for (const auto* law : {&laws.limited, &laws.eased, &laws.even}) {
            if (*law) walks_[count_++].emplace(**law);
        }
    }
    double parameter_at(double time) {
        for (size_t i = 0; i < count_; ++i) time = walks_[i]->parameter_at(time);
        return time;
    }

private:
    std::array<std::optional<LawWalk>, 3> walks_;
    size_t count_ = 0;
};

// Of all nodes, and the end of a closed motion.
Task<Buffer<double>> parameters_of(Pace& pace, const Laws& laws, const RunChain& chain) {
    Buffer<double> parameters = co_await node_times(pace, chain);
    LawsWalk walk(laws);
    co_await each(pace, parameters.size(), Cost::hundreds_of_ns,
                  [&](uint32_t i) { parameters[i] = walk.parameter_at(parameters[i]); });
    co_return parameters;
}

// Times of keys, where a law has them among its entries.
Task<Buffer<double>> key_times(Pace& pace, const TimeLaw& law, const RunChain& chain) {
    Buffer<double> times(chain.times.size(), pace.memory());
    co_await each(pace, times.size(), Cost::some_ns, [&](uint32_t i) {
        times[i] = law.times[i < chain.knots.size() ? chain.knots[i] : chain.nodes];
        if (i > 0 && !(times[i] - times[i - 1] > min_segment * (law.times[chain.nodes - 1] - law.times[0]))) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "keys[%zu] has its barycentre where the one before it has: at constant speed of the path no "
                          "time is left to turn; FLG_MOTION_PACING_BODY counts turns too",
                          i % chain.knots.size());
        }
    });
    co_return times;
}

// As given, and where E1 comes to a pause or leaves one; none if nothing is eased.
Task<Buffer<double>> eases_of(Pace& pace, const Scene& scene) {
    const MotionKeys& keys = scene.keys;
    const auto& given = scene.input.eases;
    const size_t count = keys.count(), times = keys.times().size();
    const bool stops = scene.input.bending() == 0 && keys.segments() > 0;
    bool any = false;
    Buffer<double> eases(2 * times, pace.memory());
    co_await each(pace, times, Cost::some_ns, [&](uint32_t i) {
        for (size_t side = 0; side < 2; ++side) {
            const size_t key = i % count;
            double& ease = eases[2 * size_t{i} + side];
            ease = given.empty() ? 0 : given[2 * key + side];
            // The segments on this side and on the other; beyond the ends of open motions there are none.
            const size_t segments = keys.segments(), own = (key + side + segments - 1) % segments;
            const size_t other = (key + 1 - side + segments - 1) % segments;
            const bool has_own = scene.closed() || (side == 0 ? key > 0 : key < segments);
            const bool has_other = scene.closed() || (side == 0 ? key < segments : key > 0);
            if (has_own && keys.rests(own))
                ease = 0;
            else if (stops && has_other && keys.rests(other))
                ease = 1;
            any = any || ease > 0;
        }
    });
    if (!any) eases = Buffer<double>();
    co_return eases;
}

Task<void> set_rotations(Pace& pace, const Scene& scene, Nodes& nodes, const Buffer<double>& parameters,
                         const Buffer<double>* times, double* greatest_bank) {
    const Look& how = scene.input.look;
    const auto keys = scene.keys.times();
    const uint32_t count = nodes.chain.nodes;
    Buffer<double> rotations(size_t{9} * count, pace.memory());
    const LookNodes of{.parameters = {parameters.data(), count},
                       .places = {nodes.places.data(), nodes.places.size()},
                       .begin = keys.front(),
                       .end = keys.back(),
                       .closed = scene.closed()};
    co_await look(pace, how, of, rotations.data());
    if (times && how.bank > 0)
        *greatest_bank = co_await bank(pace, how, {times->data(), times->size()}, of, rotations.data());
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const Mat3 turn = Eigen::Map<const Mat3>(&rotations[size_t{9} * i]) * scene.input.body.axes;
        scene.rotations.point_of(turn, &nodes.rotations[size_t{9} * i]);
    });
}

// The laws of a motion, one after another. Returns the times of keys after them.
Task<Buffer<double>> find_laws(Pace& pace, const Scene& scene, Nodes& nodes, Laws& laws) {
    const auto given = scene.keys.times();
    Buffer<double> times(given.size(), pace.memory());
    co_await each(pace, given.size(), Cost::some_ns, [&](uint32_t i) { times[i] = given[i]; });
    if (scene.input.desc.pacing != FLG_MOTION_PACING_KEYS && !scene.keys.runs().empty()) {
        laws.even.emplace(co_await even_law(pace, scene, nodes));
        times = co_await key_times(pace, *laws.even, nodes.chain);
    }
    const Buffer<double> eases = co_await eases_of(pace, scene);
    if (!eases.empty()) {
        laws.eased.emplace(co_await eased_law(pace, {times.data(), times.size()}, {eases.data(), eases.size()}));
    }
    if (!scene.input.limits().any()) co_return times;
    const uint32_t least = law_intervals * scene.keys.segments() + 1;
    const uint32_t count = std::min(std::max(nodes.chain.nodes, least), FLG_MOTION_MAX_POSITIONS);
    RunChain grid = co_await share_nodes(pace, count, scene.keys.count(), {times.data(), times.size()});
    const Buffer<double> grid_times = co_await node_times(pace, grid);
    const Buffer<double> parameters = co_await parameters_of(pace, laws, grid);
    Nodes sampled = co_await resample(pace, scene, nodes, std::move(grid), parameters);
    if (!scene.turns()) co_await set_rotations(pace, scene, sampled, parameters, nullptr, nullptr);
    const Steps steps = co_await steps_of(pace, scene, sampled);
    const MotionSteps motion{.times = {grid_times.data(), grid_times.size()},
                             .moved = {steps.moved.data(), steps.moved.size()},
                             .turned = {steps.turned.data(), steps.turned.size()},
                             .closed = scene.closed(),
                             .kinks = {sampled.chain.knots.data(), sampled.chain.knots.size()}};
    laws.limited.emplace(co_await limited_law(pace, motion, scene.input.limits()));
    times = co_await key_times(pace, *laws.limited, sampled.chain);
    co_return times;
}

// Times of positions, and which of them keys are.
Task<void> show_chain(Pace& pace, const RunChain& chain, const Buffer<double>& times, Motion& out) {
    co_await each(pace, times.size(), Cost::some_ns, [&](uint32_t i) {
        out.times[i] = times[i];
        if (i < chain.knots.size()) out.key_positions[i] = chain.knots[i];
    });
}

// What the motion does at most.
Task<void> measure(Pace& pace, const Scene& scene, const Nodes& nodes, const Buffer<double>& times,
                   MotionState& state) {
    const Steps steps = co_await steps_of(pace, scene, nodes);
    const MotionSteps motion{.times = {times.data(), times.size()},
                             .moved = {steps.moved.data(), steps.moved.size()},
                             .turned = {steps.turned.data(), steps.turned.size()},
                             .closed = scene.closed(),
                             .kinks = {nodes.chain.knots.data(), nodes.chain.knots.size()}};
    state.length = state.speed = state.acceleration = state.turn = 0;
    const auto count = static_cast<uint32_t>(times.size()) - 1;
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
        const double length = Eigen::Map<const Vec3>(&steps.moved[size_t{3} * i]).norm();
        state.length += length;
        state.speed = std::max(state.speed, length / (times[i + 1] - times[i]));
        state.turn = std::max(state.turn,
                              Eigen::Map<const Vec3>(&steps.turned[size_t{3} * i]).norm() / (times[i + 1] - times[i]));
    });
    co_await each(pace, nodes.chain.nodes, Cost::hundreds_of_ns, [&](uint32_t i) {
        for (const NodeSide side : {NodeSide::before, NodeSide::after})
            state.acceleration = std::max(state.acceleration, motion_at(motion, i, side).acceleration.norm());
    });
}

}  // namespace

Motion::Motion(MotionInput given, Memory* memory)
    : input(std::move(given)),
      times(input.desc.position_count + (input.desc.closed ? 1 : 0), memory),
      key_positions(input.desc.key_count, memory) {
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
    view_.key_count = input.desc.key_count;
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
    view_.length = state.length;
    view_.greatest_speed = state.speed;
    view_.greatest_acceleration = state.acceleration;
    view_.greatest_turn = state.turn;
    view_.greatest_bank = state.bank;
}

Task<void> make_motion(Pace& pace, std::shared_ptr<Motion> out) {
    const MotionInput& input = out->input;
    pace.stage("keys");
    const MotionKeyInput given{.times = input.times,
                               .poses = input.poses,
                               .closed = input.desc.closed != 0,
                               .end_time = input.desc.end_time,
                               .timing = static_cast<KeyTiming>(input.desc.timing),
                               .speed = input.desc.speed > 0 ? input.desc.speed : 1,
                               .eases = input.eases,
                               .turns = input.look.kind == LookKind::keys,
                               .pauses = input.desc.smoothing == 0};
    const MotionKeys keys = co_await check_keys(pace, given, input.body);
    out->greatest_stretch = keys.greatest_stretch();
    const RotationManifold rotations(input.body.f);
    const Scene scene{input, keys, rotations};
    Nodes nodes = co_await stand_at(pace, scene,
                                    co_await share_nodes(pace, input.desc.position_count, keys.count(), keys.times()));
    Buffer<double> times = co_await node_times(pace, nodes.chain);
    co_await show_chain(pace, nodes.chain, times, *out);

    const bool moved = input.desc.pacing != FLG_MOTION_PACING_KEYS || !input.eases.empty() || input.limits().any() ||
                       input.look.kind != LookKind::keys;
    const bool partial = pace.job().partial_results && !moved;
    const Solution found = co_await solve(pace, scene, nodes, partial ? &out->states : nullptr);

    pace.stage("times");
    Laws laws;
    const Buffer<double> of_keys = co_await find_laws(pace, scene, nodes, laws);
    MotionState& state = out->states.write();
    state.bank = 0;
    Buffer<double> parameters;
    if (laws.any()) {
        RunChain chain = co_await share_nodes(pace, nodes.chain.nodes, keys.count(), {of_keys.data(), of_keys.size()});
        times = co_await node_times(pace, chain);
        parameters = co_await parameters_of(pace, laws, chain);
        nodes = co_await resample(pace, scene, nodes, std::move(chain), parameters);
        co_await show_chain(pace, nodes.chain, times, *out);
    }
    if (!scene.turns()) {
        pace.stage("look");
        co_await set_rotations(pace, scene, nodes, laws.any() ? parameters : times, &times, &state.bank);
    }
    state.report = found.report;
    state.barycentre_energy = found.path_energy;
    co_await measure(pace, scene, nodes, times, state);
    co_await show_state(pace, scene, nodes.places.data(), nodes.rotations.data(), state);
    out->states.hand_over();
}

}  // namespace flg
