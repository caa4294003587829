// SPDX-License-Identifier: MIT
// Splines among obstacles, in R^d or on a surface (Hofer, Pottmann 2004, sec. 5): minimizers on barriers around them
// whose radius shrinks.
//
// Invariants: the chain and the cubic spline through it keep their clearance everywhere (clearance.h); given points
// stay where they are, to the bit.
// Departures from the paper, which looks at nodes alone: nodes keep a margin more than the clearance, intervals that
// are not clear get more nodes, and the job fails where that does not do.
#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "splines/manifolds/coordinates.h"
#include "splines/obstacles/clearance.h"
#include "splines/obstacles/evaluations.h"
#include "splines/obstacles/obstacle_path.h"
#include "splines/obstacles/surface_barrier.h"
#include "splines/spline.h"
#include "splines/surface_way.h"

namespace flg {

namespace {

constexpr uint32_t lift_work = 4;     // of Cost::microseconds: two a slice
constexpr double first_share = 0.05;  // of the scene's size: the first radius
constexpr double shrink = 0.35;       // of the radius, from one solve to the next
constexpr double rough = 1e-2;        // the tolerance before the last one
// Nodes keep so much farther away than the curve has to, of the last radius, and a part of that is spare.
constexpr double margin_share = 0.1, spare_share = 0.25, max_margin = 5;
constexpr double allowance = 2e-7;  // of the scene's size: what rounding may do
constexpr double least_way = 0.01;  // of the margin: chords of the first chain are clear by
constexpr uint32_t max_halvings = 6, max_parts = 16, max_passes = 6;
// On a barrier before the last one: what is more changes little in the end.
constexpr uint32_t descent_rounds = 16, descent_work = 80;
constexpr uint32_t settle_work = 800;  // what takes more has stalled

// From the beginning, where the one before did not do: so many times the nodes that are wanted, of which the barriers
// before the last one see a part.
struct Attempt {
    uint32_t finer, coarse;
};
constexpr Attempt attempts[] = {{1, 4}, {1, 1}, {4, 1}};

// The diameter of all that there is.
double scene_size(const ObstacleSet& set, const Buffer<double>& points) {
    const uint32_t d = set.dimension();
    Obstacle::Box box;
    if (!set.box(box)) {
        std::copy_n(points.begin(), d, box.lower.begin());
        box.upper = box.lower;
    }
    double square = 0;
    for (uint32_t c = 0; c < d; ++c) {
        double lower = box.lower[c], upper = box.upper[c];
        for (size_t i = c; i < points.size(); i += d) {
            lower = std::min(lower, points[i]);
            upper = std::max(upper, points[i]);
        }
        square += (upper - lower) * (upper - lower);
    }
    return std::sqrt(square);
}

// Over free space or over a surface.
class Barrier {
public:
    Barrier(const ManifoldProduct& held, const ObstacleSet& set, double size, double last_radius)
        : first_radius_(std::min(std::max(first_share * size, last_radius), 0.9 * set.reach())) {
        const double radius = first_radius_;
        if (held.kind == ManifoldKind::space) {
            space_.emplace(set, radius, size);
        } else {
            surface_.emplace(static_cast<const Hypersurface&>(*held.manifold), set, radius);
        }
    }
    const Manifold& manifold() const { return space_ ? static_cast<const Manifold&>(*space_) : *surface_; }
    double first_radius() const { return first_radius_; }
    void set_radius(double radius) { space_ ? space_->set_radius(radius) : surface_->set_radius(radius); }
    // hint: of the manifold, zeros.
    bool lift(const double* point, double* hint, double* x) const {
        return space_ ? space_->lift(point, x) : surface_->lift(point, hint, x);
    }

private:
    double first_radius_;
    std::optional<BarrierSurface> space_;
    std::optional<SurfaceBarrier> surface_;
};

// Around the obstacles.
Task<void> find_beginning(Pace& pace, const SplineRequest& request, const ObstacleSet& wider, double margin,
                          GivenPoints given, FirstCurve& first, Evaluations& evaluations) {
    const ManifoldProduct& held = *request.out->manifold;
    const std::span<const ObstacleSide> sides(request.sides.data(), request.sides.size());
    if (held.kind != ManifoldKind::space) {
        co_await refuse_inside(pace, wider, given.values, margin);
        co_await find_first_curve(pace, held, given, first);
        co_await lead_around(pace, static_cast<const Hypersurface&>(*held.manifold), wider, sides, least_way * margin,
                             given, first, evaluations);
        co_return;
    }
    ObstaclePath path = co_await obstacle_path(pace, wider, given.values, given.closed, sides, margin, &evaluations);
    first.points = std::move(path.points);
    for (size_t i = 1; i < path.given.size(); ++i) first.ends.push_back(path.given[i] + 1);
}

// A chain of nodes, d numbers each, without a barrier's height.
struct Chain {
    explicit Chain(Memory* memory) : points(memory), knots(memory), shares(memory) {}

