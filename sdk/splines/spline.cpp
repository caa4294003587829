// SPDX-License-Identifier: MIT
#include "splines/spline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/failure.h"
#include "core/float_precision.h"
#include "splines/manifolds/coordinates.h"
#include "splines/spline_keys.h"
#include "splines/spline_pieces.h"
#include "splines/spline_rows.h"
#include "splines/surface_trace.h"
#include "splines/triangle_curve.h"

namespace flg {

namespace {

constexpr double uneven = 2.5;             // steps of a chain that is dragged, until nodes are placed anew
constexpr double coincident = 1e-7;        // of the manifold's size: points that are one
constexpr double beyond_borders = 0.25;    // of a border edge: where the smooth surface ends
constexpr double coarse_tolerance = 1e-3;  // of chains that are refined
constexpr double clearly_lower = 0.95;     // of an energy: where a dragged curve may jump

FlgSplineEnding ending_of(SplineEnding ending) {
    switch (ending) {
        case SplineEnding::converged: return FLG_SPLINE_ENDING_CONVERGED;
        case SplineEnding::rounding: return FLG_SPLINE_ENDING_ROUNDING;
        case SplineEnding::rounds: return FLG_SPLINE_ENDING_ROUNDS;
        case SplineEnding::stalled: return FLG_SPLINE_ENDING_STALLED;
        default: return FLG_SPLINE_ENDING_RUNNING;
    }
}

// The chain of the last round that was accepted, for the host.
Task<void> copy_chain(Pace& pace, const SplineOptimizer& optimizer, const Spline& spline, Spline::Chain& out) {
    const uint32_t n = optimizer.ambient(), shown = spline.manifold->given_ambient, nodes = optimizer.nodes();
    if (out.nodes.size() != size_t{nodes} * shown) {
        out.nodes = Buffer<double>(size_t{nodes} * shown, pace.memory());
        out.parameters = Buffer<double>(size_t{nodes} + 1, pace.memory());
    }
    double parameter = optimizer.first_parameter();
    co_await each(pace, nodes, Cost::some_ns, [&](uint32_t i) {
        std::copy_n(optimizer.points() + size_t{i} * n, shown, &out.nodes[size_t{i} * shown]);
        out.parameters[i] = parameter;
        parameter += optimizer.step_after(i);
    });
    out.parameters[nodes] = parameter;
    out.report = optimizer.report();
    out.on_triangles = false;
}

}  // namespace

Task<void> run_optimizer(Pace& pace, SplineOptimizer& optimizer, Spline& spline) {
    for (;;) {
        const bool goes_on = co_await SplineOptimizer::next_round(pace, optimizer);
        if (!goes_on) break;
        if (!pace.job().partial_results) continue;
        co_await copy_chain(pace, optimizer, spline, spline.rounds.write());
        spline.rounds.hand_over();
    }
    if (optimizer.report().ending == SplineEnding::failed) {
        throw OffSurface(Failure(FLG_ERROR_INVALID_ARGUMENT,
                                 "the first curve can't be projected onto the manifold at its node %u of %u",
                                 optimizer.report().failed_node, optimizer.nodes()));
    }
}

Task<void> place_spline_points(Pace& pace, const ManifoldProduct& held, const Buffer<double>& from,
                               const char* argument, Buffer<double>& out, Buffer<double>* offsets) {
    const Manifold& manifold = *held.manifold;
    const uint32_t n = manifold.ambient(), shown = held.given_ambient;
    const size_t count = from.size() / shown;
    out = Buffer<double>(count * n, pace.memory());
    if (offsets) *offsets = Buffer<double>(count, pace.memory());
    std::pmr::vector<double> hint(manifold.hint_size(), 0.0, pace.memory());
    co_await each_by_work(pace, count, Cost::microseconds, [&](uint32_t i) {
        double* const x = &out[size_t{i} * n];
        std::fill_n(x, n, 0.0);
        std::copy_n(&from[size_t{i} * shown], shown, x);
        std::fill(hint.begin(), hint.end(), 0.0);
        const bool is_on = manifold.project(x, hint.data());
        const double offset = distance_between(x, &from[size_t{i} * shown], shown);
        if (!is_on || !std::isfinite(offset)) {
            throw OffSurface(
                Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: point %u can't be projected onto the manifold", argument, i));
        }
        if (offsets) (*offsets)[i] = offset;
        return 4u;
    });
}

Task<void> refuse_coincident(Pace& pace, const Buffer<double>& given, uint32_t n, bool closed, double size) {
    const auto count = static_cast<uint32_t>(given.size() / n);
    co_await each(pace, closed ? count : count - 1, Cost::some_ns, [&](uint32_t i) {
        const uint32_t next = (i + 1) % count;
        if (distance_between(&given[size_t{i} * n], &given[size_t{next} * n], n) > coincident * size) return;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.points: points %u and %u come to one place on the manifold", i,
                      next);
    });
}

namespace {

// The part of a derivative that is tangent to the manifold at a point; returns its length.
double tangent_part(const ManifoldProduct& held, const double* slope, const double* point, double* out) {
    const Manifold& manifold = *held.manifold;
    const uint32_t n = manifold.ambient();
    double x[Manifold::max_ambient], basis[Manifold::max_ambient * Manifold::max_dimension],
        whole[Manifold::max_ambient] = {};
    double hint[Manifold::max_hint];
    std::fill_n(hint, manifold.hint_size(), 0.0);
    std::copy_n(point, n, x);
    manifold.project(x, hint);
    manifold.tangent_basis(x, hint, basis);
    std::copy_n(slope, held.given_ambient, whole);
    std::fill_n(out, n, 0.0);
    double square = 0;
    for (uint32_t a = 0; a < manifold.dimension(); ++a) {
        double along = 0;
        for (uint32_t c = 0; c < n; ++c) along += whole[c] * basis[a * n + c];
        for (uint32_t c = 0; c < n; ++c) out[c] += along * basis[a * n + c];
        square += along * along;
    }
    return std::sqrt(square);
}

void place_slope(const ManifoldProduct& held, const Buffer<double>& slope, const double* point, bool last,
                 SplineProblem& problem) {
    if (slope.empty()) return;
    problem.has_slope[last] = true;
    tangent_part(held, slope.data(), point, problem.slopes[last]);
}

// Handles have directions along the manifold.
Task<void> place_handles(Pace& pace, const ManifoldProduct& held, const Buffer<double>& given,
                         Buffer<SplineHandle>& handles) {
    constexpr double least_part = 1e-9;
    const uint32_t n = held.manifold->ambient();
    co_await each(pace, handles.size(), Cost::microseconds, [&](uint32_t h) {
        SplineHandle& handle = handles[h];
        if (!handle.has_slope) return;
        double tangent[Manifold::max_ambient], square = 0;
        for (uint32_t c = 0; c < held.given_ambient; ++c) square += handle.slope[c] * handle.slope[c];
        const double along = tangent_part(held, handle.slope, &given[size_t{handle.point} * n], tangent);
        if (!(along > least_part * std::sqrt(square)))
            throw Failure(
                FLG_ERROR_INVALID_ARGUMENT,
                "desc.handles[%u].slope stands upright on the manifold at point %u, so it has no direction there",
                handle.index, handle.point);
        std::copy_n(tangent, n, handle.slope);
    });
}

// The chain of another spline, each node moved as the given points around it were: parameters say how much of either.
Task<bool> move_chain(Pace& pace, const Spline& from, const Buffer<double>& given, SplineProblem& problem) {
    const uint32_t n = from.manifold->manifold->ambient();
    const bool fits = from.is_complete && from.given.size() == given.size() && from.closed == problem.closed;
    if (!fits) co_return false;
    const size_t nodes = from.points.size() / n, count = given.size() / n;
    problem.points = Buffer<double>(from.points.size(), pace.memory());
    problem.hints = Buffer<double>(from.hints.size(), pace.memory());
    co_await each(pace, from.hints.size(), Cost::some_ns, [&](uint32_t i) { problem.hints[i] = from.hints[i]; });
    problem.knots = Buffer<uint32_t>(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t k) { problem.knots[k] = from.knots[k]; });
    size_t k = 0;
    co_await each(pace, nodes, Cost::tens_of_ns, [&](uint32_t i) {
        while (k + 1 < count && i >= from.knots[k + 1]) ++k;
        const size_t end = k + 1 < count ? from.knots[k + 1] : nodes, next = (k + 1) % count;
        const double share = static_cast<double>(i - from.knots[k]) / static_cast<double>(end - from.knots[k]);
        for (size_t c = 0; c < n; ++c) {
            const double begin = given[k * n + c] - from.given[k * n + c],
                         other = given[next * n + c] - from.given[next * n + c];
            problem.points[i * n + c] = from.points[i * n + c] + (1 - share) * begin + share * other;
        }
    });
    co_return true;
}

// Whether no segment's nodes lie much farther apart than another's.
Task<bool> has_even_steps(Pace& pace, const SplineProblem& problem) {
    const uint32_t n = problem.manifold->ambient(), nodes = static_cast<uint32_t>(problem.points.size() / n);
    double least = HUGE_VAL, largest = 0;
    double length = 0;
    uint32_t k = 0;
    co_await each(pace, problem.closed ? nodes : nodes - 1, Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t end = k + 1 < problem.knots.size() ? problem.knots[k + 1] : nodes;
        length += distance_between(&problem.points[size_t{i} * n], &problem.points[size_t{(i + 1) % nodes} * n], n);
        if (i + 1 < end) return;
        least = std::min(least, length / (end - problem.knots[k]));
        largest = std::max(largest, length / (end - problem.knots[k]));
        length = 0;
        ++k;
    });
    co_return largest <= uneven* least;
}

