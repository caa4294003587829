// SPDX-License-Identifier: MIT
#include "splines/optimizer/first_curve.h"

#include <cmath>

#include "core/failure.h"
#include "splines/manifolds/coordinates.h"
#include "splines/manifolds/space_manifold.h"
#include "splines/optimizer/natural_cubic.h"
#include "surfaces/mesh/nearest_points.h"
#include "surfaces/tracing_jobs.h"

namespace flg {

namespace {

constexpr uint32_t halvings = 4;
constexpr uint32_t find_chunk = 100;
constexpr uint32_t pieces = 1u << halvings;
constexpr double max_piece = 4;      // over the mean one
constexpr uint32_t walk_steps = 16;  // on the straight way
constexpr uint32_t max_steps = 96;
constexpr double max_way = 2;       // of a chord, over the projected middle
constexpr double max_beyond = 0.5;  // of a border edge: farther a first curve does not go beyond a border
constexpr uint32_t max_looks = 16;  // at the border, a piece

using Point = std::array<double, Manifold::max_ambient>;

// The middle of two points on the manifold, projected. False where the way over it is too long or there is none.
bool project_middle(const Manifold& manifold, const double* a, const double* b, double* out) {
    const uint32_t n = manifold.ambient();
    double hint[Manifold::max_hint];
    const double chord = distance_between(a, b, n);
    Point basis_point{};
    for (const double aside : {0.0, 0.05, -0.05}) {
        for (uint32_t c = 0; c < n; ++c) out[c] = 0.5 * (a[c] + b[c]);
        if (aside != 0) {
            std::fill_n(hint, manifold.hint_size(), 0.0);
            std::copy_n(a, n, basis_point.begin());
            std::array<double, Manifold::max_ambient * Manifold::max_dimension> basis{};
            if (!manifold.project(basis_point.data(), hint)) return false;
            manifold.tangent_basis(basis_point.data(), hint, basis.data());
            for (uint32_t c = 0; c < n; ++c) out[c] += aside * chord * basis[c];
        }
        std::fill_n(hint, manifold.hint_size(), 0.0);
        if (!manifold.project(out, hint)) continue;
        if (distance_between(a, out, n) + distance_between(out, b, n) <= max_way * chord) return true;
    }
    return false;
}

// The outward normal of a surface in R^3 at a point on it.
Vec3 normal_at(const Manifold& manifold, const double* x) {
    double hint[Manifold::max_hint], basis[6];
    std::fill_n(hint, manifold.hint_size(), 0.0);
    Point at{};
    std::copy_n(x, 3, at.begin());
    if (!manifold.project(at.data(), hint)) return Vec3::Zero();
    manifold.tangent_basis(at.data(), hint, basis);
    return Vec3(basis[0], basis[1], basis[2]).cross(Vec3(basis[3], basis[4], basis[5]));
}

// Where no way leads along the surface all middles end at its rims, and one piece is left between them.
bool is_even(const double* points, uint32_t n) {
    double largest = 0, whole = 0;
    for (uint32_t p = 0; p < pieces; ++p) {
        const double piece = distance_between(points + size_t{p} * n, points + size_t{p + 1} * n, n);
        largest = std::max(largest, piece);
        whole += piece;
    }
    return largest <= max_piece * whole / pieces;
}

// Whether a piece of a chord stays on this side of a mesh's borders.
bool stays_on_mesh(const MeshBorder& border, const double* a, const double* b) {
    const Vec3 from(a), to(b);
    const double length = (to - from).norm(), step = max_beyond * border.mean_length();
    const auto looks = static_cast<uint32_t>(std::clamp(std::ceil(length / step), 1.0, double{max_looks}));
    for (uint32_t i = 0; i < looks; ++i) {
        BorderView view;
        const Vec3 at = from + (i + 0.5) / looks * (to - from);
        if (border.look(at, nullptr, view) && view.inside < -max_beyond * border.mean_length()) return false;
    }
    return true;
}

// Halves a segment's chord until it has so many pieces, of which the first and the last point are there: middle number
// `m` of pieces - 1, those of longer chords before those of shorter ones. A projection, some us.
bool halve_chord(const Manifold& manifold, double* points, uint32_t m) {
    const uint32_t n = manifold.ambient(), level = static_cast<uint32_t>(std::bit_width(m + 1)) - 1;
    const uint32_t step = pieces >> level;
    double* const begin = points + size_t{m + 1 - (1u << level)} * step * n;
    return project_middle(manifold, begin, begin + size_t{step} * n, begin + size_t{step / 2} * n);
}

// From a point towards another, step by step in the tangent spaces, for the segment's points but the first; for where
// chords do not lead along the surface. False where that leads nowhere.
Task<bool> walk(Pace& pace, const Manifold& manifold, const double* to, std::pmr::vector<double>& points) {
    const uint32_t n = manifold.ambient();
    Point at{}, way{};
    std::copy(points.end() - n, points.end(), at.begin());
    std::pmr::vector<double> hint(manifold.hint_size(), 0.0, pace.memory());
    std::array<double, Manifold::max_ambient * Manifold::max_dimension> basis{};
    if (!manifold.project(at.data(), hint.data())) co_return false;
    const double step = distance_between(at.data(), to, n) / walk_steps;
    for (uint32_t count = 0; count < max_steps; ++count) {
        const double left = distance_between(at.data(), to, n);
        if (left <= 1.2 * step) {
            points.insert(points.end(), to, to + n);
            co_return true;
        }
        manifold.tangent_basis(at.data(), hint.data(), basis.data());
        double square = 0;
        std::fill(way.begin(), way.end(), 0.0);
        for (uint32_t a = 0; a < manifold.dimension(); ++a) {
            double along = 0;
            for (uint32_t c = 0; c < n; ++c) along += basis[a * n + c] * (to[c] - at[c]);
            for (uint32_t c = 0; c < n; ++c) way[c] += along * basis[a * n + c];
            square += along * along;
        }
        if (!(square > 1e-6 * left * left)) std::copy_n(basis.begin(), n, way.begin()), square = 1;
        for (uint32_t c = 0; c < n; ++c) at[c] += step / std::sqrt(square) * way[c];
        if (!manifold.project(at.data(), hint.data())) co_return false;
        points.insert(points.end(), at.begin(), at.begin() + n);
        co_await pace;
    }
    co_return false;
}

// Refuses given points that follow each other on parts of a mesh that do not hang together.
Task<void> refuse_parts(Pace& pace, const ManifoldProduct& held, GivenPoints given, NearestPoints& nearest) {
    const uint32_t count = given.count(3);
    std::pmr::vector<uint32_t> parts(pace.memory());
    for (uint32_t i = 0; i < count; ++i) {
        const double* const x = &given.values[size_t{3} * i];
        nearest.begin(Vec3(x[0], x[1], x[2]));
        while (!nearest.find(find_chunk)) co_await pace;
        // Vertices that a cut has added since are in no list; a triangle that has only such ones is not asked.
        uint32_t part = no_index;
        for (const uint32_t vertex : held.surface->mesh().triangles[nearest.found().triangle]) {
            if (vertex < held.components.size()) part = held.components[vertex];
        }
        parts.push_back(part);
    }
    for (uint32_t s = 0; s < given.segments(3); ++s) {
        const uint32_t a = parts[s], b = parts[(s + 1) % count];
        if (a == b || a == no_index || b == no_index) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: no way leads over the surface from point %u to point %u",
                      given.argument, s, (s + 1) % count);
    }
}

// A shortest path over the mesh, for the segment's points but the first.
Task<void> follow_mesh(Pace& pace, const ManifoldProduct& held, GivenPoints given, uint32_t segment,
                       NearestPoints& nearest, FirstCurve& out) {
    Surface& surface = *held.surface;
    const uint32_t count = given.count(3), ends[2] = {segment, (segment + 1) % count};
    Paths paths{.offsets = Buffer<uint32_t>(2, pace.memory()),
                .points = Buffer<SurfacePoint>(2, pace.memory()),
                .closed = false,
                .regions = RegionSet(pace.memory())};
    paths.offsets[0] = 0;
    paths.offsets[1] = 2;
    for (uint32_t e = 0; e < 2; ++e) {
        const double* const x = &given.values[size_t{3} * ends[e]];
        nearest.begin(Vec3(x[0], x[1], x[2]));
        while (!nearest.find(find_chunk)) co_await pace;
        paths.points[e] = nearest.found();
    }
    SurfaceCurves curves(pace.memory());
    try {
        co_await trace_polylines(pace, surface, paths, given.argument, curves);
    } catch (const Failure& failure) {
        if (failure.result() != FLG_ERROR_INVALID_ARGUMENT) throw;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s: no way leads over the surface from point %u to point %u",
                      given.argument, ends[0], ends[1]);
    }
    for (size_t p = 1; p + 1 < curves.points.size(); ++p) {
        const Vec3 x = position_of(surface.mesh(), curves.points[p]);
        out.points.insert(out.points.end(), {x.x(), x.y(), x.z()});
        if (p % 64 == 0) co_await pace;
    }
    const double* const last = &given.values[size_t{3} * ends[1]];
    out.points.insert(out.points.end(), last, last + 3);
}

}  // namespace