    void reserve(size_t nodes, uint32_t d) {
        points.reserve(nodes * d);
        shares.reserve(nodes);
    }

    std::pmr::vector<double> points;
    std::pmr::vector<uint32_t> knots;  // the nodes of given points
    std::pmr::vector<double> shares;   // of each interval, of its segment's parameters
};

// A segment of the first curve, by lengths.
class Polyline {
public:
    Polyline(const FirstCurve& first, uint32_t segment, uint32_t dimension, Memory* memory)
        : points_(first.points),
          begin_(segment == 0 ? 0 : first.ends[segment - 1] - 1),
          d_(dimension),
          lengths_(memory) {
        double length = 0;
        lengths_.push_back(0);
        for (uint32_t p = begin_; p + 1 < first.ends[segment]; ++p) {
            length += distance_between(&points_[size_t{p} * d_], &points_[size_t{p + 1} * d_], d_);
            lengths_.push_back(length);
        }
    }
    // share: of its length.
    void place(double share, double* out) const {
        const double target = share * lengths_.back();
        const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, target);
        const auto piece = static_cast<size_t>(after - lengths_.begin()) - 1;
        const double step = *after - lengths_[piece],
                     t = step > 0 ? std::clamp((target - lengths_[piece]) / step, 0.0, 1.0) : 0;
        const double* const a = &points_[(begin_ + piece) * d_];
        for (uint32_t c = 0; c < d_; ++c) out[c] = (1 - t) * a[c] + t * a[d_ + c];
    }

private:
    const std::pmr::vector<double>& points_;
    uint32_t begin_, d_;
    std::pmr::vector<double> lengths_;
};

// How many intervals place_nodes() gave each segment.
Task<Buffer<uint32_t>> intervals_of(Pace& pace, const SplineProblem& problem, uint32_t segments, uint32_t dimension) {
    const auto nodes = static_cast<uint32_t>(problem.points.size() / dimension);
    Buffer<uint32_t> out(segments, pace.memory());
    co_await each(pace, segments, Cost::some_ns, [&](uint32_t s) {
        out[s] = (s + 1 < problem.knots.size() ? problem.knots[s + 1] : nodes) - problem.knots[s];
    });
    co_return out;
}

// A `coarse`-th of that many intervals a segment, and more where their chords are not clear.
Task<void> place_around(Pace& pace, const ObstacleSet& set, const FirstCurve& first, const Buffer<uint32_t>& wanted,
                        uint32_t coarse, double margin, Chain& out) {
    const uint32_t d = set.dimension(), segments = static_cast<uint32_t>(first.ends.size());
    size_t nodes = 0;
    co_await each(pace, segments, Cost::some_ns, [&](uint32_t s) { nodes += wanted[s] / coarse + 1; });
    out.reserve(2 * nodes, d);
    for (uint32_t s = 0; s < segments; ++s) {
        const Polyline line(first, s, d, pace.memory());
        const uint32_t intervals = std::max(wanted[s] / coarse, std::min(wanted[s], 2u));
        out.knots.push_back(static_cast<uint32_t>(out.points.size() / d));
        for (uint32_t i = 0; i < intervals; ++i) {
            // Halves of halves: `part` of 2^level.
            for (uint32_t level = 0, part = 0;;) {
                const double width = std::ldexp(1.0 / intervals, -static_cast<int>(level)),
                             begin = static_cast<double>(i) / intervals + part * width;
                Obstacle::Place a{}, b{};
                line.place(begin, a.data());
                line.place(begin + width, b.data());
                bool clear = level == max_halvings;
                if (!clear) clear = co_await is_clear(pace, set, a, b, margin);
                if (!clear) {
                    ++level;
                    part *= 2;
                    continue;
                }
                out.points.insert(out.points.end(), a.begin(), a.begin() + d);
                out.shares.push_back(width);
                for (++part; level > 0 && part % 2 == 0; part /= 2) --level;
                if (level == 0) break;
            }
        }
    }
}

// The last node of an open chain.
void finish(const FirstCurve& first, uint32_t d, Chain& out) {
    out.knots.push_back(static_cast<uint32_t>(out.points.size() / d));
    out.points.insert(out.points.end(), first.points.end() - d, first.points.end());
}

// Each interval becomes parts[i], new nodes on its chord.
Task<void> split(Pace& pace, const Buffer<uint8_t>& parts, uint32_t d, bool closed, Chain& chain) {
    const auto nodes = static_cast<uint32_t>(chain.points.size() / d);
    const auto intervals = static_cast<uint32_t>(parts.size());
    size_t count_of_all = closed ? 0 : 1;
    co_await each(pace, intervals, Cost::some_ns, [&](uint32_t i) { count_of_all += parts[i]; });
    Chain finer(pace.memory());
    finer.reserve(count_of_all, d);
    size_t knot = 0;
    co_await each(pace, nodes, Cost::tens_of_ns, [&](uint32_t i) {
        if (knot < chain.knots.size() && chain.knots[knot] == i) {
            finer.knots.push_back(static_cast<uint32_t>(finer.points.size() / d));
            ++knot;
        }
        const double* const a = &chain.points[size_t{i} * d];
        const double* const b = &chain.points[size_t{(i + 1) % nodes} * d];
        const uint32_t count = i < intervals ? parts[i] : 1;
        for (uint32_t part = 0; part < count; ++part) {
            const double t = static_cast<double>(part) / count;
            for (uint32_t c = 0; c < d; ++c) finer.points.push_back((1 - t) * a[c] + t * b[c]);
            if (i < intervals) finer.shares.push_back(chain.shares[i] / count);
        }
    });
    chain = std::move(finer);
}

// Intervals that trespass get more nodes, the more the deeper they are, and so do their neighbours, so that nodes come
// to stand before and behind what they pass. New nodes are on the chords.
Task<void> refine(Pace& pace, const std::pmr::vector<Trespass>& trespasses, uint32_t d, bool closed, double margin,
                  Chain& chain) {
    const auto nodes = static_cast<uint32_t>(chain.points.size() / d), intervals = closed ? nodes : nodes - 1;
    Buffer<uint8_t> parts(intervals, pace.memory());
    co_await each(pace, intervals, Cost::some_ns, [&](uint32_t i) { parts[i] = 1; });
    co_await each(pace, trespasses.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Trespass& trespass = trespasses[i];
        const double wanted = std::ceil(trespass.depth / margin);
        const auto own = static_cast<uint8_t>(std::clamp(wanted, 2.0, double{max_parts}));
        const uint8_t beside = own / 2;
        parts[trespass.interval] = std::max(parts[trespass.interval], own);
        const uint32_t before = (trespass.interval + intervals - 1) % intervals,
                       after = (trespass.interval + 1) % intervals;
        parts[before] = std::max(parts[before], beside);
        parts[after] = std::max(parts[after], beside);
    });
    co_await split(pace, parts, d, closed, chain);
}

