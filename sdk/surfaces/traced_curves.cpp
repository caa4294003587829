// SPDX-License-Identifier: MIT
#include "surfaces/traced_curves.h"

namespace flg {

FlattenCurvesKernel::FlattenCurvesKernel(TracedCurves& traced, Memory* memory) : traced_(traced) {
    const uint32_t curves = traced.curves.curve_count();
    traced.flat = {.points = Buffer<FlgSurfacePoint>(traced.curves.points.size(), memory),
                   .offsets = Buffer<uint32_t>(size_t{curves} + 1, memory),
                   .flags = Buffer<uint8_t>(curves, memory),
                   .values = Buffer<float>(curves, memory)};
    traced.flat.offsets[0] = 0;
}

bool FlattenCurvesKernel::run(uint32_t count) {
    const SurfaceCurves& curves = traced_.curves;
    TracedCurves::Flat& flat = traced_.flat;
    for (; count > 0 && points_ < curves.points.size(); --count, ++points_) {
        const SurfacePoint& point = curves.points[points_];
        flat.points[points_] = {point.triangle, point.u, point.v};
    }
    for (; count > 0 && curves_ < curves.curve_count(); --count, ++curves_) {
        flat.offsets[curves_ + 1] = curves.offsets[curves_ + 1];
        flat.flags[curves_] = curves.closed[curves_] ? FLG_CURVE_CLOSED : 0;
        flat.values[curves_] = curves.values[curves_];
    }
    return points_ == curves.points.size() && curves_ == curves.curve_count();
}

}  // namespace flg