Task<void> find_first_curve(Pace& pace, const ManifoldProduct& held, GivenPoints given, FirstCurve& out) {
    const Manifold& manifold = *held.manifold;
    const uint32_t n = manifold.ambient(), count = given.count(n), segments = given.segments(n);
    out.points.reserve((size_t{segments} * pieces + 1) * n);
    out.ends.reserve(segments);
    out.points.assign(given.values.begin(), given.values.begin() + n);
    std::optional<NearestPoints> nearest;
    if (held.components.size() > 0) {
        nearest.emplace(co_await nearest_on(pace, held));
        co_await refuse_parts(pace, held, given, *nearest);
    }
    for (uint32_t s = 0; s < segments; ++s) {
        const double* const b = &given.values[size_t{(s + 1) % count} * n];
        const size_t offset = out.points.size() - n;
        out.points.resize(out.points.size() + size_t{pieces} * n);
        std::copy_n(b, n, out.points.end() - n);
        // Here, not in a task for each of many segments, which would go too deep where compilers make no tail calls.
        bool found = true;
        for (uint32_t m = 0; found && m + 1 < pieces; ++m) {
            found = halve_chord(manifold, &out.points[offset], m);
            co_await pace;
        }
        found = found && is_even(&out.points[offset], n);
        // Normals of neighbours that oppose each other are those of two sides.
        Vec3 last = Vec3::Zero();
        for (uint32_t p = 0; found && held.has_normals() && p <= pieces; ++p) {
            const Vec3 normal = normal_at(manifold, &out.points[offset + size_t{p} * n]);
            if (p > 0 && normal.dot(last) < 0) found = false;
            last = normal;
            co_await pace;
        }
        for (uint32_t p = 0; found && held.border && held.has_normals() && p < pieces; ++p) {
            const double* const piece = &out.points[offset + size_t{p} * n];
            found = stays_on_mesh(*held.border, piece, piece + n);
            co_await pace;
        }
        if (!found) {
            out.points.resize(offset + n);
            if (!held.surface) {
                found = co_await walk(pace, manifold, b, out.points);
                if (found) {
                    out.ends.push_back(static_cast<uint32_t>(out.points.size() / n));
                    continue;
                }
                throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                              "%s: no way over the surface was found from point %u to point %u; put points between",
                              given.argument, s, (s + 1) % count);
            }
            if (!nearest) nearest.emplace(co_await nearest_on(pace, held));
            co_await follow_mesh(pace, held, given, s, *nearest, out);
        }
        out.ends.push_back(static_cast<uint32_t>(out.points.size() / n));
    }
}

