// SPDX-License-Identifier: MIT
// Splines as hosts hold them, and the job that makes them.
#pragma once

#include <algorithm>
#include <optional>

#include "core/failure.h"
#include "curves/curve_set.h"
#include "splines/obstacles/obstacles.h"
#include "splines/optimizer/first_curve.h"
#include "splines/optimizer/triple_buffer.h"
#include "surfaces/tracing/surface_bezier.h"

namespace flg {

class Spline final : public Product {
public:
    explicit Spline(std::shared_ptr<const ManifoldProduct> on) : manifold(std::move(on)) {}

    const std::shared_ptr<const ManifoldProduct> manifold;
    Origin origin{};  // of its coordinates: the manifold's or, in free space, its points'

    // A chain as the host sees it.
    struct Chain {
        Buffer<double> nodes, parameters;  // as many coordinates as the manifold shows; one a node, closed: one more
        SplineReport report;
        bool on_triangles = false;  // made by triangle_curve.h
    };

    // By the job that makes it.
    TripleBuffer<Chain> rounds;  // of jobs with partial results
    Chain chain;                 // the last one
    Buffer<double> points;       // of that, all coordinates: where others begin
    Buffer<double> hints;        // of these
    Buffer<double> given;        // the same, of the given points
    Buffer<uint32_t> knots;      // their nodes
    Buffer<uint32_t> held;       // nodes that the optimizer held
    Buffer<uint32_t> breaks;     // nodes of points with handles, where curvature and perhaps the tangent jump
    // As few cubic pieces, where asked for (spline_keys.h): derivatives by the parameter before and after each key.
    struct Keys {
        Buffer<double> parameters, points, arriving, leaving;
        double largest_error = 0;  // m
    };
    Keys keys;
    Buffer<double> offsets;  // how far they were from the manifold, m
    Buffer<float> normals;   // 3 a node, of surfaces in R^3
    // The curve over the mesh's triangles, where it was made.
    struct OnTriangles {
        explicit OnTriangles(Memory* memory) : bezier(memory) {}

        SurfaceBezier bezier;
        Buffer<double> given, offsets;  // as the spline's
    };
    std::optional<OnTriangles> triangles;
    // Where asked for: the point of the mesh's triangles nearest to each node, and how far that is at most, m.
    Buffer<FlgSurfacePoint> surface_points;
    double largest_moved = 0;
    bool closed = false;
    bool is_complete = false;  // all of it is there
    bool jumped = false;       // not to where it goes on from the one before, but to lower energy
    bool out_of_evaluations = false;

    const FlgSplineView& view() const { return view_; }
    void publish_partial() noexcept override;

private:
    void show() noexcept override;
    void show_chain(const Chain& chain) noexcept;

    FlgSplineView view_{};
};

// At a given point, for what follows there: a derivative, or a corner.
struct SplineHandle {
    uint32_t point = 0;
    uint32_t index = 0;  // as given
    bool has_slope = false;
    double slope[Manifold::max_ambient] = {};  // in the job, its part tangent to the manifold
};

// FlgSplineDesc::max_evaluations by default, and what that stands for: so many a node, but within these bounds.
inline constexpr uint64_t default_evaluations = 2000000;
constexpr uint64_t default_evaluations_of(uint64_t nodes) {
    return std::clamp<uint64_t>(800 * nodes, 600000, default_evaluations);
}

struct SplineRequest {
    std::shared_ptr<Spline> out;
    std::shared_ptr<const Spline> warm_start;    // or null
    Buffer<double> points;                       // as given, given_ambient each
    Buffer<double> curve;                        // the same, or empty
    Buffer<double> slopes[2];                    // the same, or empty
    Buffer<SplineHandle> handles;                // by point, one at most
    SplineProblem problem;                       // options, parameters and, with a curve, knots
    FlgSplineDesc desc{};                        // checked; its handles are resolved here, its arrays copied
    std::shared_ptr<const Obstacles> obstacles;  // or null
    double more_clearance = 0;                   // beside theirs, m
    bool stays_within = false;                   // the borders of the mesh that it is on, by `within` metres
    double within = 0;
    std::optional<PlacedObstacles> placed;  // these from the spline's origin; by the job
    Buffer<ObstacleSide> sides;
};

// The whole of flgSplineCreate.
Task<void> make_spline(Pace& pace, SplineRequest request);

// What it does where the request has obstacles (obstacle_spline.cpp; Hofer, Pottmann 2004, sec. 5): minimizers on
// barriers around them whose radius shrinks.
Task<void> make_obstacle_spline(Pace& pace, SplineRequest& request);

// That a curve can't be had on a manifold, though it may be over its triangles.
class OffSurface final : public Failure {
public:
    explicit OffSurface(const Failure& failure) : Failure(failure) {}
};

// Steps of that. Points of the host put onto the manifold: all their coordinates and, unless null, how far they were
// from it.
Task<void> place_spline_points(Pace& pace, const ManifoldProduct& held, const Buffer<double>& from,
                               const char* argument, Buffer<double>& out, Buffer<double>* offsets);
// Fails where two given points that follow each other, n numbers each, come to one place.
Task<void> refuse_coincident(Pace& pace, const Buffer<double>& given, uint32_t n, bool closed, double size);
// Runs the optimizer to its end, and shows its rounds if the host wants to see them.
Task<void> run_optimizer(Pace& pace, SplineOptimizer& optimizer, Spline& spline);
// From a chain that has begun to `nodes` nodes, and what stays of it.
Task<void> minimize_chain(Pace& pace, const SplineRequest& request, SplineProblem& problem, uint32_t nodes,
                          Spline& out);
// What stays of an optimizer that is done.
Task<void> keep_spline(Pace& pace, SplineOptimizer& optimizer, Spline& out);

// Throws a Failure where nodes of R^3 are too far from the origin for a curve or mesh of floats.
Task<void> check_precision(Pace& pace, const Buffer<double>& nodes);

// The whole of flgSplineSample.
Task<void> spline_curves(Pace& pace, std::shared_ptr<const Spline> spline, float height, double spacing,
                         std::shared_ptr<CurveSet> out);

}  // namespace flg
