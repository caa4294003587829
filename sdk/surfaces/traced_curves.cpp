// SPDX-License-Identifier: MIT
#include "surfaces/traced_curves.h"

#include "runtime/each.h"

namespace flg {

Task<void> flatten_curves(Pace& pace, TracedCurves& traced) {
    const SurfaceCurves& curves = traced.curves;
    TracedCurves::Flat& flat = traced.flat;
    const uint32_t count = curves.curve_count();
    flat.points = Buffer<FlgSurfacePoint>(curves.points.size(), pace.memory());
    flat.offsets = Buffer<uint32_t>(size_t{count} + 1, pace.memory());
    flat.flags = Buffer<uint8_t>(count, pace.memory());
    flat.values = Buffer<float>(count, pace.memory());
    co_await each(pace, curves.points.size(), Cost::some_ns, [&](uint32_t i) {
        const SurfacePoint& point = curves.points[i];
        flat.points[i] = {point.triangle, point.u, point.v};
    });
    flat.offsets[0] = 0;
    co_await each(pace, count, Cost::some_ns, [&](uint32_t c) {
        flat.offsets[c + 1] = curves.offsets[c + 1];
        flat.flags[c] = curves.closed[c] ? FLG_CURVE_CLOSED : 0;
        flat.values[c] = curves.values[c];
    });
}

}  // namespace flg