namespace {

// Shares a number of intervals between segments, so that they add up: to each its part of what is left.
class IntervalShares {
public:
    IntervalShares(uint32_t intervals, uint32_t segments, uint32_t min_intervals, double whole)
        : left_(intervals), segments_(segments), min_intervals_(min_intervals), rest_(whole) {}

    uint32_t left() const { return left_; }
    uint32_t next(double share) {
        const uint32_t max_intervals = left_ - min_intervals_ * (segments_ - 1);
        uint32_t intervals = max_intervals;
        if (segments_ > 1) {
            const double wanted = rest_ > 0 ? share / rest_ * left_ : 0;
            intervals = std::clamp(static_cast<uint32_t>(std::lround(wanted)), min_intervals_, max_intervals);
        }
        rest_ -= share;
        left_ -= intervals;
        --segments_;
        return intervals;
    }

private:
    uint32_t left_, segments_, min_intervals_;
    double rest_;
};

}  // namespace

Task<void> place_nodes(Pace& pace, const Manifold& manifold, const FirstCurve& first, GivenPoints given, uint32_t nodes,
                       uint32_t min_intervals, SplineProblem& problem) {
    const uint32_t n = manifold.ambient(), count = given.count(n), segments = given.segments(n);
    const std::pmr::vector<double>& chain = first.points;
    std::pmr::vector<double> shares(segments, 0.0, pace.memory());
    double whole = 0;
    co_await each_by_work(pace, segments, Cost::some_ns, [&](uint32_t s) {
        const uint32_t begin = s == 0 ? 0 : first.ends[s - 1] - 1;
        double length = 0;
        for (uint32_t p = begin; p + 1 < first.ends[s]; ++p)
            length += distance_between(&chain[size_t{p} * n], &chain[size_t{p + 1} * n], n);
        shares[s] = problem.parameters.size() > 0 ? problem.parameters[s + 1] - problem.parameters[s] : length;
        whole += shares[s];
        return first.ends[s] - begin;
    });
    IntervalShares sharing(std::max(given.closed ? nodes : nodes - 1, min_intervals * segments), segments,
                           min_intervals, whole);
    problem.knots = Buffer<uint32_t>(count, pace.memory());
    problem.given = Buffer<double>(given.values.size(), pace.memory());
    problem.points = Buffer<double>(size_t{sharing.left() + (given.closed ? 0 : 1)} * n, pace.memory());
    uint32_t at = 0;
    for (uint32_t s = 0; s < segments; ++s) {
        const uint32_t intervals = sharing.next(shares[s]);
        problem.knots[s] = at;
        std::copy_n(&given.values[size_t{s} * n], n, &problem.given[size_t{s} * n]);
        const uint32_t begin = s == 0 ? 0 : first.ends[s - 1] - 1, end = first.ends[s] - 1;
        double length = 0;
        for (uint32_t p = begin; p < end; ++p)
            length += distance_between(&chain[size_t{p} * n], &chain[size_t{p + 1} * n], n);
        uint32_t p = begin;
        double passed = 0, piece = distance_between(&chain[size_t{p} * n], &chain[size_t{p + 1} * n], n);
        for (uint32_t i = 0; i < intervals; ++i) {
            const double target = length * i / intervals;
            while (p + 1 < end && passed + piece < target) {
                passed += piece;
                ++p;
                piece = distance_between(&chain[size_t{p} * n], &chain[size_t{p + 1} * n], n);
            }
            const double t = piece > 0 ? std::clamp((target - passed) / piece, 0.0, 1.0) : 0;
            for (uint32_t c = 0; c < n; ++c) {
                problem.points[size_t{at} * n + c] =
                    chain[size_t{p} * n + c] * (1 - t) + chain[size_t{p + 1} * n + c] * t;
            }
            ++at;
            if (at % 128 == 0) co_await pace;
        }
    }
    if (given.closed) co_return;
    problem.knots[segments] = at;
    std::copy_n(&given.values[size_t{segments} * n], n, &problem.given[size_t{segments} * n]);
    std::copy_n(&given.values[size_t{segments} * n], n, &problem.points[size_t{at} * n]);
}

