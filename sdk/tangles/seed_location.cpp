// SPDX-License-Identifier: MIT
#include "tangles/seed_location.h"

#include "runtime/each.h"
#include "surfaces/curves_in_space.h"

namespace flg {

namespace {

// Units of NearestPoints between two looks at the pace.
constexpr auto search_units = static_cast<uint32_t>(Cost::tens_of_ns);

Task<void> locate_curves(Pace& pace, NearestPoints& nearest, const Buffer<Position>& points, const TracedCurves& traced,
                         TracedCurves& out) {
    SurfaceCurves located(pace.memory());
    const CurvesInSpace curves{.offsets = {traced.flat.offsets.data(), traced.flat.offsets.size()},
                               .flags = {traced.flat.flags.data(), traced.flat.flags.size()},
                               .positions = points[0].data()};
    co_await lay_curves(pace, *out.surface, nearest, curves, "curves", located);
    out.curves = std::move(located);
}

bool has_places(const SeedAnchors& anchors) {
    return anchors.given && (!anchors.points.empty() || !anchors.samples.empty() || anchors.given_curves);
}

Task<void> locate_in(Pace& pace, NearestPoints& nearest, TangleSeeds& seeds, SeedAnchors& anchors) {
    if (!anchors.given) co_return;
    if (!anchors.points.empty()) seeds.points = co_await locate(pace, nearest, anchors.points);
    anchors.sample_points = co_await locate(pace, nearest, anchors.samples);
    if (anchors.given_curves) {
        co_await locate_curves(pace, nearest, anchors.curve_points, *anchors.given_curves, *anchors.located_curves);
        seeds.curves = anchors.located_curves;
    }
}

}  // namespace

Task<Buffer<SurfacePoint>> locate(Pace& pace, NearestPoints& nearest, const Buffer<Position>& places) {
    // A search takes some 10 us, but more where many triangles are nearly as near: each is sliced by itself.
    Buffer<SurfacePoint> found(places.size(), pace.memory());
    for (size_t i = 0; i < places.size(); ++i) {
        nearest.begin(places[i]);
        while (!nearest.find(search_units)) co_await pace;
        found[i] = nearest.found();
        co_await pace;
    }
    co_return found;
}

Task<void> locate_seeds(Pace& pace, const Mesh& mesh, StepRecord& record) {
    if (!has_places(record.a) && !has_places(record.b)) co_return;
    pace.stage("locate");
    NearestPoints nearest(mesh);
    co_await build(pace, nearest);
    auto& divide = std::get<DivideRequest>(record.request);
    co_await locate_in(pace, nearest, divide.a, record.a);
    co_await locate_in(pace, nearest, divide.b, record.b);
}

}  // namespace flg