// A chain as a first curve, to put nodes along it anew.
Task<void> follow_chain(Pace& pace, SplineProblem& problem, FirstCurve& out) {
    const uint32_t n = problem.manifold->ambient(), nodes = static_cast<uint32_t>(problem.points.size() / n);
    co_await each(pace, problem.points.size(), Cost::some_ns,
                  [&](uint32_t i) { out.points.push_back(problem.points[i]); });
    if (problem.closed) out.points.insert(out.points.end(), problem.points.begin(), problem.points.begin() + n);
    for (uint32_t k = 1; k < problem.knots.size(); ++k) out.ends.push_back(problem.knots[k] + 1);
    if (problem.closed) out.ends.push_back(nodes + 1);
    problem.hints = {};
}

// How many nodes the first of the chains has that end with one of `nodes`: each has four times those of the one before
// it.
uint32_t coarsest(uint32_t segments, uint32_t nodes) {
    while (nodes / 4 >= 6 * segments) nodes /= 4;
    return nodes;
}

uint32_t next_finer(uint32_t nodes, uint32_t finest) {
    return nodes > finest / 7 ? finest : 4 * nodes;
}

Task<void> begin_chain(Pace& pace, const SplineRequest& request, uint32_t nodes, SplineProblem& problem,
                       Buffer<double>& given) {
    const ManifoldProduct& held = *request.out->manifold;
    if (!request.curve.empty()) {
        co_await place_spline_points(pace, held, request.curve, "desc.curve", problem.points, nullptr);
        problem.given = std::move(given);
        co_return;
    }
    bool warm = false, is_even = true;
    if (request.warm_start) warm = co_await move_chain(pace, *request.warm_start, given, problem);
    if (warm) is_even = co_await has_even_steps(pace, problem);
    if (warm && is_even) {
        problem.given = std::move(given);
        co_return;
    }
    const GivenPoints points{
        .values = {given.data(), given.size()}, .closed = problem.closed, .argument = "desc.points"};
    FirstCurve first(pace.memory());
    if (warm) {
        co_await follow_chain(pace, problem, first);
        co_await place_nodes(pace, *held.manifold, first, points, nodes, 2, problem);
        co_return;
    }
    co_await find_first_curve(pace, held, points, first);
    // Pieces between handles keep their intervals.
    const bool is_whole = request.handles.empty();
    const uint32_t first_nodes = is_whole ? coarsest(points.segments(held.manifold->ambient()), nodes) : nodes;
    co_await place_nodes(pace, *held.manifold, first, points, first_nodes, 2, problem);
    if (request.desc.start == FLG_SPLINE_START_PROJECTED) co_await unrestricted_spline(pace, problem);
}