// Intervals that are longer than an even share of those wanted become several.
Task<void> densify(Pace& pace, const Buffer<uint32_t>& wanted, uint32_t d, bool closed, Chain& chain) {
    Buffer<uint8_t> parts(chain.shares.size(), pace.memory());
    uint32_t segment = 0;
    co_await each(pace, parts.size(), Cost::some_ns, [&](uint32_t i) {
        if (segment + 1 < wanted.size() && chain.knots[segment + 1] == i) ++segment;
        parts[i] =
            static_cast<uint8_t>(std::clamp(std::round(chain.shares[i] * wanted[segment]), 1.0, double{max_parts}));
    });
    co_await split(pace, parts, d, closed, chain);
}

// The chain on the barrier, as it is now. Given points that are nearer than the nodes' margin are moved out.
Task<void> lift_chain(Pace& pace, const Barrier& barrier, const Chain& chain, SplineProblem& problem) {
    const uint32_t n = barrier.manifold().ambient(), d = n - 1;
    const size_t nodes = chain.points.size() / d;
    std::pmr::vector<double> hint(barrier.manifold().hint_size(), 0.0, pace.memory());
    problem.points = Buffer<double>(nodes * n, pace.memory());
    const auto lift = [&](size_t i) {
        std::fill(hint.begin(), hint.end(), 0.0);
        return barrier.lift(&chain.points[i * d], hint.data(), &problem.points[i * n]);
    };
    co_await each_by_work(pace, nodes, Cost::microseconds, [&](size_t i) {
        lift(i);
        return lift_work;
    });
    problem.knots = Buffer<uint32_t>(chain.knots.size(), pace.memory());
    problem.given = Buffer<double>(chain.knots.size() * n, pace.memory());
    problem.shares = Buffer<double>(chain.shares.size(), pace.memory());
    co_await each(pace, chain.shares.size(), Cost::some_ns, [&](size_t i) { problem.shares[i] = chain.shares[i]; });
    co_await each_by_work(pace, chain.knots.size(), Cost::microseconds, [&](size_t k) {
        const size_t node = problem.knots[k] = chain.knots[k];
        if (lift(node)) std::copy_n(&chain.points[node * d], d, &problem.points[node * n]);
        std::copy_n(&problem.points[node * n], n, &problem.given[k * n]);
        return lift_work;
    });
}

