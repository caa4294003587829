// SPDX-License-Identifier: MIT
// Splines: made, shown, copied into curve sets, released.
#include <algorithm>
#include <cmath>

#include "api/descriptors.h"
#include "api/inputs.h"
#include "api/surface_inputs.h"
#include "splines/spline_offset.h"
#include "splines/spline_ribbon.h"
#include "splines/surface_trace.h"

namespace flg {

namespace {

constexpr uint32_t max_points = 65536;
constexpr uint32_t max_subdivisions = 8;

FlgSplineDesc default_spline_desc() {
    auto desc = sized<FlgSplineDesc>();
    desc.tension = 1;
    desc.max_rounds = 200;
    desc.tolerance = 1e-6;
    desc.obstacle_radius = 1e-3;
    desc.max_evaluations = default_evaluations;
    return desc;
}

FlgSplineSweepDesc default_ribbon_desc() {
    auto desc = sized<FlgSplineSweepDesc>();
    desc.columns = 4;
    desc.width = 1;
    return desc;
}

RibbonShape read_ribbon(const FlgSplineSweepDesc& desc, const ManifoldProduct& manifold) {
    RibbonShape shape;
    check_range(desc.columns >= 1 && desc.columns <= 256, "desc.columns", desc.columns, "1 to 256");
    check_range(desc.width >= 1e-30 && desc.width <= 1e30, "desc.width", desc.width, "1e-30 to 1e30");
    check_range(desc.spacing >= 0 && desc.spacing <= 1e30, "desc.spacing", desc.spacing, "0 to 1e30");
    check_range(std::abs(desc.height) <= 1e30, "desc.height", desc.height, "finite and at most 1e30 in size");
    check_range(std::abs(desc.bank) <= 1e30, "desc.bank", desc.bank, "finite and at most 1e30 in size");
    check_range(desc.texture_length == 0 || (desc.texture_length >= 1e-30 && desc.texture_length <= 1e30),
                "desc.texture_length", desc.texture_length, "0, or 1e-30 to 1e30");
    check_range(desc.reserved == 0, "desc.reserved", desc.reserved, "0");
    for (int c = 0; c < 3; ++c) {
        check_range(std::abs(desc.up[c]) <= 1e30, "desc.up", desc.up[c], "finite and at most 1e30 in size");
        shape.up[c] = desc.up[c];
    }
    if (!shape.up.isZero(0)) shape.up.stableNormalize();
    shape.columns = desc.columns;
    shape.width = desc.width;
    shape.spacing = desc.spacing;
    shape.height = desc.height;
    shape.bank = desc.bank;
    shape.texture_length = desc.texture_length;
    shape.conforms = desc.conforms != 0;
    check_range(manifold.given_ambient == 3, "the number of coordinates of desc.spline", manifold.given_ambient, "3");
    if (shape.conforms && !manifold.has_triangles())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.conforms: desc.spline is not on the manifold of a mesh");
    if (shape.conforms && (shape.bank != 0 || !shape.up.isZero(0)))
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.%s can't be given together with desc.conforms",
                      shape.bank != 0 ? "bank" : "up");
    if (!shape.conforms && shape.up.isZero(0) && !manifold.has_normals())
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.up is 0, which is for splines on a surface in R^3, as it has normals");
    return shape;
}

OffsetShape read_offset(const FlgSplineOffsetDesc& desc, const ManifoldProduct& manifold) {
    OffsetShape shape{.left = desc.left, .above = desc.above, .spacing = desc.spacing};
    check_range(std::abs(desc.left) <= 1e30, "desc.left", desc.left, "finite and at most 1e30 in size");
    check_range(std::abs(desc.above) <= 1e30, "desc.above", desc.above, "finite and at most 1e30 in size");
    check_range(desc.spacing >= 0 && desc.spacing <= 1e30, "desc.spacing", desc.spacing, "0 to 1e30");
    check_range(desc.reserved == 0, "desc.reserved", desc.reserved, "0");
    for (int c = 0; c < 3; ++c) {
        check_range(std::abs(desc.up[c]) <= 1e30, "desc.up", desc.up[c], "finite and at most 1e30 in size");
        shape.up[c] = desc.up[c];
    }
    if (!shape.up.isZero(0)) shape.up.stableNormalize();
    shape.turns_least = desc.turns_least != 0;
    shape.keeps_loops = desc.keeps_loops != 0;
    check_range(manifold.given_ambient == 3, "the number of coordinates of desc.spline", manifold.given_ambient, "3");
    return shape;
}

Buffer<double> read_numbers(const double* from, size_t count, const char* argument, Memory* memory) {
    require(from, argument);
    Buffer<double> out(count, memory);
    for (size_t i = 0; i < count; ++i) {
        if (!(std::abs(from[i]) <= 1e30)) {
            char name[64];
            std::snprintf(name, sizeof name, "%s[%zu]", argument, i);
            check_range(false, name, from[i], "finite and at most 1e30 in size");
        }
        out[i] = from[i];
    }
    return out;
}

// Points of R^3; of other spaces by nothing.
void move_points(Buffer<double>& points, const Vec3& shift) {
    if (shift.isZero(0)) return;
    for (size_t i = 0; i < points.size(); ++i) points[i] += shift[static_cast<Eigen::Index>(i % 3)];
}

void read_energy(const FlgSplineDesc& desc, SplineProblem& problem) {
    check_enum(desc.energy, FLG_SPLINE_ENERGY_E2, FLG_SPLINE_ENERGY_ET, "desc.energy", "FLG_SPLINE_E");
    problem.bending = desc.energy == FLG_SPLINE_ENERGY_E1 ? 0 : 1;
    if (desc.energy == FLG_SPLINE_ENERGY_ET) {
        check_range(desc.tension > 0 && desc.tension <= 1e12, "desc.tension", desc.tension, "above 0, at most 1e12");
        problem.tension = desc.tension;
    } else {
        problem.tension = desc.energy == FLG_SPLINE_ENERGY_E1 ? 1 : 0;
    }
    check_range(desc.smoothing >= 0 && desc.smoothing <= 1e30, "desc.smoothing", desc.smoothing, "0 to 1e30");
    problem.smoothing = desc.smoothing;
    check_range(desc.first_tension >= 0 && desc.first_tension <= 1e12, "desc.first_tension", desc.first_tension,
                "0 to 1e12");
    problem.first_tension = desc.energy == FLG_SPLINE_ENERGY_E1 ? 0 : desc.first_tension;
    check_range(desc.max_rounds >= 1 && desc.max_rounds <= 10000, "desc.max_rounds", desc.max_rounds, "1 to 10000");
    check_range(desc.tolerance >= 1e-12 && desc.tolerance <= 1, "desc.tolerance", desc.tolerance, "1e-12 to 1");
    problem.max_rounds = desc.max_rounds;
    problem.tolerance = desc.tolerance;
}

void read_parameters(const FlgSplineDesc& desc, SplineProblem& problem, Memory* memory) {
    if (!desc.parameters) return;
    const size_t count = size_t{desc.point_count} + (problem.closed ? 1 : 0);
    problem.parameters = read_numbers(desc.parameters, count, "desc.parameters", memory);
    const double span = problem.parameters[count - 1] - problem.parameters[0];
    for (size_t i = 1; i < count; ++i) {
        if (problem.parameters[i] - problem.parameters[i - 1] > 1e-9 * span) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.parameters[%zu] is %s, must be above the one before it, %s, by 1e-9 of all", i,
                      NumberText(problem.parameters[i]).c_str(), NumberText(problem.parameters[i - 1]).c_str());
    }
}

