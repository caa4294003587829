// SPDX-License-Identifier: MIT
// What operators begin at: arbitrary unions of borders, parts of them, points, Poisson samples and lines, sec. 3.3 and 3.4 of
// Nazzaro, Puppo, Pellacini: geoTangle (2021).
#pragma once

#include "filigree/filigree_tangle.h"
#include "surfaces/border_sampling.h"
#include "surfaces/geodesic_jobs.h"
#include "tangles/region_tree.h"
#include "tangles/seed_anchors.h"

namespace flg {

struct TangleSeeds {
    explicit TangleSeeds(Memory* memory) : stretches(memory), regions(memory) {}

    FlgTangleBorders borders = FLG_TANGLE_BORDERS_NONE;
    std::pmr::vector<BorderStretch> stretches;  // of the outer borders
    bool other_loops = false;                   // the outer borders but the first
    Buffer<SurfacePoint> points;
    std::shared_ptr<const TracedCurves> curves;  // or null
    float sample_radius = 0;                     // metres; 0: no samples
    uint32_t sample_count = 0;                   // at most
    float border_spacing = 0;                    // metres; 0: no points along the outer borders
    uint64_t seed = 1;
    std::pmr::vector<RegionId> regions;  // whose borders, and where to sample; empty: those of the operator
    SeedAnchors* anchors = nullptr;      // what to find again, or else to remember; null: nothing

    bool empty() const {
        return borders == FLG_TANGLE_BORDERS_NONE && stretches.empty() && points.empty() && !curves &&
               sample_radius == 0 && border_spacing == 0 && !other_loops;
    }
};

// Leaves of a tangle, as labels.
struct LeafSet {
    explicit LeafSet(Memory* memory) : set(memory), list(memory) {}

    RegionSet set;
    std::pmr::vector<RegionId> list;  // rising
};

// The leaves below regions. Fails if one does not exist; `argument` is what errors call the list.
Task<LeafSet> list_leaves(Pace& pace, const RegionTree& tree, const std::pmr::vector<RegionId>& regions,
                          const char* argument);

// Sources for solve_field. `edges` and `points` hold what the seeds turn out to be, and outlive the sources.
struct SeedPlaces {
    explicit SeedPlaces(Memory* memory) : edges(memory) {}
    std::pmr::deque<Corner> edges;
};

// `leaves`: those of the seeds' regions. `argument` is what errors call the seeds. Fails if borders are asked for where there
// are none, or if a stretch names a loop that does not exist. Where no sample fits there may be no sources.
Task<GeodesicSources> find_sources(Pace& pace, Surface& surface, const RegionSet& leaves, const TangleSeeds& seeds,
                                   const char* argument, SeedPlaces& places);

// Distances within `leaves` from the seeds, whose regions are their own or, if they have none, the leaves.
Task<void> solve_seeds(Pace& pace, const RegionTree& tree, const std::shared_ptr<Surface>& surface,
                       const LeafSet& leaves, const TangleSeeds& seeds, const char* argument, Perturbation perturbation,
                       bool labelled, DistanceField& field);

// Where streams begin: evenly along the seeds' loops, stretches and lines, in their order, about `spacing` metres apart.
Task<Buffer<SurfacePoint>> find_stream_starts(Pace& pace, Surface& surface, const RegionSet& leaves,
                                              const TangleSeeds& seeds, float spacing, const char* argument);

}  // namespace flg
