// SPDX-License-Identifier: MIT
#include "splines/triangle_curve.h"

#include <algorithm>
#include <bit>

#include "splines/manifolds/coordinates.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

namespace {

constexpr uint32_t find_chunk = 100;
constexpr uint32_t usual_halvings = 5;
constexpr double least_step = 1e-12;  // of that, in energies

// As many intervals as are asked for, or 32 a segment, but not too many nodes.
uint32_t halvings_for(uint32_t segments, uint32_t nodes) {
    uint32_t halvings = usual_halvings;
    if (nodes > 0) halvings = std::clamp(uint32_t(std::bit_width((nodes - 1) / segments)), 1u, max_bezier_halvings);
    while (halvings > 1 && (uint64_t{segments} << halvings) >= FLG_SPLINE_MAX_NODES) --halvings;
    return halvings;
}

// The points of the triangles that are nearest to the given ones.
Task<void> place_points(Pace& pace, const SplineRequest& request, Spline::OnTriangles& out) {
    const ManifoldProduct& held = *request.out->manifold;
    NearestPoints nearest = co_await nearest_on(pace, held);
    const size_t count = request.points.size() / 3;
    out.given = Buffer<double>(request.points.size(), pace.memory());
    out.offsets = Buffer<double>(count, pace.memory());
    out.bezier.given.reserve(count);
    for (size_t i = 0; i < count; ++i) {
        const Vec3 wanted(request.points.data() + 3 * i);
        nearest.begin(wanted);
        while (!nearest.find(find_chunk)) co_await pace;
        out.bezier.given.push_back(nearest.found());
        std::copy_n(nearest.found_place().data(), 3, &out.given[3 * i]);
        out.offsets[i] = (nearest.found_place() - wanted).norm();
    }
    co_await refuse_coincident(pace, out.given, 3, out.bezier.closed, held.manifold->size());
}

// The curve for the host, with the energies of the cubic spline through its nodes.
Task<void> copy_curve(Pace& pace, const Spline& spline, Spline::Chain& out) {
    const SurfaceBezier& curve = spline.triangles->bezier;
    const Mesh& mesh = spline.manifold->surface->mesh();
    const auto nodes = static_cast<uint32_t>(curve.nodes.size());
    const double shortest = least_step * spline.manifold->manifold->size();
    if (out.nodes.size() != size_t{3} * nodes) {
        out.nodes = Buffer<double>(size_t{3} * nodes, pace.memory());
        out.parameters = Buffer<double>(size_t{nodes} + 1, pace.memory());
    }
    co_await each(pace, nodes, Cost::tens_of_ns, [&](uint32_t i) {
        const Vec3 place = position_of(mesh, curve.nodes[i]);
        std::copy_n(place.data(), 3, &out.nodes[size_t{3} * i]);
    });
    co_await each(pace, curve.given.size(), Cost::some_ns, [&](uint32_t k) {
        std::copy_n(&spline.triangles->given[size_t{3} * k], 3, &out.nodes[(size_t{3} * k) << curve.halvings]);
    });
    Moments moments(nodes, 3, curve.closed, 0, pace.memory());
    out.report = {};
    double parameter = 0;
    co_await each(pace, nodes, Cost::tens_of_ns, [&](uint32_t i) {
        out.parameters[i] = parameter;
        if (i >= moments.steps().size()) return;
        const double step = distance_between(&out.nodes[size_t{3} * i], &out.nodes[size_t{3} * ((i + 1) % nodes)], 3);
        moments.steps()[i] = std::max(step, shortest);
        out.report.length += step;
        parameter += moments.steps()[i];
    });
    out.parameters[nodes] = parameter;
    Buffer<double> second(size_t{3} * nodes, pace.memory());
    co_await Moments::factorize(pace, moments);
    co_await Moments::solve(pace, moments, out.nodes.data(), second.data());
    co_await each(pace, nodes, Cost::tens_of_ns, [&](uint32_t i) {
        out.report.bending += moments.energy(i, out.nodes.data(), &second[size_t{3} * i]);
    });
    out.report.stretching = parameter;  // its parameter is its length
    out.on_triangles = true;
}

}  // namespace

Task<void> lay_triangle_curve(Pace& pace, const SplineRequest& request, const Spline* before) {
    Spline& out = *request.out;
    Spline::OnTriangles& laid = out.triangles.emplace(pace.memory());
    SurfaceBezier& curve = laid.bezier;
    curve.closed = out.closed;
    co_await place_points(pace, request, laid);
    curve.halvings = halvings_for(curve.segments(), request.desc.node_count);
    const bool can_keep = before && before->is_complete && before->triangles;
    const SurfaceBezier* const kept = can_keep ? &before->triangles->bezier : nullptr;
    const BezierResult result = co_await make_surface_bezier(pace, out.manifold->surface->mesh(), kept, curve);
    if (!result.found) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.points: no way leads over the surface from point %u to point %u", result.without_way,
                      (result.without_way + 1) % static_cast<uint32_t>(curve.given.size()));
    }
    if (!pace.job().partial_results) co_return;
    co_await copy_curve(pace, out, out.rounds.write());
    out.rounds.hand_over();
}

Task<void> keep_triangle_curve(Pace& pace, const SplineRequest& request) {
    Spline& out = *request.out;
    Spline::OnTriangles& laid = *out.triangles;
    const SurfaceBezier& curve = laid.bezier;
    const Mesh& mesh = out.manifold->surface->mesh();
    co_await copy_curve(pace, out, out.chain);
    SplineReport& report = out.chain.report;
    report.energy = request.problem.bending * report.bending + request.problem.tension * report.stretching;
    out.offsets = std::move(laid.offsets);
    out.given = std::move(laid.given);
    const size_t nodes = curve.nodes.size();
    out.points = Buffer<double>(3 * nodes, pace.memory());
    out.normals = Buffer<float>(3 * nodes, pace.memory());
    co_await each(pace, nodes, Cost::microseconds, [&](uint32_t i) {
        std::copy_n(&out.chain.nodes[size_t{3} * i], 3, &out.points[size_t{3} * i]);
        store_vec3(smooth_normal(mesh, curve.nodes[i]), &out.normals[size_t{3} * i]);
    });
    out.knots = Buffer<uint32_t>(curve.given.size(), pace.memory());
    co_await each(pace, curve.given.size(), Cost::some_ns, [&](uint32_t k) { out.knots[k] = k << curve.halvings; });
    out.hints = {};
    out.held = {};
}

}  // namespace flg