// A curve of nodes, and which of them are held.
void read_curve(const FlgSplineDesc& desc, uint32_t ambient, SplineRequest& request, Memory* memory) {
    SplineProblem& problem = request.problem;
    if (!desc.curve) {
        const uint32_t least = problem.closed ? 3 : 2;
        check_range(desc.point_count >= least, "desc.point_count", desc.point_count,
                    problem.closed ? "3 to 65536" : "2 to 65536");
        check_range(desc.node_count <= FLG_SPLINE_MAX_NODES, "desc.node_count", desc.node_count, "at most 2^20");
        check_enum(desc.start, FLG_SPLINE_START_GEODESIC, FLG_SPLINE_START_PROJECTED, "desc.start",
                   "FLG_SPLINE_START_");
        return;
    }
    require(desc.curve_knots, "desc.curve_knots");
    const uint32_t least = problem.closed ? 3 : 2;
    check_range(desc.curve_count >= least && desc.curve_count <= FLG_SPLINE_MAX_NODES, "desc.curve_count",
                desc.curve_count, problem.closed ? "3 to 2^20" : "2 to 2^20");
    check_range(desc.point_count >= (problem.closed ? 1 : 2), "desc.point_count", desc.point_count,
                problem.closed ? "at least 1" : "at least 2");
    problem.knots = Buffer<uint32_t>(desc.point_count, memory);
    for (uint32_t i = 0; i < desc.point_count; ++i) {
        const uint32_t knot = problem.knots[i] = desc.curve_knots[i];
        const bool ascends = i == 0 ? knot == 0 : knot > problem.knots[i - 1];
        if (ascends && knot < desc.curve_count) continue;
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT, "desc.curve_knots[%u] is %u, must be %s", i, knot,
            i == 0 ? "0: a curve begins at a given point" : "above the one before it and below desc.curve_count");
    }
    if (!problem.closed && problem.knots[desc.point_count - 1] + 1 != desc.curve_count) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.curve_knots ends with %u, must end with the open curve's last node, %u",
                      problem.knots[desc.point_count - 1], desc.curve_count - 1);
    }
    request.curve = read_numbers(desc.curve, size_t{desc.curve_count} * ambient, "desc.curve", memory);
}

