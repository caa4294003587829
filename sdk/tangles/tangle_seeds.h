// SPDX-License-Identifier: MIT
// What operators begin at: arbitrary unions of borders, parts of them, points, Poisson samples and lines, sec. 3.3 and
// 3.4 of Nazzaro, Puppo, Pellacini: geoTangle (2021).
//
// Anchors are positions of the seeds in space. They find the seeds again on another mesh of the same shape, whose
// triangles, borders and samples have other numbers.
#pragma once

#include "filigree/filigree_tangle.h"
#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/geodesic_jobs.h"
#include "surfaces/mesh/region_loops.h"
#include "surfaces/sampling/border_sampling.h"
#include "surfaces/traced_curves.h"
#include "tangles/region_tree.h"

namespace flg {

struct SeedAnchors {
    // Of the seeds' points, and of the points of their curves.
    Buffer<Position> points, curve_points;
    // Of the first vertices of the outer borders, in their order; empty: they were not asked for.
    Buffer<Position> loops;
    // Of the samples, in the order they were chosen.
    Buffer<Position> samples;
    // They are a history's; and of another mesh: points, curves, samples and borders are where these say, and these
    // stay as they are, so that they lead to the same bits again.
    bool known = false, given = false;
    std::shared_ptr<TracedCurves> given_curves;    // of the history, or null
    std::shared_ptr<TracedCurves> located_curves;  // for what they are on this mesh
    Buffer<SurfacePoint> sample_points;
};

Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<SurfacePoint>& points);
Task<Buffer<Position>> positions_of(Pace& pace, const Mesh& mesh, const Buffer<uint32_t>& vertices);

// Gives loops the order and beginnings that are given, each the nearest of those that are left; or remembers what they
// are. Cost: where they are given, some ns for each edge and anchor.
Task<void> anchor_loops(Pace& pace, const Mesh& mesh, RegionLoops& loops, SeedAnchors& anchors);

struct TangleSeeds {
    explicit TangleSeeds(Memory* memory) : stretches(memory), regions(memory) {}

    FlgTangleBorders borders = FLG_TANGLE_BORDERS_NONE;
    std::pmr::vector<BorderStretch> stretches;  // of the outer borders
    // The outer borders that lead, or all others. One leads; no_index: the longest of each piece that has two.
    enum class Loops : uint8_t { none, leading, others } loops = Loops::none;
    uint32_t first_loop = no_index;
    Buffer<SurfacePoint> points;
    std::shared_ptr<const TracedCurves> curves;  // or null
    float sample_radius = 0;                     // metres; 0: no samples
    uint32_t sample_count = 0;                   // at most
    bool samples_fit = false;                    // the radius is at most 1.5 times the largest distance from a border
    float border_spacing = 0;                    // metres; 0: no points along the outer borders
    uint64_t seed = 1;
    std::pmr::vector<RegionId> regions;  // whose borders, and where to sample; empty: those of the operator
    SeedAnchors* anchors = nullptr;      // what to find again, or else to remember; null: nothing

    bool empty() const {
        return borders == FLG_TANGLE_BORDERS_NONE && stretches.empty() && points.empty() && !curves &&
               sample_radius == 0 && border_spacing == 0 && loops == Loops::none;
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

// The outer borders of leaves; where the seeds ask for that, those that lead come first. Fails if there is none.
struct SeedLoops {
    RegionLoops loops;
    uint32_t leading = 0;
};
Task<SeedLoops> find_loops(Pace& pace, const Mesh& mesh, const RegionSet& leaves, const TangleSeeds& seeds,
                           const char* argument);

// The stretches asked for, or whole loops: those that lead, the others, or all. Fails if one names a loop that does not
// exist.
Task<Buffer<BorderStretch>> choose_stretches(Pace& pace, const SeedLoops& found, const TangleSeeds& seeds,
                                             const char* argument);

// Sources for solve_field. `edges` and `points` hold what the seeds turn out to be, and outlive the sources.
struct SeedPlaces {
    explicit SeedPlaces(Memory* memory) : edges(memory) {}
    std::pmr::deque<Corner> edges;
};

// `leaves`: those of the seeds' regions. `argument` is what errors call the seeds. Fails if borders are asked for where
// there are none, or if a stretch names a loop that does not exist. Where no sample fits there may be no sources.
Task<GeodesicSources> find_sources(Pace& pace, Surface& surface, const RegionSet& leaves, const TangleSeeds& seeds,
                                   const char* argument, SeedPlaces& places);

// Whether all vertices are to have values, or those of the leaves and the ring around them will do.
enum class FieldExtent { whole, local };
struct FieldKind {
    FieldExtent extent;
    bool labelled;
};

// Distances within `leaves` from the seeds, whose regions are their own or, if they have none, the leaves.
Task<void> solve_seeds(Pace& pace, const RegionTree& tree, const std::shared_ptr<Surface>& surface,
                       const LeafSet& leaves, const TangleSeeds& seeds, const char* argument, Perturbation perturbation,
                       FieldKind kind, DistanceField& field);

}  // namespace flg
