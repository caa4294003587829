// SPDX-License-Identifier: MIT
// Splines of R^d among obstacles (Hofer, Pottmann 2004, sec. 5): minimizers on barriers around them whose radius
// shrinks.
#include <cmath>

#include "core/failure.h"
#include "splines/manifolds/coordinates.h"
#include "splines/obstacles/obstacle_path.h"
#include "splines/obstacles/surface_barrier.h"
#include "splines/spline.h"

namespace flg {

namespace {

constexpr uint32_t lift_work = 4;      // of Cost::microseconds: two a slice
constexpr double first_radius = 0.05;  // of the scene's size
constexpr double shrink = 0.35;        // of the radius, from one solve to the next
constexpr uint32_t max_refinement = 16;
constexpr double rough = 1e-2;  // the tolerance before the last one

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
    Barrier(const ManifoldProduct& held, const ObstacleSet& set, double radius, double size) {
        if (held.kind == ManifoldKind::space) {
            space_.emplace(set, radius, size);
        } else {
            surface_.emplace(static_cast<const Hypersurface&>(*held.manifold), set, radius);
        }
    }
    const Manifold& manifold() const { return space_ ? static_cast<const Manifold&>(*space_) : *surface_; }
    void set_radius(double radius) { space_ ? space_->set_radius(radius) : surface_->set_radius(radius); }
    // hint: of the manifold, zeros.
    bool lift(const double* point, double* hint, double* x) const {
        return space_ ? space_->lift(point, x) : surface_->lift(point, hint, x);
    }

private:
    std::optional<BarrierSurface> space_;
    std::optional<SurfaceBarrier> surface_;
};

// The chain with d coordinates a node, on the barrier as it is now.
Task<void> lift_chain(Pace& pace, const Barrier& barrier, const Buffer<double>& flat, const Buffer<double>& given,
                      SplineProblem& problem) {
    const uint32_t n = barrier.manifold().ambient(), d = n - 1;
    const size_t nodes = flat.size() / d;
    std::pmr::vector<double> hint(barrier.manifold().hint_size(), 0.0, pace.memory());
    problem.points = Buffer<double>(nodes * n, pace.memory());
    co_await each_by_work(pace, nodes, Cost::microseconds, [&](size_t i) {
        std::fill(hint.begin(), hint.end(), 0.0);
        barrier.lift(&flat[i * d], hint.data(), &problem.points[i * n]);
        return lift_work;
    });
    problem.given = Buffer<double>(given.size() / d * n, pace.memory());
    co_await each_by_work(pace, given.size() / d, Cost::microseconds, [&](size_t k) {
        std::fill(hint.begin(), hint.end(), 0.0);
        if (!barrier.lift(&given[k * d], hint.data(), &problem.given[k * n])) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.points: point %zu is in an obstacle or nearer than the clearance", k);
        }
        return lift_work;
    });
}

// In space around the obstacles, on a surface as if there were none.
Task<void> find_beginning(Pace& pace, const SplineRequest& request, GivenPoints given, FirstCurve& first) {
    const ManifoldProduct& held = *request.out->manifold;
    if (held.kind != ManifoldKind::space) {
        co_await find_first_curve(pace, held, given, first);
        co_return;
    }
    const std::span<const ObstacleSide> sides(request.sides.data(), request.sides.size());
    ObstaclePath path = co_await obstacle_path(pace, request.placed->set(), given.values, given.closed, sides);
    first.points = std::move(path.points);
    for (size_t i = 1; i < path.given.size(); ++i) first.ends.push_back(path.given[i] + 1);
}

// Whether a piece of the chain goes through a solid from one side to the other: what is nearest to its ends is between
// them.
bool straddles(const ObstacleSet& set, const double* a, const double* b) {
    const uint32_t d = set.dimension();
    double to_a[Obstacle::max_dimension], to_b[Obstacle::max_dimension], heading_a = 0, heading_b = 0, opposed = 0;
    const double length = distance_between(a, b, d), at_a = set.distance(a, nullptr, to_a),
                 at_b = set.distance(b, nullptr, to_b);
    for (uint32_t c = 0; c < d; ++c) {
        heading_a += (b[c] - a[c]) * to_a[c];
        heading_b += (a[c] - b[c]) * to_b[c];
        opposed += to_a[c] * to_b[c];
    }
    return at_a + at_b < length && heading_a < 0 && heading_b < 0 && opposed < 0;
}