// One node between two.
Task<void> subdivide(Pace& pace, const SplineOptimizer& optimizer, SplineProblem& problem) {
    const uint32_t n = problem.manifold->ambient(), nodes = optimizer.nodes(),
                   intervals = problem.closed ? nodes : nodes - 1;
    Buffer<double> finer(size_t{nodes + intervals} * n, pace.memory());
    co_await each(pace, nodes, Cost::some_ns, [&](uint32_t i) {
        const double* const x = optimizer.points() + size_t{i} * n;
        const double* const y = optimizer.points() + size_t{(i + 1) % nodes} * n;
        std::copy_n(x, n, &finer[size_t{2 * i} * n]);
        for (uint32_t c = 0; i < intervals && c < n; ++c) finer[size_t{2 * i + 1} * n + c] = 0.5 * (x[c] + y[c]);
    });
    problem.points = std::move(finer);
    co_await each(pace, problem.knots.size(), Cost::some_ns, [&](uint32_t k) { problem.knots[k] *= 2; });
}

}  // namespace

Task<void> keep_spline(Pace& pace, SplineOptimizer& optimizer, Spline& out) {
    const uint32_t n = optimizer.ambient(), nodes = optimizer.nodes();
    co_await copy_chain(pace, optimizer, out, out.chain);
    out.points = Buffer<double>(size_t{nodes} * n, pace.memory());
    const bool has_normals = out.manifold->has_normals();
    if (has_normals) out.normals = Buffer<float>(size_t{3} * nodes, pace.memory());
    Buffer<double> hint(out.manifold->manifold->hint_size(), pace.memory());
    co_await each(pace, nodes, Cost::tens_of_ns, [&](uint32_t i) {
        std::copy_n(optimizer.points() + size_t{i} * n, n, &out.points[size_t{i} * n]);
        if (!has_normals) return;
        const double* basis = optimizer.basis(i);
        // Among obstacles the nodes are on a barrier over the surface, a surface of R^4 with its hint.
        std::array<double, 6> own;
        if (n > 3) {
            std::copy_n(optimizer.hint(i), hint.size(), hint.begin());
            out.manifold->manifold->tangent_basis(optimizer.points() + size_t{i} * n, hint.data(), own.data());
            basis = own.data();
        }
        store_vec3(Vec3(basis[0], basis[1], basis[2]).cross(Vec3(basis[3], basis[4], basis[5])),
                   &out.normals[size_t{3} * i]);
    });
    out.held = Buffer<uint32_t>(optimizer.report().held, pace.memory());
    size_t held = 0;
    co_await each(pace, nodes, Cost::some_ns, [&](uint32_t i) {
        if (optimizer.is_held(i)) out.held[held++] = i;
    });
    out.hints = optimizer.take_hints();
}

