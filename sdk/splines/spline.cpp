// SPDX-License-Identifier: MIT
#include "splines/spline.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/failure.h"
#include "splines/coordinates.h"
#include "splines/obstacle_spline.h"

namespace flg {

namespace {

constexpr uint32_t kernel_chunk = 200;  // 10 us
constexpr uint32_t copy_chunk = 1000;
constexpr uint32_t place_chunk = 2;
constexpr double uneven = 2.5;             // steps of a chain that is dragged, until nodes are placed anew
constexpr double coincident = 1e-7;        // of the manifold's size: points that are one
constexpr double coarse_tolerance = 1e-3;  // of chains that are refined

FlgSplineEnding ending_of(SplineEnding ending) {
    switch (ending) {
        case SplineEnding::converged: return FLG_SPLINE_CONVERGED;
        case SplineEnding::rounding: return FLG_SPLINE_ROUNDING;
        case SplineEnding::rounds: return FLG_SPLINE_ROUNDS;
        case SplineEnding::stalled: return FLG_SPLINE_STALLED;
        default: return FLG_SPLINE_RUNNING;
    }
}

// The chain of the last round that was accepted, for the host.
Task<void> copy_chain(Pace& pace, const SplineKernel& kernel, const HeldSpline& spline, HeldSpline::Chain& out) {
    const uint32_t n = kernel.ambient(), shown = spline.manifold->given_ambient, nodes = kernel.nodes();
    if (out.nodes.size() != size_t{nodes} * shown) {
        out.nodes = Buffer<double>(size_t{nodes} * shown, pace.memory());
        out.parameters = Buffer<double>(size_t{nodes} + 1, pace.memory());
    }
    double parameter = kernel.first_parameter();
    for (uint32_t i = 0; i < nodes; ++i) {
        std::copy_n(kernel.points() + size_t{i} * n, shown, &out.nodes[size_t{i} * shown]);
        out.parameters[i] = parameter;
        parameter += kernel.step_after(i);
        if (i % copy_chunk == 0) co_await pace;
    }
    out.parameters[nodes] = parameter;
    out.report = kernel.report();
}

}  // namespace

Task<void> run_spline_kernel(Pace& pace, SplineKernel& kernel, HeldSpline& spline) {
    uint32_t rounds = 0;
    while (!kernel.run(kernel_chunk)) {
        co_await pace;
        if (!pace.job().partial_results || kernel.report().rounds == rounds) continue;
        rounds = kernel.report().rounds;
        co_await copy_chain(pace, kernel, spline, spline.rounds.write());
        spline.rounds.hand_over();
    }
    if (kernel.report().ending == SplineEnding::failed) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "the first curve can't be projected onto the manifold at its node %u of %u",
                      kernel.report().failed_node, kernel.nodes());
    }
}

Task<void> place_spline_points(Pace& pace, const HeldManifold& held, const Buffer<double>& from, const char* argument,
                               Buffer<double>& out, Buffer<double>* offsets) {
    const Manifold& manifold = *held.manifold;
    const uint32_t n = manifold.ambient(), shown = held.given_ambient;
    const size_t count = from.size() / shown;
    out = Buffer<double>(count * n, pace.memory());
    if (offsets) *offsets = Buffer<double>(count, pace.memory());
    std::pmr::vector<double> memory(manifold.memory_size(), 0.0, pace.memory());
    for (size_t i = 0; i < count; ++i) {
        double* const x = &out[i * n];
        std::fill_n(x, n, 0.0);
        std::copy_n(&from[i * shown], shown, x);
        std::fill(memory.begin(), memory.end(), 0.0);
        if (!manifold.project(x, memory.data()) || !std::isfinite(distance_between(x, &from[i * shown], shown))) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: point %zu can't be projected onto the manifold", argument,
                          i);
        }
        if (offsets) (*offsets)[i] = distance_between(x, &from[i * shown], shown);
        if (i % place_chunk == 0) co_await pace;
    }
}

Task<void> refuse_coincident(Pace& pace, const Buffer<double>& given, uint32_t n, bool closed, double size) {
    const size_t count = given.size() / n;
    for (size_t i = 0; i + (closed ? 0 : 1) < count; ++i) {
        const size_t next = (i + 1) % count;
        if (i % copy_chunk == 0) co_await pace;
        if (distance_between(&given[i * n], &given[next * n], n) > coincident * size) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.points: points %zu and %zu come to one place on the manifold",
                      i, next);
    }
}

