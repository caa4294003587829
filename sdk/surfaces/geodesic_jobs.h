// SPDX-License-Identifier: MIT
// The jobs that compute distances on surfaces.
#pragma once

#include <deque>

#include "surfaces/field.h"
#include "surfaces/geodesics/perturbed_metric.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/traced_curves.h"

namespace flg {

// Builds what a surface's solvers work on, once. A job of its own, so that those that need it wait for it and go on
// side by side. If memory runs out it makes nothing and does not fail: those that need it say so, see blocks_of().
Task<void> build_blocks(Pace& pace, std::shared_ptr<Surface> surface);

// What was built. Fails with FLG_ERROR_OUT_OF_MEMORY if memory ran out then, or when it followed a cut.
const GeodesicBlocks& blocks_of(const Surface& surface);

struct GeodesicSources {
    Buffer<uint32_t> vertices;
    Buffer<SurfacePoint> points;
    std::shared_ptr<const TracedCurves> curves;  // or null
    Buffer<uint32_t> border_regions;
    const std::pmr::deque<Corner>* edges = nullptr;  // outlives the job
    bool edges_apart = false;                        // each edge is a source; else they are one together
};

struct GeodesicRequest {
    std::shared_ptr<Surface> surface;
    GeodesicSources sources;
    RegionSet regions;
    float max_distance;
    Buffer<uint32_t> targets;
    bool labelled;
    Perturbation perturbation;
    // By exact_solver.h, unperturbed: some hundred times as long.
    bool exact = false;
    // Of small regions the field may be local: to their vertices and the ring of triangles around them.
    bool may_be_local = false;
};

// The whole of flgFieldCreateGeodesic. Fails if a source or a target names what does not exist.
Task<void> solve_geodesic(Pace& pace, GeodesicRequest request, std::shared_ptr<Field> out);

// Its field, wherever that is kept.
Task<void> solve_field(Pace& pace, const GeodesicRequest& request, DistanceField& out);

// Distances from one point, right at least on the way to another: what paths between them are traced on. The surface's
// blocks are built.
Task<void> solve_between(Pace& pace, Surface& surface, const RegionSet& regions, SurfacePoint source,
                         SurfacePoint target, DistanceField& out);

// The whole of flgFieldBlend.
Task<void> blend_fields(Pace& pace, std::shared_ptr<const Field> from, std::shared_ptr<const Field> to,
                        std::shared_ptr<Field> out);

}  // namespace flg