// The chain goes to where its energy is least on the barrier. Given points stay, to the bit. False where it can't be
// put onto the barrier.
Task<bool> minimize_on(Pace& pace, const Barrier& barrier, SplineOptimizer& optimizer, Spline& out, Chain& chain) {
    const uint32_t d = barrier.manifold().ambient() - 1;
    try {
        co_await run_optimizer(pace, optimizer, out);
    } catch (const OffSurface&) {
        co_return false;
    }
    size_t knot = 0;
    co_await each(pace, optimizer.nodes(), Cost::some_ns, [&](uint32_t i) {
        if (knot < chain.knots.size() && chain.knots[knot] == i) {
            ++knot;
            return;
        }
        std::copy_n(optimizer.points() + size_t{i} * (d + 1), d, &chain.points[size_t{i} * d]);
    });
    co_return true;
}

// What stays: the optimizer's, with given points where they were given.
Task<void> keep_chain(Pace& pace, SplineOptimizer& optimizer, const Chain& chain, Spline& out) {
    co_await keep_spline(pace, optimizer, out);
    const size_t n = optimizer.ambient(), d = n - 1;
    out.knots = Buffer<uint32_t>(chain.knots.size(), pace.memory());
    co_await each(pace, chain.knots.size(), Cost::some_ns, [&](uint32_t k) { out.knots[k] = chain.knots[k]; });
    co_await each(pace, chain.knots.size(), Cost::some_ns, [&](uint32_t k) {
        const size_t node = chain.knots[k];
        std::copy_n(&chain.points[node * d], d, &out.points[node * n]);
        std::copy_n(&chain.points[node * d], d, &out.chain.nodes[node * d]);
    });
}

// Of CurvePieces.
struct Leave {
    Buffer<double> allowed, spare;  // one an interval
};

