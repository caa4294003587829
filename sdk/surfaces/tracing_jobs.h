// SPDX-License-Identifier: MIT
// The jobs that trace curves on surfaces.
#pragma once

#include "surfaces/field_levels.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/traced_curves.h"

namespace flg {

// The whole of flgFieldTraceIsolines.
Task<void> trace_isolines(Pace& pace, std::shared_ptr<const Field> field, RegionSet regions, LevelRequest levels,
                          std::shared_ptr<TracedCurves> out);

struct StreamsRequest {
    std::shared_ptr<const Field> field;
    RegionSet regions;
    Buffer<SurfacePoint> starts;
    std::shared_ptr<const TracedCurves> further_starts;  // or null
    FlgFieldTraceStreamsDesc desc;                       // checked; its handles are resolved above, its arrays copied
    std::shared_ptr<TracedCurves> out;
};

// The whole of flgFieldTraceStreams. Fails if a start names a triangle that does not exist.
Task<void> trace_streams(Pace& pace, StreamsRequest request);

struct Paths {
    Buffer<uint32_t> offsets;  // path p goes through points offsets[p] to offsets[p + 1] - 1, two at least
    Buffer<SurfacePoint> points;
    bool closed;
    RegionSet regions;
};

// The whole of flgFieldTracePaths. Fails if a point does not exist or can't be reached from the one before it. Paths
// without length are left out.
Task<void> trace_paths(Pace& pace, Paths paths, std::shared_ptr<TracedCurves> out);

// Its curves, wherever they are kept. `argument`: what errors call the points.
Task<void> trace_polylines(Pace& pace, Surface& surface, const Paths& paths, const char* argument, SurfaceCurves& out);

}  // namespace flg