Task<bool> any_straddles(Pace& pace, const ObstacleSet& set, const Buffer<double>& flat, bool closed) {
    const uint32_t d = set.dimension();
    const size_t nodes = flat.size() / d;
    Slice slice(Cost::microseconds);
    for (size_t i = 0; i + (closed ? 0 : 1) < nodes; ++i) {
        if (straddles(set, &flat[i * d], &flat[(i + 1) % nodes * d])) co_return true;
        if (slice.is_over(lift_work)) co_await pace;
    }
    co_return false;
}

// On barriers whose radius shrinks, from the problem's chain on; `flat` is where that has come to, without its height.
Task<void> minimize_among(Pace& pace, const SplineRequest& request, SplineProblem& problem, Buffer<double>& flat) {
    Spline& out = *request.out;
    const ManifoldProduct& held = *out.manifold;
    const ObstacleSet& set = request.placed->set();
    const uint32_t d = set.dimension();
    const Buffer<double> points = std::move(problem.given);
    const double size = scene_size(set, request.points), last = request.desc.obstacle_radius * size,
                 tolerance = problem.tolerance;
    double radius = std::min(std::max(first_radius * size, last), 0.9 * set.reach());
    Barrier barrier(held, set, radius, size);
    problem.manifold = &barrier.manifold();
    bool is_last = false;
    while (!is_last) {
        is_last = radius <= last;
        co_await lift_chain(pace, barrier, flat, points, problem);
        problem.tolerance = is_last ? tolerance : rough;
        SplineOptimizer optimizer(problem, pace.memory());
        co_await run_optimizer(pace, optimizer, out);
        co_await each(pace, optimizer.nodes(), Cost::some_ns, [&](uint32_t i) {
            std::copy_n(optimizer.points() + size_t{i} * (d + 1), d, &flat[size_t{i} * d]);
        });
        if (is_last) co_await keep_spline(pace, optimizer, out);
        radius = std::max(radius * shrink, last);
        barrier.set_radius(radius);
    }
    problem.tolerance = tolerance;
    problem.manifold = held.manifold.get();
}

}  // namespace

Task<void> make_obstacle_spline(Pace& pace, SplineRequest& request) {
    Spline& out = *request.out;
    SplineProblem& problem = request.problem;
    const ObstacleSet& set = request.placed.emplace(request.obstacles, out.origin, pace.memory()).set();
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
    FirstCurve first(pace.memory());
    co_await find_beginning(pace, request, given, first);
    const uint32_t segments = given.segments(d);
    const uint32_t nodes = request.desc.node_count > 0
                               ? request.desc.node_count
                               : std::min(32 * segments + (problem.closed ? 0 : 1), FLG_SPLINE_MAX_NODES);
    // Finer where pieces would go through what they are to keep out of.
    pace.stage("minimize");
    for (uint32_t finer = 1;; finer *= 2) {
        const bool may_refine = 2 * finer <= max_refinement && 2 * uint64_t{finer} * nodes <= FLG_SPLINE_MAX_NODES;
        co_await place_nodes(pace, *problem.manifold, first, given, finer * nodes, 2, problem);
        Buffer<double> flat = std::move(problem.points);
        bool through = false;
        if (may_refine && held.kind == ManifoldKind::space)
            through = co_await any_straddles(pace, set, flat, problem.closed);
        if (through) continue;
        co_await minimize_among(pace, request, problem, flat);
        through = co_await any_straddles(pace, set, flat, problem.closed);
        if (through && may_refine) continue;
        if (through) out.chain.report.ending = SplineEnding::stalled;
        break;
    }
    out.knots = std::move(problem.knots);
    out.is_complete = true;
}

}  // namespace flg