// Of the chain, and of the cubic spline through it if it bends.
// Returns how many places were looked at.
Task<uint64_t> examine(Pace& pace, const ObstacleSet& set, const SplineOptimizer& optimizer,
                       const SplineProblem& problem, const Chain& chain, const Leave& leave,
                       std::pmr::vector<Trespass>& out) {
    const uint32_t d = set.dimension(), nodes = optimizer.nodes();
    Moments moments(nodes, d, problem.closed, 0, pace.memory());
    co_await each(pace, moments.steps().size(), Cost::some_ns,
                  [&](uint32_t i) { moments.steps()[i] = optimizer.step_after(i); });
    Buffer<double> second(problem.bending > 0 ? size_t{nodes} * d : 0, pace.memory());
    if (problem.bending > 0) {
        co_await Moments::factorize(pace, moments);
        co_await Moments::solve(pace, moments, chain.points.data(), second.data());
    }
    const CurvePieces pieces{{chain.points.data(), chain.points.size()},
                             moments.steps(),
                             {second.data(), second.size()},
                             {leave.allowed.data(), leave.allowed.size()},
                             {leave.spare.data(), leave.spare.size()},
                             problem.closed};
    co_return co_await find_trespasses(pace, set, pieces, out);
}

// evaluations: that were used up; 0: they were not.
[[noreturn]] void refuse(const std::pmr::vector<Trespass>& trespasses, const Chain& chain, uint32_t d,
                         uint64_t evaluations) {
    const auto used = static_cast<unsigned long long>(evaluations);
    if (trespasses.empty())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.max_evaluations, %llu, were used up before there was a curve to look at", used);
    const Trespass worst = *std::max_element(trespasses.begin(), trespasses.end(),
                                             [](const Trespass& a, const Trespass& b) { return a.depth < b.depth; });
    const double* const at = &chain.points[size_t{worst.interval} * d];
    const double z = d > 2 ? at[2] : 0;
    if (evaluations > 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.max_evaluations, %llu, were used up before the curve kept clear of obstacle %u near (%g, "
                      "%g, %g), where it was %g nearer than it may be",
                      used, worst.obstacle, at[0], at[1], z, worst.depth);
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "the curve can't keep clear of obstacle %u near (%g, %g, %g): it is %g nearer than it may be there",
                  worst.obstacle, at[0], at[1], z, worst.depth);
}

// Metres.
struct Margins {
    double size = 0;         // of the scene
    double last_radius = 0;  // of barriers
    double margin = 0;       // by which nodes keep farther away than the curve has to
    double slack = 0;        // by which the curve may come nearer
};

// Beside given points that are nearer than the nodes' margin the curve may come nearer by that.
Task<Leave> leave_of(Pace& pace, const ObstacleSet& set, const Chain& chain, const Margins& scene, bool closed) {
    const uint32_t d = set.dimension();
    const size_t intervals = chain.shares.size();
    Leave out{Buffer<double>(intervals, pace.memory()), Buffer<double>(intervals, pace.memory())};
    co_await each(pace, intervals, Cost::some_ns, [&](uint32_t i) {
        out.spare[i] = spare_share * scene.margin;
        out.allowed[i] = scene.slack;
    });
    co_await each(pace, chain.knots.size(), Cost::microseconds, [&](uint32_t k) {
        const size_t node = chain.knots[k];
        if (set.distance(&chain.points[node * d]) >= scene.margin) return;
        for (size_t beside = 0; beside < 4; ++beside) {
            const size_t interval = node + intervals + beside - 2;
            if (closed || (interval >= intervals && interval < 2 * intervals))
                out.allowed[interval % intervals] = scene.margin;
        }
    });
    co_return out;
}

// What is sought, and among what.
struct Search {
    const ObstacleSet& set;
    ObstacleSet& wider;  // by the nodes' margin
    Margins scene;
    SplineProblem& problem;
    Spline& out;
    Chain& chain;
    Evaluations& evaluations;
    std::pmr::vector<Trespass> trespasses;  // of what was looked at last
    double result_radius = HUGE_VAL;        // of the barrier that the result is from
    bool can_project = true;
    bool is_cut_short = false;  // the last minimum, by evaluations