void read_handles(const FlgSplineDesc& desc, uint32_t ambient, SplineRequest& request, Memory* memory) {
    if (desc.handle_count == 0) return;
    require(desc.handles, "desc.handles");
    if (desc.curve || desc.obstacles.id != 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.handles can't be given together with desc.%s",
                      desc.curve ? "curve" : "obstacles");
    check_range(desc.handle_count <= desc.point_count, "desc.handle_count", desc.handle_count,
                "at most desc.point_count");
    request.handles = Buffer<SplineHandle>(desc.handle_count, memory);
    for (uint32_t h = 0; h < desc.handle_count; ++h) {
        const FlgSplineHandle handle = read_element(desc.handles, h, sized<FlgSplineHandle>(), "handle");
        SplineHandle& out = request.handles[h] = SplineHandle{.point = handle.point, .index = h};
        if (handle.point >= desc.point_count)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "desc.handles[%u].point is %u, must be below desc.point_count, %u", h, handle.point,
                          desc.point_count);
        if (!handle.slope) continue;
        char name[64];
        std::snprintf(name, sizeof name, "desc.handles[%u].slope", h);
        const Buffer<double> slope = read_numbers(handle.slope, ambient, name, memory);
        std::copy_n(slope.data(), ambient, out.slope);
        out.has_slope = true;
        if (std::all_of(slope.begin(), slope.end(), [](double x) { return x == 0; }))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "%s is 0, so it has no direction; a corner is a handle whose slope is null", name);
    }
    std::sort(request.handles.begin(), request.handles.end(), [](const SplineHandle& a, const SplineHandle& b) {
        return a.point != b.point ? a.point < b.point : a.index < b.index;
    });
    for (uint32_t h = 1; h < desc.handle_count; ++h) {
        if (request.handles[h].point != request.handles[h - 1].point) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.handles[%u] and desc.handles[%u] are both at point %u",
                      request.handles[h - 1].index, request.handles[h].index, request.handles[h].point);
    }
}

// Smoothings of points, tensions of segments.
void read_local(const FlgSplineDesc& desc, SplineProblem& problem, Memory* memory) {
    const auto read = [&](const double* from, size_t count, const char* name, double most, const char* range) {
        if (desc.obstacles.id != 0)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s can't be given together with desc.obstacles", name);
        Buffer<double> out = read_numbers(from, count, name, memory);
        for (size_t i = 0; i < count; ++i) {
            char element[64];
            std::snprintf(element, sizeof element, "%s[%zu]", name, i);
            check_range(out[i] >= 0 && out[i] <= most, element, out[i], range);
        }
        return out;
    };
    if (desc.softness) problem.softness = read(desc.softness, desc.point_count, "desc.softness", 1e30, "0 to 1e30");
    if (!desc.tensions) return;
    if (desc.energy != FLG_SPLINE_ENERGY_ET)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.tensions: desc.energy must be FLG_SPLINE_ENERGY_ET");
    const size_t segments = desc.point_count - (problem.closed ? 0 : 1);
    problem.tensions = read(desc.tensions, segments, "desc.tensions", 1e12, "0 to 1e12");
}