Task<void> minimize_chain(Pace& pace, const SplineRequest& request, SplineProblem& problem, uint32_t nodes,
                          Spline& out) {
    const uint32_t n = problem.manifold->ambient();
    const double tolerance = problem.tolerance;
    const uint32_t max_rounds = problem.max_rounds;
    uint32_t subdivisions = request.desc.subdivisions, rounds = 0;
    for (;;) {
        const bool is_coarse = request.curve.empty() && problem.points.size() < size_t{nodes} * n;
        problem.tolerance = is_coarse ? std::max(tolerance, coarse_tolerance) : tolerance;
        problem.max_rounds = max_rounds - rounds;
        SplineOptimizer optimizer(problem, pace.memory());
        co_await run_optimizer(pace, optimizer, out);
        rounds += optimizer.report().rounds;
        if (is_coarse) {
            problem.first_tension = 0;
            co_await refine_chain(pace, optimizer, next_finer(optimizer.nodes(), nodes), 2, problem);
        } else if (subdivisions > 0) {
            --subdivisions;
            co_await subdivide(pace, optimizer, problem);
        } else {
            co_await keep_spline(pace, optimizer, out);
            break;
        }
    }
    out.chain.report.rounds = rounds;
    out.knots = std::move(problem.knots);
}

namespace {

// Curves on an open mesh go as far as its smooth surface, or stay as far within as they have to.
void set_border(SplineRequest& request) {
    const ManifoldProduct& held = *request.out->manifold;
    if (!held.border || !held.has_normals()) return;
    request.problem.border = &*held.border;
    request.problem.within = request.stays_within ? request.within : -beyond_borders * held.border->mean_length();
}

// On the manifold, without obstacles.
Task<void> make_smooth_spline(Pace& pace, SplineRequest& request) {
    Spline& out = *request.out;
    const ManifoldProduct& held = *out.manifold;
    SplineProblem& problem = request.problem;
    problem.manifold = held.manifold.get();
    const uint32_t n = problem.manifold->ambient();
    set_border(request);
    pace.stage("place");
    Buffer<double> given;
    co_await place_spline_points(pace, held, request.points, "desc.points", given, &out.offsets);
    co_await refuse_coincident(pace, given, n, problem.closed, problem.manifold->size());
    if (!problem.closed) {
        place_slope(held, request.slopes[0], given.data(), false, problem);
        place_slope(held, request.slopes[1], &given[given.size() - n], true, problem);
    }
    out.given = Buffer<double>(given.size(), pace.memory());
    co_await each(pace, given.size(), Cost::some_ns, [&](uint32_t i) { out.given[i] = given[i]; });
    co_await place_handles(pace, held, given, request.handles);
    pace.stage("begin");
    const uint32_t segments = static_cast<uint32_t>(given.size() / n) - (problem.closed ? 0 : 1);
    const uint32_t least = 2 * segments + (problem.closed ? 0 : 1);
    const uint32_t wanted = request.desc.node_count > 0
                                ? request.desc.node_count
                                : std::min(32 * segments + (problem.closed ? 0 : 1), FLG_SPLINE_MAX_NODES);
    const uint32_t nodes = std::max(wanted, least);
    co_await begin_chain(pace, request, nodes, problem, given);
    pace.stage("minimize");
    problem.holds_nodes = held.has_normals();
    if (request.handles.empty()) co_return co_await minimize_chain(pace, request, problem, nodes, out);
    co_await minimize_pieces(pace, request, problem, nodes, out);
}

// Where nothing else is to be avoided than the borders of the mesh that the curve is on, the optimizer keeps it within.
void find_own_border(SplineRequest& request) {
    const ManifoldProduct& held = *request.out->manifold;
    const Obstacles& all = *request.obstacles;
    if (!held.border || all.meshes.size() != all.solids.size()) return;
    for (const Obstacles::OfMesh& mesh : all.meshes) {
        if (mesh.kind != FLG_OBSTACLE_KIND_BORDER || mesh.surface != held.surface) return;
    }
    request.stays_within = true;
    request.within = all.clearance + request.more_clearance;
    request.obstacles = nullptr;
}

// What a minimization uses up of a problem.
struct Effort {
    double tolerance, first_tension;
    uint32_t max_rounds;
};

// The same from a new initial curve, to be taken where it has clearly less energy than the one that went on from the
// warm start.
Task<void> seek_lower(Pace& pace, SplineRequest& request, Effort effort) {
    const std::shared_ptr<Spline> out = request.out;
    const auto other =
        std::allocate_shared<Spline>(std::pmr::polymorphic_allocator<Spline>(pace.memory()), out->manifold);
    other->origin = out->origin;
    other->closed = out->closed;
    request.out = other;
    request.warm_start = nullptr;
    request.problem.tolerance = effort.tolerance;
    request.problem.first_tension = effort.first_tension;
    request.problem.max_rounds = effort.max_rounds;
    request.problem.points = {};
    request.problem.hints = {};
    request.problem.knots = {};
    bool is_there = true;
    try {
        co_await make_smooth_spline(pace, request);
    } catch (const Failure&) {
        is_there = false;
    }
    request.out = out;
    if (!is_there || !(other->chain.report.energy < clearly_lower * out->chain.report.energy)) co_return;
    out->chain = std::move(other->chain);
    out->points = std::move(other->points);
    out->hints = std::move(other->hints);
    out->given = std::move(other->given);
    out->knots = std::move(other->knots);
    out->held = std::move(other->held);
    out->breaks = std::move(other->breaks);
    out->offsets = std::move(other->offsets);
    out->normals = std::move(other->normals);
    out->jumped = true;
}

// What else is asked for of a curve that is there.
Task<void> complete(Pace& pace, const SplineRequest& request) {
    Spline& out = *request.out;
    if (request.desc.surface_points != 0) co_await find_surface_points(pace, out);
    if (request.desc.key_tolerance > 0)
        co_await fit_keys(pace, request.desc.key_tolerance, request.problem.bending == 0, out);
    out.is_complete = true;
}

}  // namespace

