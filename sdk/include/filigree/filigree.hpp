// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The Filigree authors
//
// Filigree for C++17 and later: filigree.h and what belongs to it, with owners instead of handles and exceptions
// instead of results. Header only, and nothing that the C functions don't do; use both side by side (every owner has
// get()).
//
//     filigree::Context context;
//     filigree::CurveSet stroke = context.curves(view);
//     filigree::Style style = context.style(stroke);
//     FlgStylizeDesc desc = flgStylizeDefaults();
//     desc.style = style.get();
//     desc.target = target.get();
//     filigree::CurveSet result = context.stylize(desc);
//     while (!result.ready()) context.tick(2000);   // once a frame
//     draw(result.view());
//
// Owners must not outlive their context.
#ifndef FILIGREE_FILIGREE_HPP
#define FILIGREE_FILIGREE_HPP

#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "filigree.h"
#include "filigree_live.h"
#include "filigree_model.h"
#include "filigree_motion.h"
#include "filigree_project.h"
#include "filigree_skeleton.h"
#include "filigree_spline.h"
#include "filigree_surface.h"
#include "filigree_tangle.h"

namespace filigree {

// What a failing function's FlgResult becomes; what() is flgLastError().
class Error : public std::runtime_error {
public:
    explicit Error(FlgResult result) : std::runtime_error(flgLastError()), result_(result) {}
    // What flgLastError's sentence is about.
    FlgResult result() const noexcept { return result_; }

private:
    FlgResult result_;
};

// Throws Error for failures; true for FLG_OK, false for FLG_NOT_READY.
inline bool check(FlgResult result) {
    if (result < 0) throw Error(result);
    return result == FLG_OK;
}

namespace detail {

// Owns one handle; releases it at its end. Move only.
template <class Handle, FlgResult (*release)(FlgContext, Handle)>
class Owner {
public:
    Owner() = default;
    Owner(FlgContext context, Handle handle) : context_(context), handle_(handle) {}
    Owner(Owner&& other) noexcept : context_(other.context_), handle_(std::exchange(other.handle_, Handle{})) {}
    Owner& operator=(Owner&& other) noexcept {
        std::swap(context_, other.context_);
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~Owner() { reset(); }

    explicit operator bool() const noexcept { return handle_.id != 0; }
    Handle get() const noexcept { return handle_; }
    void reset() noexcept {
        if (handle_.id != 0) release(context_, std::exchange(handle_, Handle{}));
    }

protected:
    FlgContext context_ = nullptr;
    Handle handle_{};
};

// What a job makes and a view shows.
template <class Handle, FlgResult (*release)(FlgContext, Handle), class View, FlgResult (*init)(View*, uint32_t),
          FlgResult (*get)(FlgContext, Handle, View*)>
class Viewed : public Owner<Handle, release> {
public:
    using Owner<Handle, release>::Owner;
    // Throws what its job failed with.
    bool ready() const {
        View view;
        init(&view, static_cast<uint32_t>(sizeof view));
        return check(get(this->context_, this->handle_, &view));
    }
    // Empty until ready.
    View view() const {
        View view;
        init(&view, static_cast<uint32_t>(sizeof view));
        check(get(this->context_, this->handle_, &view));
        return view;
    }
};

}  // namespace detail

class Job : public detail::Owner<FlgJob, flgJobRelease> {
public:
    using Owner::Owner;
    FlgJobStatus status() const {
        FlgJobStatus status{};
        status.struct_size = sizeof status;
        check(flgJobGetStatus(context_, handle_, &status));
        return status;
    }
    // Published, whatever its result.
    bool finished() const { return status().state == FLG_JOB_FINISHED; }
    void cancel() { check(flgJobCancel(context_, handle_)); }
    // Empty until finished.
    std::vector<FlgStageTime> stages() const {
        std::vector<FlgStageTime> stages(16);
        uint32_t count = 0;
        check(flgJobGetStages(context_, handle_, stages.data(), static_cast<uint32_t>(stages.size()), &count));
        stages.resize(count);
        return stages;
    }
};

using CurveSet =
    detail::Viewed<FlgCurveSet, flgCurveSetRelease, FlgCurveSetView, flgCurveSetViewInit, flgCurveSetGetView>;

class Style : public detail::Owner<FlgStyle, flgStyleRelease> {
public:
    using Owner::Owner;
    bool ready() const {
        FlgStyleInfo info{};
        info.struct_size = sizeof info;
        return check(flgStyleGetInfo(context_, handle_, &info));
    }
    // All zero until ready.
    FlgStyleInfo info() const {
        FlgStyleInfo info{};
        info.struct_size = sizeof info;
        check(flgStyleGetInfo(context_, handle_, &info));
        return info;
    }
    CurveSet guide() const {
        FlgCurveSet guide{};
        check(flgStyleGetGuide(context_, handle_, &guide));
        return {context_, guide};
    }
};

// See filigree_surface.h for these three.
class Surface : public detail::Owner<FlgSurface, flgSurfaceRelease> {
public:
    using Owner::Owner;
    // False while it is made or changed.
    bool ready() const {
        FlgSurfaceView view = flgSurfaceViewDefaults();
        return check(flgSurfaceGetView(context_, handle_, &view));
    }
    // Empty unless ready.
    FlgSurfaceView view() const {
        FlgSurfaceView view = flgSurfaceViewDefaults();
        check(flgSurfaceGetView(context_, handle_, &view));
        return view;
    }
    // All zero until it is made.
    FlgSurfaceReport report() const {
        FlgSurfaceReport report{};
        report.struct_size = sizeof report;
        check(flgSurfaceGetReport(context_, handle_, &report));
        return report;
    }
    // Empty unless ready.
    std::vector<uint32_t> changes(uint32_t since_revision) const {
        uint32_t count = 0;
        check(flgSurfaceGetChanges(context_, handle_, since_revision, nullptr, 0, &count));
        std::vector<uint32_t> triangles(count);
        check(flgSurfaceGetChanges(context_, handle_, since_revision, triangles.data(), count, &count));
        return triangles;
    }
};

using Field = detail::Viewed<FlgField, flgFieldRelease, FlgFieldView, flgFieldViewInit, flgFieldGetView>;

using SurfaceCurves = detail::Viewed<FlgSurfaceCurves, flgSurfaceCurvesRelease, FlgSurfaceCurvesView,
                                     flgSurfaceCurvesViewInit, flgSurfaceCurvesGetView>;

// See filigree_spline.h.
using Manifold =
    detail::Viewed<FlgManifold, flgManifoldRelease, FlgManifoldView, flgManifoldViewInit, flgManifoldGetView>;

class Obstacles : public detail::Owner<FlgObstacles, flgObstaclesRelease> {
public:
    using Owner::Owner;
};

// Ready also when a round of it can be seen.
using Spline = detail::Viewed<FlgSpline, flgSplineRelease, FlgSplineView, flgSplineViewInit, flgSplineGetView>;

// See filigree_motion.h.
// Ready also when a round of it can be seen.
using Motion = detail::Viewed<FlgMotion, flgMotionRelease, FlgMotionView, flgMotionViewInit, flgMotionGetView>;

// See filigree_skeleton.h.
class StraightSkeleton : public detail::Owner<FlgStraightSkeleton, flgStraightSkeletonRelease> {
public:
    using Owner::Owner;
    bool ready() const {
        FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
        return check(flgStraightSkeletonGetView(context_, handle_, &view));
    }
    // Empty until ready.
    FlgStraightSkeletonView view() const {
        FlgStraightSkeletonView view = flgStraightSkeletonViewDefaults();
        check(flgStraightSkeletonGetView(context_, handle_, &view));
        return view;
    }
    // The front: what is inside lies to the left of each ring.
    struct Rings {
        std::vector<double> points;     // 2 a point
        std::vector<uint32_t> edges;    // one a point
        std::vector<uint32_t> offsets;  // where each ring begins, and the end; empty until ready
    };
    Rings offset(double distance) const {
        FlgOffsetPolygons polygons = flgOffsetPolygonsDefaults();
        Rings rings;
        if (!check(flgStraightSkeletonOffset(context_, handle_, distance, &polygons))) return rings;
        rings.points.resize(2 * std::size_t{polygons.point_count});
        rings.edges.resize(polygons.point_count);
        rings.offsets.resize(std::size_t{polygons.ring_count} + 1);
        polygons.point_capacity = polygons.point_count;
        polygons.ring_capacity = polygons.ring_count;
        polygons.points = rings.points.data();
        polygons.edges = rings.edges.data();
        polygons.ring_offsets = rings.offsets.data();
        check(flgStraightSkeletonOffset(context_, handle_, distance, &polygons));
        return rings;
    }
};

// See filigree_model.h for these.
using Outline = detail::Viewed<FlgOutline, flgOutlineRelease, FlgOutlineView, flgOutlineViewInit, flgOutlineGetView>;
using Part = detail::Viewed<FlgPart, flgPartRelease, FlgPartView, flgPartViewInit, flgPartGetView>;
using PartMesh =
    detail::Viewed<FlgPartMesh, flgPartMeshRelease, FlgPartMeshView, flgPartMeshViewInit, flgPartMeshGetView>;
using Model = detail::Viewed<FlgModel, flgModelRelease, FlgModelView, flgModelViewInit, flgModelGetView>;
using Skin = detail::Viewed<FlgSkin, flgSkinRelease, FlgSkinView, flgSkinViewInit, flgSkinGetView>;

// See filigree_tangle.h. What it starts are steps, in this order; jobs may be let go of.
class Tangle : public detail::Owner<FlgTangle, flgTangleRelease> {
public:
    using Owner::Owner;
    // All zero while a step is under way.
    FlgTangleInfo info() const {
        FlgTangleInfo info{};
        info.struct_size = sizeof info;
        check(flgTangleGetInfo(context_, handle_, &info));
        return info;
    }
    FlgTangleRegion region(uint32_t region) const {
        FlgTangleRegion out{};
        out.struct_size = sizeof out;
        check(flgTangleGetRegion(context_, handle_, region, &out));
        return out;
    }
    // `desc.tangle` is filled in.
    Job divide(FlgTangleDivideDesc desc) {
        desc.tangle = handle_;
        FlgJob job{};
        check(flgTangleDivide(context_, &desc, &job));
        return {context_, job};
    }
    Job displace(FlgTangleDisplaceDesc desc) {
        desc.tangle = handle_;
        FlgJob job{};
        check(flgTangleDisplace(context_, &desc, &job));
        return {context_, job};
    }
    Job group(const std::vector<uint32_t>& regions) { return change(flgTangleGroup, regions); }
    Job join(const std::vector<uint32_t>& regions) { return change(flgTangleJoin, regions); }
    // Valid until the tangle changes, or it is called again.
    FlgTangleHistory history() const {
        FlgTangleHistory history{};
        history.struct_size = sizeof history;
        check(flgTangleGetHistory(context_, handle_, &history));
        return history;
    }
    Job replay(const FlgTangleHistory& history) {
        FlgJob job{};
        check(flgTangleReplay(context_, handle_, &history, &job));
        return {context_, job};
    }
    Job undo() { return step(flgTangleUndo); }
    Job redo() { return step(flgTangleRedo); }

private:
    template <class Function>
    Job change(Function function, const std::vector<uint32_t>& regions) {
        FlgJob job{};
        check(function(context_, handle_, regions.data(), static_cast<uint32_t>(regions.size()), &job));
        return {context_, job};
    }
    template <class Function>
    Job step(Function function) {
        FlgJob job{};
        check(function(context_, handle_, &job));
        return {context_, job};
    }
};

// See filigree_live.h.
class LiveStroke : public detail::Owner<FlgLiveStroke, flgLiveStrokeRelease> {
public:
    using Owner::Owner;
    // The points that are new; valid until the next call for this stroke.
    FlgCurveSetView push(const FlgLiveSample* samples, uint32_t count) {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        check(flgLiveStrokePush(context_, handle_, samples, count, &view));
        return view;
    }
    FlgCurveSetView points() const {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        check(flgLiveStrokeGetPoints(context_, handle_, &view));
        return view;
    }
    FlgLiveStrokeInfo info() const {
        FlgLiveStrokeInfo info{};
        info.struct_size = sizeof info;
        check(flgLiveStrokeGetInfo(context_, handle_, &info));
        return info;
    }
    // Points left.
    uint32_t undo(uint32_t samples) {
        uint32_t points = 0;
        check(flgLiveStrokeUndo(context_, handle_, samples, &points));
        return points;
    }
    // What is left of a stroke; a job still makes both.
    struct Ended {
        CurveSet stylized;  // all its points
        CurveSet samples;   // as pushed: a style's example, or a target
    };
    Ended end(Job* out_job = nullptr) {
        FlgCurveSet stylized{}, samples{};
        FlgJob job{};
        check(flgLiveStrokeEnd(context_, handle_, nullptr, &stylized, &samples, out_job ? &job : nullptr));
        if (out_job) *out_job = Job(context_, job);
        return {CurveSet(context_, stylized), CurveSet(context_, samples)};
    }
    // False while a job still reads the stroke.
    bool resume() { return check(flgLiveStrokeResume(context_, handle_)); }
};

// Makes everything else, and must outlive it.
class Context {
public:
    explicit Context(const FlgContextDesc& desc = flgContextDefaults()) { check(flgContextCreate(&desc, &context_)); }
    Context(Context&& other) noexcept : context_(std::exchange(other.context_, nullptr)) {}
    Context& operator=(Context&& other) noexcept {
        std::swap(context_, other.context_);
        return *this;
    }
    // With a host's job system it waits until that has let go of our tasks.
    ~Context() {
        while (flgContextDestroy(context_) == FLG_NOT_READY) std::this_thread::yield();
    }

