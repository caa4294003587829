// SPDX-License-Identifier: MIT
// Splines on meshes of 70,000 triangles: 10 points, 288 free nodes, from scratch and on a surface that was used before.
#include "bench/splines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bench/groups.h"

namespace flg::bench {
namespace {

constexpr double kSurfaceMs = 150, kSplineMs = 10, kChunkUs = 100;
constexpr uint32_t kTriangles = 70'000, kManyTriangles = 270'000;
constexpr int kSplineRuns = 21, kFirstRuns = 5;

struct Chunk {
    float us = 0;
    std::string stage;
};

// Of the manifold and a spline on it.
Chunk max_slice(const MeshArrays& mesh) {
    SplineBench bench(mesh, 0, {sizeof(FlgClock), nullptr, processor_ns});
    Chunk longest;
    const auto finish = [&] {
        FlgFrameReport report{};
        do {
            report = {};
            report.struct_size = sizeof report;
            check(flgContextTick(bench.host().context(), 2000, &report));
            if (report.max_slice_us > longest.us) longest = {report.max_slice_us, report.max_slice_stage};
        } while (report.jobs_pending > 0);
    };
    bench.make_manifold();
    const std::vector<double> points = winding_points();
    FlgSpline spline{};
    const FlgSplineDesc desc = bench.desc(points);
    check(flgSplineCreate(bench.host().context(), &desc, &spline, nullptr));
    finish();
    return longest;
}

std::vector<Row> spline_rows(const MeshArrays& mesh, const std::string& name) {
    SplineBench bench(mesh);
    const std::vector<double> points = winding_points();
    std::vector<double> made, first;
    FlgSplineView view{};
    for (int run = 0; run < kFirstRuns; ++run) {
        made.push_back(bench.make_manifold());
        first.push_back(bench.spline_ms(bench.desc(points), view));
    }
    const double again = median_ms(kSplineRuns, [&] { return bench.spline_ms(bench.desc(points), view); });
    const std::string about = rounds_note(view);
    const Chunk chunk = max_slice(mesh);
    return {
        below(name + ": its smooth surface, once", median(made), "ms", kSurfaceMs,
              std::to_string(mesh.triangles.size() / 3) + " triangles"),
        below(name + ": first spline, M = 288", median(first), "ms", kSplineMs, about),
        below(name + ": spline again, M = 288", again, "ms", kSplineMs, about),
        below(name + ": longest chunk of a spline", chunk.us, "us", kChunkUs, chunk.stage),
    };
}

}  // namespace

std::vector<double> winding_points(double aside) {
    std::vector<double> points;
    for (uint32_t i = 0; i < kSplinePoints; ++i) {
        const double u = 0.6 * i + (i == kSplinePoints / 2 ? aside : 0.0), v = 1.2 * std::sin(2.3 * i);
        const double ring = 1 + 0.4 * std::cos(v);
        points.insert(points.end(), {ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v)});
    }
    return points;
}

uint64_t processor_ns(void*) {
    return static_cast<uint64_t>(thread_ms() * 1e6);
}

std::string rounds_note(const FlgSplineView& view) {
    char text[64];
    std::snprintf(text, sizeof text, "%u rounds, residual %.1e", view.rounds, view.residual);
    return text;
}

SplineBench::SplineBench(const MeshArrays& mesh, uint32_t workers, const FlgClock& clock)
    : host_(flgAllocatorDefaults(), clock, workers) {
    FlgColumn column;
    const FlgMeshView view = mesh.view(column);
    FlgSurfaceDesc desc = flgSurfaceDefaults();
    desc.mesh = &view;
    check(flgSurfaceCreate(host_.context(), &desc, &surface_, nullptr));
    host_.run();
}

double SplineBench::make_manifold() {
    if (manifold_.id != 0) check(flgManifoldRelease(host_.context(), manifold_));
    FlgManifoldFromSurfaceDesc desc = flgManifoldFromSurfaceDefaults();
    desc.surface = surface_;
    desc.smoothing_scale = smoothing_scale_;
    return time_ms([&] {
        check(flgManifoldCreateFromSurface(host_.context(), &desc, &manifold_, nullptr));
        host_.run();
    });
}

FlgSplineDesc SplineBench::desc(const std::vector<double>& points) const {
    FlgSplineDesc desc = flgSplineDefaults();
    desc.manifold = manifold_;
    desc.points = points.data();
    desc.point_count = static_cast<uint32_t>(points.size() / 3);
    desc.node_count = kSplineNodes;
    desc.tolerance = kSplineTolerance;
    return desc;
}

double SplineBench::spline_ms(const FlgSplineDesc& desc, FlgSplineView& view, FlgSpline* keep) {
    FlgSpline spline{};
    FlgJob job{};
    const double ms = time_ms([&] {
        check(flgSplineCreate(host_.context(), &desc, &spline, &job));
        host_.run();
    });
    host_.check_done(job);
    check(flgJobRelease(host_.context(), job));
    view = flgSplineViewDefaults();
    check(flgSplineGetView(host_.context(), spline, &view));
    if (keep) {
        *keep = spline;
    } else {
        check(flgSplineRelease(host_.context(), spline));
    }
    return ms;
}

std::vector<Row> run_splines() {
    std::vector<Row> rows;
    const auto append = [&](const std::vector<Row>& more) { rows.insert(rows.end(), more.begin(), more.end()); };
    const MeshArrays torus = wavy_torus(kTriangles, 0), wavy = wavy_torus(kTriangles, 0.01);
    append(spline_rows(torus, "torus"));
    append(spline_dragging(torus, "torus"));
    append(spline_rows(wavy, "torus in waves of 1 cm"));
    append(spline_dragging(wavy, "torus in waves of 1 cm"));
    append(spline_rows(bumpy_torus(kTriangles), "torus with bumps of 5 cm"));
    append(spline_first(wavy_torus(kManyTriangles, 0.01), "torus in waves, 270k"));
    append(spline_motions());
    append(spline_growth());
    append(spline_strokes());
#if defined(FLG_WITH_REFERENCE)
    append(spline_methods());
    append(spline_obstacles());
#endif
    return rows;
}

}  // namespace flg::bench