// A curve over the triangles is shown first unless there is one to go on from, and is the result where no other can be
// had.
Task<void> make_spline(Pace& pace, SplineRequest request) {
    Spline& out = *request.out;
    out.closed = request.problem.closed;
    const bool has_triangles = out.manifold->has_triangles(), only = request.desc.on_triangles != 0;
    if (only && !has_triangles)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.on_triangles: desc.manifold is not that of a mesh");
    if (request.desc.surface_points != 0 && !has_triangles)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.surface_points: desc.manifold is not that of a mesh");
    if (request.obstacles) find_own_border(request);
    if (request.obstacles) {
        co_await make_obstacle_spline(pace, request);
        co_return co_await complete(pace, request);
    }
    const std::shared_ptr<const Spline> before = request.warm_start;
    if (before && (!before->is_complete || before->chain.on_triangles)) request.warm_start = nullptr;
    bool is_laid = only || (has_triangles && pace.job().partial_results && !request.warm_start);
    if (is_laid) {
        pace.stage("triangles");
        co_await lay_triangle_curve(pace, request, before.get());
    }
    bool is_off = only;
    const bool seeks = request.desc.seek_lower != 0 && request.warm_start;
    const Effort effort{request.problem.tolerance, request.problem.first_tension, request.problem.max_rounds};
    if (!only) {
        try {
            co_await make_smooth_spline(pace, request);
        } catch (const OffSurface&) {
            if (!has_triangles) throw;
            is_off = true;
        }
    }
    if (seeks && !is_off) co_await seek_lower(pace, request, effort);
    if (is_off) {
        if (!is_laid) co_await lay_triangle_curve(pace, request, before.get());
        co_await keep_triangle_curve(pace, request);
    }
    co_await complete(pace, request);
}