void read_obstacles(Context& context, const FlgSplineDesc& desc, const ManifoldProduct& manifold,
                    SplineRequest& request, Submission& submission) {
    if (desc.obstacles.id == 0) return;
    request.obstacles = context.obstacles.get(desc.obstacles.id, "desc.obstacles");
    submission.read(*request.obstacles, "desc.obstacles");
    const uint32_t dimension = request.obstacles->dimension;
    const bool fits = manifold.kind == ManifoldKind::space
                          ? manifold.given_ambient == dimension
                          : manifold.kind == ManifoldKind::hypersurface && dimension == 3;
    if (!fits) {
        throw Failure(
            FLG_ERROR_INVALID_ARGUMENT,
            "desc.obstacles are of %u dimensions: desc.manifold must be a FLG_MANIFOLD_SHAPE_SPACE of as many, or "
            "with 3 a surface in R^3",
            dimension);
    }
    if (desc.curve) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.curve can't be given together with desc.obstacles");
    if (desc.on_triangles)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.on_triangles can't be given together with desc.obstacles");
    check_range(desc.obstacle_radius >= 1e-5 && desc.obstacle_radius <= 0.1, "desc.obstacle_radius",
                desc.obstacle_radius, "1e-5 to 0.1");
    if (desc.side_count > 0) require(desc.sides, "desc.sides");
    check_range(desc.side_count <= ObstacleSet::max_count, "desc.side_count", desc.side_count, "at most 256");
    request.sides = Buffer<ObstacleSide>(desc.side_count, context.memory[MemoryKind::curves]);
    for (uint32_t i = 0; i < desc.side_count; ++i) {
        const FlgObstacleSide& side = desc.sides[i];
        request.sides[i] = {side.obstacle,
                            {side.direction[0], side.direction[1], dimension == 3 ? side.direction[2] : 0}};
    }
}

void check_subdivisions(const FlgSplineDesc& desc) {
    check_range(desc.subdivisions <= max_subdivisions, "desc.subdivisions", desc.subdivisions, "0 to 8");
    const uint64_t by_default = std::min(32 * desc.point_count, FLG_SPLINE_MAX_NODES);
    const uint64_t first = desc.curve ? desc.curve_count : desc.node_count > 0 ? desc.node_count : by_default;
    if (desc.subdivisions > 0 && (first << desc.subdivisions) > FLG_SPLINE_MAX_NODES) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.subdivisions is %u, which makes more than 2^20 nodes of %u",
                      desc.subdivisions, static_cast<uint32_t>(first));
    }
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgSplineDescInit(FlgSplineDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_spline_desc());
}

FlgResult flgSplineHandleInit(FlgSplineHandle* handle, uint32_t struct_size) {
    return init(handle, struct_size, sized<FlgSplineHandle>());
}

FlgResult flgSplineCreate(FlgContext context, const FlgSplineDesc* desc, FlgSpline* out_spline, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_spline, "out_spline", out_job);
        Memory* const memory = self.memory[MemoryKind::curves];
        const FlgSplineDesc read = read_struct(desc, default_spline_desc(), "desc");
        Submission submission(self, read.job);
        const auto manifold = self.manifolds.get(read.manifold.id, "desc.manifold");
        submission.read(*manifold, "desc.manifold");
        const uint32_t ambient = manifold->given_ambient;
        SplineRequest request;
        request.desc = read;
        request.problem.closed = read.closed != 0;
        check_range(read.point_count <= max_points, "desc.point_count", read.point_count, "at most 65536");
        read_energy(read, request.problem);
        read_curve(read, ambient, request, memory);
        check_subdivisions(read);
        read_parameters(read, request.problem, memory);
        read_handles(read, ambient, request, memory);
        read_local(read, request.problem, memory);
        if (read.seek_lower != 0 && (read.curve || read.obstacles.id != 0))
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.seek_lower can't be given together with desc.%s",
                          read.curve ? "curve" : "obstacles");
        check_range(read.key_tolerance >= 0 && read.key_tolerance <= 1e30, "desc.key_tolerance", read.key_tolerance,
                    "0 to 1e30");
        read_obstacles(self, read, *manifold, request, submission);
        request.points = read_numbers(read.points, size_t{read.point_count} * ambient, "desc.points", memory);
        const Origin given = read_origin_in(ambient, read.origin, "desc.origin");
        const Origin origin = manifold->kind == ManifoldKind::space ? given : manifold->origin;
        move_points(request.points, origin_shift(given, origin));
        move_points(request.curve, origin_shift(given, origin));
        if (read.begin_slope) request.slopes[0] = read_numbers(read.begin_slope, ambient, "desc.begin_slope", memory);
        if (read.end_slope) request.slopes[1] = read_numbers(read.end_slope, ambient, "desc.end_slope", memory);
        if (read.warm_start.id != 0) {
            request.warm_start = self.splines.get(read.warm_start.id, "desc.warm_start");
            if (request.warm_start->manifold != manifold)
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.warm_start is on another manifold");
            submission.wait_for_end_of(request.warm_start->producer.lock());
        }
        if (manifold->surface) {
            submission.wait_for(start_blocks(self, manifold->surface));
            submission.read_surface(manifold->surface, "the surface of desc.manifold");
        }
        const auto out = self.make(self.splines, manifold);
        out->origin = origin;
        request.out = out;
        submission.job().strand.start(make_spline(submission.pace(), std::move(request)));
        *out_spline = {submission.commit(self.splines, out, out_job)};
    });
}

