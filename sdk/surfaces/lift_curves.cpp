// SPDX-License-Identifier: MIT
#include "surfaces/lift_curves.h"

#include "core/failure.h"
#include "surfaces/mesh_measures_normals.h"

namespace flg {

namespace {

constexpr uint32_t curve_chunk = 1000;
constexpr uint32_t point_chunk = 10;  // about 10 us

}  // namespace

Task<void> lift_curves(Pace& pace, std::shared_ptr<const TracedCurves> traced, float height,
                       std::shared_ptr<CurveSet> out) {
    const SurfaceCurves& curves = traced->curves;
    const Mesh& mesh = traced->surface->mesh();
    if (curves.curve_count() == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "there are no curves to lift");
    pace.stage("lift");
    out->allocate_curves(curves.curve_count());
    out->offsets()[0] = 0;
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
        out->offsets()[c + 1] = curves.offsets[c + 1];
        out->begin_curve(c, curves.closed[c] ? FLG_CURVE_CLOSED : 0);
        if (c % curve_chunk == 0) co_await pace;
    }
    out->allocate_columns({{{FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_NORMAL, 3}}, pace.memory()});
    float* positions = out->find(FLG_ATTRIBUTE_POSITION)->values.data();
    float* frames = out->find(FLG_ATTRIBUTE_NORMAL)->values.data();
    for (size_t p = 0; p < curves.points.size(); ++p) {
        const Vec3 normal = smooth_normal(mesh, curves.points[p]);
        store_vec3(position_of(mesh, curves.points[p]) + height * normal, positions + 3 * p);
        store_vec3(normal, frames + 3 * p);
        if (p % point_chunk == 0) co_await pace;
    }
    for (uint32_t c = 0; c < curves.curve_count(); ++c) {
        out->complete_curve(c);
        if (c % curve_chunk == 0) co_await pace;
    }
}

}  // namespace flg