namespace {

// The part of a prescribed derivative that is tangent to the manifold at an end.
void place_slope(const HeldManifold& held, const Buffer<double>& slope, const double* point, bool last,
                 SplineProblem& problem) {
    if (slope.empty()) return;
    const Manifold& manifold = *held.manifold;
    const uint32_t n = manifold.ambient();
    double x[Manifold::max_ambient], basis[Manifold::max_ambient * Manifold::max_dimension],
        whole[Manifold::max_ambient] = {};
    double memory[Manifold::max_memory];
    std::fill_n(memory, manifold.memory_size(), 0.0);
    std::copy_n(point, n, x);
    manifold.project(x, memory);
    manifold.tangent_basis(x, memory, basis);
    std::copy_n(slope.data(), slope.size(), whole);
    problem.has_slope[last] = true;
    std::fill_n(problem.slopes[last], n, 0.0);
    for (uint32_t a = 0; a < manifold.dimension(); ++a) {
        double along = 0;
        for (uint32_t c = 0; c < n; ++c) along += whole[c] * basis[a * n + c];
        for (uint32_t c = 0; c < n; ++c) problem.slopes[last][c] += along * basis[a * n + c];
    }
}

// The chain of another spline, each node moved as the given points around it were: parameters say how much of either.
Task<bool> move_chain(Pace& pace, const HeldSpline& from, const Buffer<double>& given, SplineProblem& problem) {
    const uint32_t n = from.manifold->manifold->ambient();
    const bool fits = from.is_complete && from.given.size() == given.size() && from.closed == problem.closed;
    if (!fits) co_return false;
    const size_t nodes = from.points.size() / n, count = given.size() / n;
    problem.points = Buffer<double>(from.points.size(), pace.memory());
    problem.memory = Buffer<double>(from.memory.size(), pace.memory());
    for (size_t at = 0; at < from.memory.size(); at += copy_chunk) {
        std::copy_n(from.memory.begin() + at, std::min<size_t>(copy_chunk, from.memory.size() - at),
                    problem.memory.begin() + at);
        co_await pace;
    }
    problem.knots = Buffer<uint32_t>(count, pace.memory());
    for (size_t k = 0; k < count; ++k) {
        problem.knots[k] = from.knots[k];
        const size_t end = k + 1 < count ? from.knots[k + 1] : nodes, next = (k + 1) % count;
        for (size_t i = from.knots[k]; i < end; ++i) {
            const double share = static_cast<double>(i - from.knots[k]) / static_cast<double>(end - from.knots[k]);
            for (size_t c = 0; c < n; ++c) {
                const double begin = given[k * n + c] - from.given[k * n + c],
                             other = given[next * n + c] - from.given[next * n + c];
                problem.points[i * n + c] = from.points[i * n + c] + (1 - share) * begin + share * other;
            }
            if (i % copy_chunk == 0) co_await pace;
        }
    }
    co_return true;
}

// Whether no segment's nodes lie much farther apart than another's.
Task<bool> has_even_steps(Pace& pace, const SplineProblem& problem) {
    const uint32_t n = problem.manifold->ambient(), nodes = static_cast<uint32_t>(problem.points.size() / n);
    double least = HUGE_VAL, largest = 0;
    for (uint32_t k = 0; k + (problem.closed ? 0 : 1) < problem.knots.size(); ++k) {
        const uint32_t end = k + 1 < problem.knots.size() ? problem.knots[k + 1] : nodes;
        double length = 0;
        for (uint32_t i = problem.knots[k]; i < end; ++i) {
            length += distance_between(&problem.points[size_t{i} * n], &problem.points[size_t{(i + 1) % nodes} * n], n);
            if (i % copy_chunk == 0) co_await pace;
        }
        least = std::min(least, length / (end - problem.knots[k]));
        largest = std::max(largest, length / (end - problem.knots[k]));
    }
    co_return largest <= uneven* least;
}

// A chain as a first curve, to put nodes along it anew.
Task<void> follow_chain(Pace& pace, SplineProblem& problem, FirstCurve& out) {
    const uint32_t n = problem.manifold->ambient(), nodes = static_cast<uint32_t>(problem.points.size() / n);
    for (size_t at = 0; at < problem.points.size(); at += copy_chunk) {
        const size_t end = std::min(at + copy_chunk, problem.points.size());
        out.points.insert(out.points.end(), problem.points.begin() + at, problem.points.begin() + end);
        co_await pace;
    }
    if (problem.closed) out.points.insert(out.points.end(), problem.points.begin(), problem.points.begin() + n);
    for (uint32_t k = 1; k < problem.knots.size(); ++k) out.ends.push_back(problem.knots[k] + 1);
    if (problem.closed) out.ends.push_back(nodes + 1);
    problem.memory = {};
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
    const HeldManifold& held = *request.out->manifold;
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
    const uint32_t first_nodes = coarsest(points.segments(held.manifold->ambient()), nodes);
    co_await place_nodes(pace, *held.manifold, first, points, first_nodes, 2, problem);
    if (request.start == FLG_SPLINE_START_PROJECTED) co_await unrestricted_spline(pace, problem);
}

// One node between two.
Task<void> subdivide(Pace& pace, const SplineKernel& kernel, SplineProblem& problem) {
    const uint32_t n = problem.manifold->ambient(), nodes = kernel.nodes(),
                   intervals = problem.closed ? nodes : nodes - 1;
    Buffer<double> finer(size_t{nodes + intervals} * n, pace.memory());
    for (uint32_t i = 0; i < nodes; ++i) {
        const double* const x = kernel.points() + size_t{i} * n;
        const double* const y = kernel.points() + size_t{(i + 1) % nodes} * n;
        std::copy_n(x, n, &finer[size_t{2 * i} * n]);
        for (uint32_t c = 0; i < intervals && c < n; ++c) finer[size_t{2 * i + 1} * n + c] = 0.5 * (x[c] + y[c]);
        if (i % copy_chunk == 0) co_await pace;
    }
    problem.points = std::move(finer);
    for (size_t k = 0; k < problem.knots.size(); ++k) {
        problem.knots[k] *= 2;
        if (k % copy_chunk == 0) co_await pace;
    }
}

}  // namespace