FlgResult flgSplineViewInit(FlgSplineView* view, uint32_t struct_size) {
    return init_view(view, struct_size);
}

FlgResult flgSplineGetView(FlgContext context, FlgSpline spline, FlgSplineView* out_view) {
    return get_view(out_view, [&] { return get_context(context).splines.get(spline.id, "spline"); });
}

FlgResult flgSplineTraceDescInit(FlgSplineTraceDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSplineTraceDesc>());
}

FlgResult flgSplineTrace(FlgContext context, const FlgSplineTraceDesc* desc, FlgSurfaceCurves* out_curves,
                         FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_curves, "out_curves", out_job);
        const FlgSplineTraceDesc read = read_struct(desc, sized<FlgSplineTraceDesc>(), "desc");
        Submission submission(self, read.job);
        const auto spline = self.splines.get(read.spline.id, "desc.spline");
        if (!spline->manifold->surface)
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "desc.spline is not on the manifold of a mesh");
        submission.read(*spline, "desc.spline");
        submission.read_surface(spline->manifold->surface, "the surface of desc.spline");
        const auto out = self.make(self.surface_curves, spline->manifold->surface);
        check_range(is_coordinate(static_cast<float>(read.offset)), "desc.offset", read.offset,
                    "finite and at most 1e30 in size");
        submission.job().strand.start(trace_spline(submission.pace(), spline, read.offset, out));
        *out_curves = {submission.commit(self.surface_curves, out, out_job)};
    });
}

FlgResult flgSplineSampleDescInit(FlgSplineSampleDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSplineSampleDesc>());
}

FlgResult flgSplineSample(FlgContext context, const FlgSplineSampleDesc* desc, FlgCurveSet* out_set, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        const FlgSplineSampleDesc read = read_struct(desc, sized<FlgSplineSampleDesc>(), "desc");
        check_range(is_coordinate(read.height), "desc.height", read.height, "finite and at most 1e30 in size");
        check_range(read.spacing >= 0 && read.spacing <= 1e30, "desc.spacing", read.spacing, "0 to 1e30");
        Submission submission(self, read.job);
        const auto spline = self.splines.get(read.spline.id, "desc.spline");
        submission.read(*spline, "desc.spline");
        check_range(spline->manifold->given_ambient == 3, "the number of coordinates of desc.spline",
                    spline->manifold->given_ambient, "3");
        const auto out = self.make(self.curve_sets);
        out->origin = spline->origin;
        submission.job().strand.start(spline_curves(submission.pace(), spline, read.height, read.spacing, out));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

FlgResult flgSplineSweepDescInit(FlgSplineSweepDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_ribbon_desc());
}

FlgResult flgSplineSweep(FlgContext context, const FlgSplineSweepDesc* desc, FlgSurface* out_surface, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_surface, "out_surface", out_job);
        Memory* const memory = self.memory[MemoryKind::surfaces];
        const FlgSplineSweepDesc read = read_struct(desc, default_ribbon_desc(), "desc");
        Submission submission(self, read.job);
        const auto spline = self.splines.get(read.spline.id, "desc.spline");
        submission.read(*spline, "desc.spline");
        const RibbonShape shape = read_ribbon(read, *spline->manifold);
        if (shape.conforms) submission.read_surface(spline->manifold->surface, "the surface of desc.spline");
        const auto out = make_object<Surface>(memory, memory, self.memory[MemoryKind::caches]);
        out->origin = spline->origin;
        submission.job().strand.start(make_ribbon(submission.pace(), spline, shape, out));
        *out_surface = {submission.commit(self.surfaces, out, out_job)};
    });
}

FlgResult flgSplineOffsetDescInit(FlgSplineOffsetDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, sized<FlgSplineOffsetDesc>());
}

FlgResult flgSplineOffset(FlgContext context, const FlgSplineOffsetDesc* desc, FlgCurveSet* out_set, FlgJob* out_job) {
    return guarded([&] {
        Context& self = clear_outputs(context, out_set, "out_set", out_job);
        const FlgSplineOffsetDesc read = read_struct(desc, sized<FlgSplineOffsetDesc>(), "desc");
        Submission submission(self, read.job);
        const auto spline = self.splines.get(read.spline.id, "desc.spline");
        submission.read(*spline, "desc.spline");
        const OffsetShape shape = read_offset(read, *spline->manifold);
        const auto out = self.make(self.curve_sets);
        out->origin = spline->origin;
        submission.job().strand.start(offset_spline(submission.pace(), spline, shape, out));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
    });
}

FlgResult flgSplineRelease(FlgContext context, FlgSpline spline) {
    return release(context, &Context::splines, spline, "spline");
}

}  // extern "C"