Task<void> refine_chain(Pace& pace, const SplineOptimizer& coarse, uint32_t nodes, uint32_t min_intervals,
                        SplineProblem& problem) {
    const uint32_t n = coarse.ambient(), old_nodes = coarse.nodes();
    std::pmr::vector<double> times(1, 0.0, pace.memory());
    co_await each(pace, problem.closed ? old_nodes : old_nodes - 1, Cost::some_ns,
                  [&](uint32_t i) { times.push_back(times.back() + coarse.step_after(i)); });
    CubicData data{.knots = times, .values = {coarse.points(), size_t{old_nodes} * n}};
    data.dimension = n;
    data.ends = problem.closed ? CubicEnds::periodic : CubicEnds::natural;
    data.tension = problem.bending > 0 ? 0 : HUGE_VAL;
    const NaturalCubic curve = co_await natural_cubic(pace, data);
    const uint32_t count = static_cast<uint32_t>(problem.knots.size()), segments = count - (problem.closed ? 0 : 1);
    IntervalShares sharing(problem.closed ? nodes : nodes - 1, segments, min_intervals, times.back());
    const uint32_t remembered = problem.manifold->hint_size();
    problem.points = Buffer<double>(size_t{nodes} * n, pace.memory());
    problem.hints = Buffer<double>(size_t{nodes} * remembered, pace.memory());
    uint32_t at = 0, last_knot = 0;
    for (uint32_t s = 0; s < segments; ++s) {
        const uint32_t next_knot = s + 1 < count ? problem.knots[s + 1] : old_nodes;
        const double begin = times[last_knot], end = times[next_knot];
        const uint32_t intervals = sharing.next(end - begin);
        problem.knots[s] = at;
        for (uint32_t i = 0; i < intervals; ++i, ++at) {
            curve.evaluate(begin + (end - begin) * i / intervals, 0, &problem.points[size_t{at} * n]);
            // Steps of the coarse chain are equal too.
            const uint32_t near = last_knot + static_cast<uint32_t>(uint64_t{i} * (next_knot - last_knot) / intervals);
            std::copy_n(coarse.hint(near), remembered, problem.hints.data() + size_t{at} * remembered);
            if (at % 32 == 0) co_await pace;
        }
        last_knot = next_knot;
    }
    if (problem.closed) co_return;
    problem.knots[segments] = at;
    curve.evaluate(times.back(), 0, &problem.points[size_t{at} * n]);
    std::copy_n(coarse.hint(old_nodes - 1), remembered, problem.hints.data() + size_t{at} * remembered);
}

Task<void> unrestricted_spline(Pace& pace, SplineProblem& problem) {
    const SpaceManifold space(problem.manifold->ambient(), problem.manifold->size());
    const Manifold* const own = problem.manifold;
    problem.manifold = &space;
    {
        SplineOptimizer optimizer(problem, pace.memory());
        co_await SplineOptimizer::minimize(pace, optimizer);
        problem.points = optimizer.take_points();
    }
    problem.manifold = own;
}

}  // namespace flg