Task<void> keep_spline(Pace& pace, SplineKernel& kernel, HeldSpline& out) {
    const uint32_t n = kernel.ambient(), nodes = kernel.nodes();
    co_await copy_chain(pace, kernel, out, out.chain);
    out.points = Buffer<double>(size_t{nodes} * n, pace.memory());
    const bool has_normals = out.manifold->has_normals();
    if (has_normals) out.normals = Buffer<float>(size_t{3} * nodes, pace.memory());
    Buffer<double> memory(out.manifold->manifold->memory_size(), pace.memory());
    for (uint32_t i = 0; i < nodes; ++i) {
        std::copy_n(kernel.points() + size_t{i} * n, n, &out.points[size_t{i} * n]);
        if (has_normals) {
            const double* basis = kernel.basis(i);
            // Among obstacles the nodes are on a barrier over the surface, a surface of R^4 with its memory.
            std::array<double, 6> own;
            if (n > 3) {
                std::copy_n(kernel.memory(i), memory.size(), memory.begin());
                out.manifold->manifold->tangent_basis(kernel.points() + size_t{i} * n, memory.data(), own.data());
                basis = own.data();
            }
            store_vec3(Vec3(basis[0], basis[1], basis[2]).cross(Vec3(basis[3], basis[4], basis[5])),
                       &out.normals[size_t{3} * i]);
        }
        if (i % copy_chunk == 0) co_await pace;
    }
    out.memory = kernel.take_memory();
}