void Spline::publish_partial() noexcept {
    if (!rounds.take()) return;
    show_chain(rounds.read());
    show_early();
}

void Spline::show() noexcept {
    show_chain(chain);
    view_.ending = chain.on_triangles   ? FLG_SPLINE_ENDING_TRIANGLES
                   : out_of_evaluations ? FLG_SPLINE_ENDING_EVALUATIONS
                                        : ending_of(chain.report.ending);
    view_.jumped = jumped;
    view_.normals = normals.data();
    view_.point_count = static_cast<uint32_t>(knots.size());
    view_.point_nodes = knots.data();
    view_.held_nodes = held.data();
    view_.held_count = static_cast<uint32_t>(held.size());
    view_.offsets = offsets.data();
    view_.surface_points = surface_points.data();
    view_.largest_moved = largest_moved;
    view_.key_count = static_cast<uint32_t>(keys.parameters.size());
    view_.key_parameters = keys.parameters.data();
    view_.key_points = keys.points.data();
    view_.key_arriving = keys.arriving.data();
    view_.key_leaving = keys.leaving.data();
    view_.largest_key_error = keys.largest_error;
    for (const double offset : offsets) view_.largest_offset = std::max(view_.largest_offset, offset);
}

void Spline::show_chain(const Chain& shown) noexcept {
    const SplineReport& report = shown.report;
    view_ = {};
    view_.struct_size = sizeof view_;
    view_.ambient = manifold->given_ambient;
    write_origin(origin, view_.origin);
    view_.node_count = static_cast<uint32_t>(shown.nodes.size() / view_.ambient);
    view_.closed = closed;
    view_.ending = FLG_SPLINE_ENDING_RUNNING;
    view_.nodes = shown.nodes.data();
    view_.parameters = shown.parameters.data();
    view_.rounds = report.rounds;
    view_.projections = report.projections;
    view_.energy = report.energy;
    view_.bending = report.bending;
    view_.stretching = report.stretching;
    view_.length = report.length;
    view_.on_triangles = shown.on_triangles;
    view_.residual = report.residual;
}

