// SPDX-License-Identifier: MIT
// Splines for measurements: a mesh, points on it, and what a spline through them costs.
#pragma once

#include <string>

#include "bench/bench.h"
#include "bench/host.h"
#include "bench/meshes.h"
#include "filigree/filigree_motion.h"

namespace flg::bench {

constexpr uint32_t kSplinePoints = 10, kSplineNodes = 298;  // 288 of them free
constexpr double kSplineTolerance = 1e-4;

// So many points that wind around bench/meshes.h's tori, about on them; the point that is dragged is `aside` off.
std::vector<double> winding_points(double aside = 0);

// On the smooth surface of a mesh.
class SplineBench {
public:
    explicit SplineBench(const MeshArrays& mesh, uint32_t workers = 0, const FlgClock& clock = flgClockDefaults());

    Host& host() { return host_; }
    // Makes the manifold anew, which then remembers nothing; processor ms.
    double make_manifold();
    FlgSplineDesc desc(const std::vector<double>& points) const;
    // The manifold's surface is seen through this scale from the next one on, metres.
    void see_through(double smoothing_scale) { smoothing_scale_ = smoothing_scale; }
    // Asks for it, runs it to its end, releases it unless it is to be kept; processor ms.
    double spline_ms(const FlgSplineDesc& desc, FlgSplineView& out_view, FlgSpline* keep = nullptr);

private:
    Host host_;
    FlgSurface surface_ = {};
    FlgManifold manifold_ = {};
    double smoothing_scale_ = 0;
};

// "5 rounds, residual 2e-05".
std::string rounds_note(const FlgSplineView& view);

// Processor time of this thread, as a clock for contexts: what else the machine does is left out.
uint64_t processor_ns(void* unused);

// Rows of other files.
std::vector<Row> spline_dragging(const MeshArrays& mesh, const std::string& name);
std::vector<Row> spline_first(const MeshArrays& mesh, const std::string& name);
std::vector<Row> spline_motions();
std::vector<Row> spline_growth();
std::vector<Row> spline_strokes();
#if defined(FLG_WITH_REFERENCE)
std::vector<Row> spline_methods();
std::vector<Row> spline_obstacles();
#endif

}  // namespace flg::bench