    FlgContext get() const noexcept { return context_; }

    // Once a frame, see flgTick.
    FlgFrameReport tick(uint32_t budget_us) {
        FlgFrameReport report{};
        report.struct_size = sizeof report;
        check(flgTick(context_, budget_us, &report));
        return report;
    }
    // Ticks until no job is left: for tools, not for frames.
    void finish() { check(flgContextRun(context_, nullptr, 0, 1e9)); }

    CurveSet curves(const FlgCurveSetView& view) {
        FlgCurveSet set{};
        check(flgCurveSetCreate(context_, &view, &set));
        return {context_, set};
    }
    // One curve through points of three floats each.
    CurveSet curve(const float* points, uint32_t count, bool closed = false) {
        FlgCurveSet set{};
        check(flgCurveSetCreateFromPoints(context_, points, count, closed ? FLG_CURVE_CLOSED : 0, &set));
        return {context_, set};
    }
    // Likewise, from a vector.
    CurveSet curve(const std::vector<float>& points, bool closed = false) {
        return curve(points.data(), static_cast<uint32_t>(points.size() / 3), closed);
    }
    CurveSet resample(const FlgResampleDesc& desc, Job* out_job = nullptr) {
        return start<CurveSet, FlgCurveSet>(flgResample, desc, out_job);
    }
    Style style(const FlgStyleDesc& desc, Job* out_job = nullptr) {
        return start<Style, FlgStyle>(flgStyleCreate, desc, out_job);
    }
    // With all defaults.
    Style style(const CurveSet& example) {
        FlgStyleDesc desc = flgStyleDefaults();
        desc.style = example.get();
        return style(desc);
    }
    CurveSet stylize(const FlgStylizeDesc& desc, Job* out_job = nullptr) {
        return start<CurveSet, FlgCurveSet>(flgStylize, desc, out_job);
    }
    // With all defaults.
    CurveSet stylize(const Style& style, const CurveSet& target, Job* out_job = nullptr) {
        FlgStylizeDesc desc = flgStylizeDefaults();
        desc.style = style.get();
        desc.target = target.get();
        return stylize(desc, out_job);
    }
    Surface surface(const FlgSurfaceDesc& desc, Job* out_job = nullptr) {
        return start<Surface, FlgSurface>(flgSurfaceCreate, desc, out_job);
    }
    // Plain arrays, all defaults: 3 floats a vertex, 3 vertices a triangle.
    Surface surface(const std::vector<float>& positions, const std::vector<uint32_t>& triangles,
                    Job* out_job = nullptr) {
        FlgSurface surface{};
        FlgJob job{};
        check(flgSurfaceCreateFromTriangles(context_, positions.data(), static_cast<uint32_t>(positions.size() / 3),
                                            triangles.data(), static_cast<uint32_t>(triangles.size() / 3), &surface,
                                            out_job ? &job : nullptr));
        if (out_job) *out_job = Job(context_, job);
        return {context_, surface};
    }
    Surface refine(const FlgRefineDesc& desc, Job* out_job = nullptr) {
        return start<Surface, FlgSurface>(flgSurfaceRefine, desc, out_job);
    }
    Field geodesic(const FlgGeodesicDesc& desc, Job* out_job = nullptr) {
        return start<Field, FlgField>(flgGeodesic, desc, out_job);
    }
    Field blend(const FlgBlendDesc& desc, Job* out_job = nullptr) {
        return start<Field, FlgField>(flgFieldBlend, desc, out_job);
    }
    Field sample(const FlgSamplingDesc& desc, Job* out_job = nullptr) {
        return start<Field, FlgField>(flgSurfaceSample, desc, out_job);
    }
    SurfaceCurves sample_border(const FlgBorderSamplingDesc& desc, Job* out_job = nullptr) {
        return start<SurfaceCurves, FlgSurfaceCurves>(flgBorderSample, desc, out_job);
    }
    SurfaceCurves isolines(const FlgIsolinesDesc& desc, Job* out_job = nullptr) {
        return start<SurfaceCurves, FlgSurfaceCurves>(flgTraceIsolines, desc, out_job);
    }
    SurfaceCurves streams(const FlgStreamsDesc& desc, Job* out_job = nullptr) {
        return start<SurfaceCurves, FlgSurfaceCurves>(flgTraceStreams, desc, out_job);
    }
    SurfaceCurves paths(const FlgPathsDesc& desc, Job* out_job = nullptr) {
        return start<SurfaceCurves, FlgSurfaceCurves>(flgTracePaths, desc, out_job);
    }
    SurfaceCurves project(const FlgProjectDesc& desc, Job* out_job = nullptr) {
        return start<SurfaceCurves, FlgSurfaceCurves>(flgProjectCurves, desc, out_job);
    }
    CurveSet lift(const FlgLiftDesc& desc, Job* out_job = nullptr) {
        return start<CurveSet, FlgCurveSet>(flgLiftCurves, desc, out_job);
    }
    // The field on the cut surface.
    Field cut(const FlgCutIsolinesDesc& desc, Job* out_job = nullptr) {
        return start<Field, FlgField>(flgCutIsolines, desc, out_job);
    }
    Job cut(const FlgCutCurvesDesc& desc) {
        FlgJob job{};
        check(flgCutCurves(context_, &desc, &job));
        return {context_, job};
    }
    StraightSkeleton straight_skeleton(const FlgStraightSkeletonDesc& desc, Job* out_job = nullptr) {
        return start<StraightSkeleton, FlgStraightSkeleton>(flgStraightSkeletonCreate, desc, out_job);
    }
    Outline outline(const FlgOutlineDesc& desc, Job* out_job = nullptr) {
        return start<Outline, FlgOutline>(flgOutlineCreate, desc, out_job);
    }
    Part part(const FlgPartDesc& desc, Job* out_job = nullptr) {
        return start<Part, FlgPart>(flgPartCreate, desc, out_job);
    }
    PartMesh part_mesh(const FlgPartMeshDesc& desc, Job* out_job = nullptr) {
        return start<PartMesh, FlgPartMesh>(flgPartMeshCreate, desc, out_job);
    }
    Model model(const FlgModelDesc& desc, Job* out_job = nullptr) {
        return start<Model, FlgModel>(flgModelCreate, desc, out_job);
    }
    Skin skin(const FlgSkinDesc& desc, Job* out_job = nullptr) {
        return start<Skin, FlgSkin>(flgSkinCreate, desc, out_job);
    }
    Manifold manifold(const FlgShapeDesc& desc) {
        FlgManifold manifold{};
        check(flgManifoldCreateShape(context_, &desc, &manifold));
        return {context_, manifold};
    }
    Manifold manifold(const FlgMeshManifoldDesc& desc, Job* out_job = nullptr) {
        return start<Manifold, FlgManifold>(flgManifoldCreateFromSurface, desc, out_job);
    }
    Manifold manifold(const FlgCloudManifoldDesc& desc, Job* out_job = nullptr) {
        return start<Manifold, FlgManifold>(flgManifoldCreateFromPoints, desc, out_job);
    }
    Manifold manifold(const FlgGridManifoldDesc& desc, Job* out_job = nullptr) {
        return start<Manifold, FlgManifold>(flgManifoldCreateFromGrid, desc, out_job);
    }
    Obstacles obstacles(const FlgObstaclesDesc& desc, Job* out_job = nullptr) {
        return start<Obstacles, FlgObstacles>(flgObstaclesCreate, desc, out_job);
    }
    Spline spline(const FlgSplineDesc& desc, Job* out_job = nullptr) {
        return start<Spline, FlgSpline>(flgSplineCreate, desc, out_job);
    }
    CurveSet curves(const FlgSplineCurvesDesc& desc, Job* out_job = nullptr) {
        return start<CurveSet, FlgCurveSet>(flgSplineCurves, desc, out_job);
    }
    Motion motion(const FlgMotionDesc& desc, Job* out_job = nullptr) {
        return start<Motion, FlgMotion>(flgMotionCreate, desc, out_job);
    }
    Tangle tangle(const Surface& surface) {
        FlgTangle tangle{};
        check(flgTangleCreate(context_, surface.get(), &tangle, nullptr));
        return {context_, tangle};
    }
    // So that live strokes can begin with it.
    Job warm(const Style& style, float temperature = 0.0f) {
        FlgJob job{};
        check(flgStyleWarm(context_, style.get(), temperature, nullptr, &job));
        return {context_, job};
    }
    // Empty while the style is not ready or not warm.
    LiveStroke begin(const FlgLiveStrokeDesc& desc) {
        FlgLiveStroke stroke{};
        check(flgLiveStrokeBegin(context_, &desc, &stroke));
        return {context_, stroke};
    }

private:
    template <class Owner, class Handle, class Function, class Desc>
    Owner start(Function function, const Desc& desc, Job* out_job) {
        Handle made{};
        FlgJob job{};
        check(function(context_, &desc, &made, out_job ? &job : nullptr));
        if (out_job) *out_job = Job(context_, job);
        return {context_, made};
    }

    FlgContext context_ = nullptr;
};

}  // namespace filigree

#endif
