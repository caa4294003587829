// SPDX-License-Identifier: MIT
#include "surfaces/lift_curves.h"

#include "core/failure.h"
#include "runtime/each.h"
#include "surfaces/mesh/mesh_measures.h"

namespace flg {

Task<void> lift_curves(Pace& pace, std::shared_ptr<const TracedCurves> traced, float height,
                       std::shared_ptr<CurveSet> out) {
    const SurfaceCurves& curves = traced->curves;
    const Mesh& mesh = traced->surface->mesh();
    if (curves.curve_count() == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "there are no curves to lift");
    pace.stage("lift");
    out->allocate_curves(curves.curve_count());
    out->offsets()[0] = 0;
    co_await each(pace, curves.curve_count(), Cost::some_ns, [&](uint32_t c) {
        out->offsets()[c + 1] = curves.offsets[c + 1];
        out->begin_curve(c, curves.closed[c] ? FLG_CURVE_CLOSED : 0);
    });
    out->allocate_columns({{{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_NORMAL, 3}}, pace.memory()});
    float* positions = out->find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* frames = out->find(FLG_ATTRIBUTE_NORMAL)->values.data();
    co_await each(pace, curves.points.size(), Cost::microseconds, [&](uint32_t p) {
        const Vec3 normal = smooth_normal(mesh, curves.points[p]);
        store_vec3(position_of(mesh, curves.points[p]) + height * normal, positions + size_t{3} * p);
        store_vec3(normal, frames + size_t{3} * p);
    });
    co_await each(pace, curves.curve_count(), Cost::some_ns, [&](uint32_t c) { out->complete_curve(c); });
}

}  // namespace flg