    bool has_result() const { return result_radius < HUGE_VAL; }
};

// Minimizes on the barrier, as it is. False where that can't be begun.
Task<bool> minimize(Pace& pace, Search& s, const Barrier& barrier, uint32_t most_work,
                    std::optional<SplineOptimizer>& optimizer) {
    co_await lift_chain(pace, barrier, s.chain, s.problem);
    const uint32_t left = s.evaluations.of_curves(static_cast<uint32_t>(s.chain.shares.size()) + 1);
    s.problem.max_work = std::min(left, most_work);
    optimizer.emplace(s.problem, pace.memory());
    s.can_project = co_await minimize_on(pace, barrier, *optimizer, s.out, s.chain);
    const SplineReport& report = optimizer->report();
    const uint64_t work = uint64_t{report.rounds} + report.projections + 1;
    s.evaluations.spend(work * optimizer->nodes());
    s.is_cut_short = report.ending == SplineEnding::rounds && work > left;
    if (s.is_cut_short) s.evaluations.spend_all();
    co_return s.can_project;
}

// Whether all of it is clear: then it is a result, until there is one of a narrower barrier.
Task<bool> accept(Pace& pace, Search& s, double radius, SplineOptimizer& optimizer) {
    const Leave leave = co_await leave_of(pace, s.set, s.chain, s.scene, s.problem.closed);
    s.trespasses.clear();
    const uint64_t looks = co_await examine(pace, s.set, optimizer, s.problem, s.chain, leave, s.trespasses);
    s.evaluations.spend_looks(looks);
    if (!s.trespasses.empty()) co_return false;
    if (radius > s.result_radius) co_return true;
    co_await keep_chain(pace, optimizer, s.chain, s.out);
    s.result_radius = radius;
    co_return true;
}

// On barriers whose radius shrinks to that before the last one or, where `to_last`, to that.
Task<void> descend(Pace& pace, Search& s, Barrier& barrier, bool to_last) {
    const double tolerance = s.problem.tolerance, last = s.scene.last_radius;
    const uint32_t rounds = s.problem.max_rounds;
    s.problem.tolerance = rough;
    s.problem.max_rounds = std::min(rounds, descent_rounds);
    for (double radius = barrier.first_radius(); !s.evaluations.are_spent() && (to_last || radius > last);
         radius = std::max(radius * shrink, last)) {
        barrier.set_radius(radius);
        std::optional<SplineOptimizer> optimizer;
        const bool begins = co_await minimize(pace, s, barrier, descent_work, optimizer);
        if (!begins) break;
        co_await accept(pace, s, radius, *optimizer);
        if (radius == last) break;
    }
    barrier.set_radius(last);
    s.problem.tolerance = tolerance;
    s.problem.max_rounds = rounds;
}

// On the last barrier, until all of the curve is clear: with more nodes where it is not, which then keep farther away,
// from what the solids are exactly. False if it is not clear in the end.
Task<bool> settle(Pace& pace, Search& s, const Barrier& barrier) {
    const uint32_t d = s.set.dimension();
    double margin = s.scene.margin;
    for (uint32_t pass = 0; !s.evaluations.are_spent(); ++pass) {
        std::optional<SplineOptimizer> optimizer;
        const bool begins = co_await minimize(pace, s, barrier, settle_work, optimizer);
        if (!begins) break;
        const bool is_clear = co_await accept(pace, s, s.scene.last_radius, *optimizer);
        if (is_clear) co_return true;
        // What was looked at stays as it is.
        if (pass + 1 == max_passes || s.chain.points.size() / d > FLG_SPLINE_MAX_NODES / 4 || s.evaluations.are_spent())
            break;
        co_await refine(pace, s.trespasses, d, s.problem.closed, margin, s.chain);
        s.wider.set_smooth(false);
        margin = std::min(1.5 * margin, max_margin * s.scene.margin);
        s.wider.set_clearance(s.set.clearance() + margin);
    }
    co_return false;
}

}  // namespace

