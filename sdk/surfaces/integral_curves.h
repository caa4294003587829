// SPDX-License-Identifier: MIT
// Integral curves of a field's gradient: the lines of the stream operator and the first guess of geodesic paths, sec. 3.3
// and 4.2 (Line tracing) of Nazzaro, Puppo, Pellacini: geoTangle (2021).
//
// Invariants
// - The value rises strictly from point to point (uphill; falls if downhill), in double arithmetic and whatever the
//   rounding: a curve never returns and always ends. Only plateaus are crossed level (below).
// - Straight in each triangle along its gradient; along an edge where the gradients of both sides lead to it; at a vertex
//   along the steepest edge or triangle of its fan. integral_curve_step.h takes these steps.
// - Where nothing near is higher, but vertices of exactly this value lie around (flat triangles, level ridges), the curve
//   goes along edges between them to the nearest, by edges, that has something higher or is a target; among at most plateau_limit.
#pragma once

#include <optional>

#include "surfaces/integral_curve_step.h"
#include "surfaces/surface_curves.h"

namespace flg {

struct IntegralCurveOptions {
    bool downhill = false;
    std::optional<float> level;         // curves end where they reach this value
    std::span<const uint32_t> targets;  // and at these vertices; rising
    // What happens where a curve reaches the border of the mesh, of the regions or of the finite values. false: it ends.
    // true: it goes on along the border as long as that leads further.
    bool along_borders = false;
};

enum class IntegralCurveStop : uint8_t {
    level,
    target,
    border,    // also if the start lies outside, or at a border where the field would rise beyond it
    extremum,  // nothing near is higher
};

struct IntegralCurveEnd {
    IntegralCurveStop stop;
    uint32_t curve;  // of `out`; no_index if the start is also the end
};

class IntegralCurveKernel {
public:
    static constexpr uint32_t plateau_limit = 128;

    // `values`: one a vertex, linear in each triangle; triangles with one that is not finite are outside. Starts are
    // moved by less than 1e-6 of their triangle onto an edge or a vertex that is so near. Appends to `out`, values being
    // those at the end of the curves. All must outlive the run.
    IntegralCurveKernel(const Mesh& mesh, std::span<const float> values, const RegionSet& regions,
                        std::span<const SurfacePoint> starts, const IntegralCurveOptions& options, SurfaceCurves& out,
                        Memory* memory);

    // Spends `count` units of about 100 ns, a triangle each; true when done.
    bool run(uint32_t count);
    // One a start.
    const std::pmr::deque<IntegralCurveEnd>& ends() const { return ends_; }

private:
    struct PlateauVertex {
        uint32_t vertex;
        uint32_t from;      // index of the one before it
        uint32_t triangle;  // that holds both
    };

    void begin_curve();
    void end_curve(IntegralCurveStop stop);
    void arrive();
    bool is_target(uint32_t vertex) const;
    uint32_t advance();
    void move_to(uint32_t triangle, const SurfacePlace& to);
    void begin_plateau(IntegralCurveStop if_none);
    uint32_t search_plateau();
    void add_to_plateau(uint32_t vertex, uint32_t from, uint32_t triangle);
    void cross_plateau(uint32_t last);

    const SlopedField field_;
    const std::span<const SurfacePoint> starts_;
    const IntegralCurveOptions options_;
    const double end_height_;
    SurfaceCurves& out_;
    std::pmr::deque<IntegralCurveEnd> ends_;
    bool tracing_ = false;
    SurfacePlace place_{};
    bool may_leave_border_ = true;  // at the start of a curve and after a plateau
    uint32_t last_triangle_ = no_index;
    std::pmr::vector<PlateauVertex> plateau_;  // not empty while searched
    uint32_t plateau_at_ = 0;
    IntegralCurveStop if_no_way_{};
};

}  // namespace flg