Task<void> make_spline(Pace& pace, SplineRequest request) {
    HeldSpline& out = *request.out;
    const HeldManifold& held = *out.manifold;
    SplineProblem& problem = request.problem;
    problem.manifold = held.manifold.get();
    const uint32_t n = problem.manifold->ambient();
    out.closed = problem.closed;
    if (request.obstacles) co_return co_await make_obstacle_spline(pace, request);
    pace.stage("place");
    Buffer<double> given;
    co_await place_spline_points(pace, held, request.points, "desc.points", given, &out.offsets);
    co_await refuse_coincident(pace, given, n, problem.closed, problem.manifold->size());
    if (!problem.closed) {
        place_slope(held, request.slopes[0], given.data(), false, problem);
        place_slope(held, request.slopes[1], &given[given.size() - n], true, problem);
    }
    out.given = Buffer<double>(given.size(), pace.memory());
    for (size_t i = 0; i < given.size(); ++i) {
        out.given[i] = given[i];
        if (i % copy_chunk == 0) co_await pace;
    }
    pace.stage("begin");
    const uint32_t segments = static_cast<uint32_t>(given.size() / n) - (problem.closed ? 0 : 1);
    const uint32_t least = 2 * segments + (problem.closed ? 0 : 1);
    const uint32_t wanted = request.node_count > 0
                                ? request.node_count
                                : std::min(32 * segments + (problem.closed ? 0 : 1), FLG_SPLINE_MAX_NODES);
    const uint32_t nodes = std::max(wanted, least);
    co_await begin_chain(pace, request, nodes, problem, given);
    pace.stage("minimize");
    const double tolerance = problem.tolerance;
    const uint32_t max_rounds = problem.max_rounds;
    uint32_t subdivisions = request.subdivisions, rounds = 0;
    for (;;) {
        const bool is_coarse = request.curve.empty() && problem.points.size() < size_t{nodes} * n;
        problem.tolerance = is_coarse ? std::max(tolerance, coarse_tolerance) : tolerance;
        problem.max_rounds = max_rounds - rounds;
        SplineKernel kernel(problem, pace.memory());
        co_await run_spline_kernel(pace, kernel, out);
        rounds += kernel.report().rounds;
        if (is_coarse) {
            problem.first_tension = 0;
            co_await refine_chain(pace, kernel, next_finer(kernel.nodes(), nodes), 2, problem);
        } else if (subdivisions > 0) {
            --subdivisions;
            co_await subdivide(pace, kernel, problem);
        } else {
            co_await keep_spline(pace, kernel, out);
            break;
        }
    }
    out.chain.report.rounds = rounds;
    out.knots = std::move(problem.knots);
    out.is_complete = true;
}

void HeldSpline::publish_partial() noexcept {
    if (!rounds.take()) return;
    show_chain(rounds.read());
    show_early();
}

void HeldSpline::show() noexcept {
    show_chain(chain);
    view_.ending = ending_of(chain.report.ending);
    view_.normals = normals.data();
    view_.point_count = static_cast<uint32_t>(knots.size());
    view_.point_nodes = knots.data();
    view_.offsets = offsets.data();
    for (const double offset : offsets) view_.largest_offset = std::max(view_.largest_offset, offset);
}

void HeldSpline::show_chain(const Chain& shown) noexcept {
    const SplineReport& report = shown.report;
    view_ = {};
    view_.struct_size = sizeof view_;
    view_.ambient = manifold->given_ambient;
    view_.node_count = static_cast<uint32_t>(shown.nodes.size() / view_.ambient);
    view_.closed = closed;
    view_.ending = FLG_SPLINE_RUNNING;
    view_.nodes = shown.nodes.data();
    view_.parameters = shown.parameters.data();
    view_.rounds = report.rounds;
    view_.projections = report.projections;
    view_.energy = report.energy;
    view_.bending = report.bending;
    view_.stretching = report.stretching;
    view_.length = report.length;
    view_.residual = report.residual;
}

Task<void> spline_curves(Pace& pace, std::shared_ptr<const HeldSpline> spline, float height,
                         std::shared_ptr<CurveSet> out) {
    pace.stage("copy");
    const HeldSpline::Chain& chain = spline->chain;
    const uint32_t nodes = static_cast<uint32_t>(chain.nodes.size() / 3);
    out->allocate_curves(1);
    out->offsets()[0] = 0;
    out->offsets()[1] = nodes;
    out->begin_curve(0, spline->closed ? FLG_CURVE_CLOSED : 0);
    std::pmr::vector<CurveSet::ColumnLayout> layout({{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_TIME, 1}},
                                                    pace.memory());
    const bool has_normals = spline->normals.size() > 0;
    if (has_normals) layout.push_back({FLG_ATTRIBUTE_NORMAL, 3});
    out->allocate_columns(layout);
    float* const positions = out->find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* const times = out->find(FLG_ATTRIBUTE_TIME)->values.data();
    float* const frames = has_normals ? out->find(FLG_ATTRIBUTE_NORMAL)->values.data() : nullptr;
    for (uint32_t i = 0; i < nodes; ++i) {
        const double* const x = &chain.nodes[size_t{3} * i];
        Vec3 place(x[0], x[1], x[2]);
        if (has_normals) {
            const Vec3 normal = load_vec3(&spline->normals[size_t{3} * i]);
            place += height * normal;
            store_vec3(normal, frames + size_t{3} * i);
        }
        store_vec3(place, positions + size_t{3} * i);
        times[i] = static_cast<float>(chain.parameters[i]);
        if (i % copy_chunk == 0) co_await pace;
    }
    out->complete_curve(0);
}

}  // namespace flg