Task<void> make_obstacle_spline(Pace& pace, SplineRequest& request) {
    Spline& out = *request.out;
    SplineProblem& problem = request.problem;
    const ObstacleSet& set =
        request.placed.emplace(request.obstacles, out.origin, request.more_clearance, pace.memory()).set();
    const uint32_t d = set.dimension();
    pace.stage("begin");
    const ManifoldProduct& held = *out.manifold;
    problem.manifold = held.manifold.get();
    out.closed = problem.closed;
    Buffer<double> placed;
    co_await place_spline_points(pace, held, request.points, "desc.points", placed, &out.offsets);
    co_await refuse_coincident(pace, placed, d, problem.closed, problem.manifold->size());
    const GivenPoints given{
        .values = {placed.data(), placed.size()}, .closed = problem.closed, .argument = "desc.points"};
    Margins scene{.size = scene_size(set, placed)};
    scene.last_radius = request.desc.obstacle_radius * scene.size;
    scene.margin = std::min(margin_share * scene.last_radius, 0.01 * set.reach());
    scene.slack = allowance * scene.size;
    ObstacleSet wider(set, pace.memory());
    wider.set_clearance(set.clearance() + scene.margin);
    const uint32_t segments = given.segments(d);
    const uint32_t nodes = request.desc.node_count > 0
                               ? request.desc.node_count
                               : std::min(32 * segments + (problem.closed ? 0 : 1), FLG_SPLINE_MAX_NODES);
    const uint64_t most = request.desc.max_evaluations;
    Evaluations evaluations(most == default_evaluations ? default_evaluations_of(nodes) : most, set.count());
    FirstCurve first(pace.memory());
    co_await find_beginning(pace, request, wider, scene.margin, given, first, evaluations);
    pace.stage("minimize");
    Chain chain(pace.memory());
    Search search{.set = set,
                  .wider = wider,
                  .scene = scene,
                  .problem = problem,
                  .out = out,
                  .chain = chain,
                  .evaluations = evaluations,
                  .trespasses = std::pmr::vector<Trespass>(pace.memory())};
    bool is_clear = false;
    for (const Attempt& attempt : attempts) {
        if (attempt.finer > 1 && uint64_t{attempt.finer} * nodes > FLG_SPLINE_MAX_NODES / 4) break;
        if (evaluations.are_spent()) break;
        problem.manifold = held.manifold.get();
        co_await place_nodes(pace, *problem.manifold, first, given, attempt.finer * nodes, 2, problem);
        const Buffer<uint32_t> wanted = co_await intervals_of(pace, problem, segments, d);
        chain = Chain(pace.memory());
        wider.set_clearance(set.clearance() + scene.margin);
        wider.set_smooth(true);
        co_await place_around(pace, wider, first, wanted, attempt.coarse, least_way * scene.margin, chain);
        if (!problem.closed) finish(first, d, chain);
        Barrier barrier(held, wider, scene.size, scene.last_radius);
        problem.manifold = &barrier.manifold();
        co_await descend(pace, search, barrier, attempt.coarse > 1);
        if (attempt.coarse > 1) co_await densify(pace, wanted, d, problem.closed, chain);
        is_clear = co_await settle(pace, search, barrier);
        if (is_clear) break;
    }
    if (!search.has_result() && !search.can_project && search.trespasses.empty() && !evaluations.are_spent())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the curve can't be put onto the barriers around the obstacles");
    if (!search.has_result()) refuse(search.trespasses, chain, d, evaluations.are_spent() ? evaluations.most() : 0);
    out.out_of_evaluations = is_clear ? search.is_cut_short : evaluations.are_spent();
    if (!is_clear && !out.out_of_evaluations) out.chain.report.ending = SplineEnding::stalled;
    problem.manifold = held.manifold.get();
}

}  // namespace flg