// A chain that spans few steps of floats would come out as stairs.
Task<void> check_precision(Pace& pace, const Buffer<double>& nodes) {
    constexpr double min_steps = 256;
    std::array<double, 3> low = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    co_await each(pace, nodes.size(), Cost::some_ns, [&](uint32_t i) {
        low[i % 3] = std::min(low[i % 3], nodes[i]);
        high[i % 3] = std::max(high[i % 3], nodes[i]);
    });
    double size = 0, farthest = 0;
    for (size_t c = 0; c < 3; ++c) {
        size = std::max(size, high[c] - low[c]);
        farthest = std::max({farthest, std::abs(low[c]), std::abs(high[c])});
    }
    const double step = double{float_step(static_cast<float>(farthest))};
    if (size >= min_steps * step) co_return;
    throw Failure(
        FLG_ERROR_INVALID_ARGUMENT,
        "desc.spline is %g m wide and has coordinates up to %g m, where floats are %g m apart; give its points "
        "relative to an origin near them (FlgSplineDesc::origin)",
        size, farthest, step);
}

Task<void> spline_curves(Pace& pace, std::shared_ptr<const Spline> spline, float height, double spacing,
                         std::shared_ptr<CurveSet> out) {
    pace.stage("copy");
    const Spline::Chain& chain = spline->chain;
    co_await check_precision(pace, chain.nodes);
    std::optional<SplineRows> rows;
    if (spacing > 0) rows.emplace(co_await rows_along(pace, *spline, spacing));
    const uint32_t nodes = static_cast<uint32_t>(chain.nodes.size() / 3),
                   points = rows ? static_cast<uint32_t>(rows->rows.size()) - (spline->closed ? 1 : 0) : nodes;
    out->allocate_curves(1);
    out->offsets()[0] = 0;
    out->offsets()[1] = points;
    out->begin_curve(0, spline->closed ? FLG_CURVE_CLOSED : 0);
    std::pmr::vector<CurveSet::ColumnLayout> layout({{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TIME, 1}},
                                                    pace.memory());
    const bool has_normals = spline->normals.size() > 0;
    if (has_normals) layout.push_back({FLG_ATTRIBUTE_NORMAL, 3});
    out->allocate_columns(layout);
    float* const positions = out->find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* const times = out->find(FLG_ATTRIBUTE_TIME)->values.data();
    float* const frames = has_normals ? out->find(FLG_ATTRIBUTE_NORMAL)->values.data() : nullptr;
    co_await each(pace, points, Cost::some_ns, [&](uint32_t i) {
        Vec3 place = rows ? rows->rows[i].place : Vec3(&chain.nodes[size_t{3} * i]);
        if (has_normals) {
            const Vec3 normal = rows ? rows->rows[i].normal : load_vec3(&spline->normals[size_t{3} * i]);
            place += height * normal;
            store_vec3(normal, frames + size_t{3} * i);
        }
        store_vec3(place, positions + size_t{3} * i);
        times[i] = static_cast<float>(rows ? rows->rows[i].time : chain.parameters[i]);
    });
    out->complete_curve(0);
}

}  // namespace flg
