// SPDX-License-Identifier: MIT
// Geodesic distances by unfolding triangles. Labels are corrected until nothing improves: vertices wait in buckets by
// distance (bucket_queue.h), and each one that is taken out tells its neighbours what it knows (wave_step.h). Departure
// from Nazzaro, Puppo, Pellacini: geoTangle (2021), sec. 4.2: unfolding takes the place of the arcs across edges,
// buckets that of the SLF and LLL heuristics.
//
// Distances are not those of a graph: they depend, within the solver's error, on the order of visits, which is fixed.
// The order does not depend on slices, on ranks, or on what the solver was used for before.
#pragma once

#include <algorithm>
#include <span>

#include "surfaces/geodesics/bucket_queue.h"
#include "surfaces/geodesics/distance_field.h"
#include "surfaces/geodesics/geodesic_region.h"
#include "surfaces/geodesics/wave_step.h"

namespace flg {

// A solver is scratch memory (8 bytes a vertex, 12 with labels) that serves one field after the other; one for each
// thread. Ranks come in pages: to clear a field and to read it costs as many of them as it has touched.
class RefinedSolver {
public:
    // The blocks must outlive the solver; they may be updated between fields.
    RefinedSolver(const GeodesicBlocks& blocks, Memory* memory);

    // Of a vertex of the mesh, in the field that is complete.
    float distance(uint32_t vertex) const;
    uint32_t label(uint32_t vertex) const;

    uint32_t vertex_count() const { return blocks_.vertex_count(); }
    static constexpr uint32_t page_size = 64;  // ranks
    uint32_t page_count() const { return (blocks_.rank_count() + page_size - 1) / page_size; }
    // Calls take(vertex, distance, label) for those of the page that were reached; labels mean something if they are
    // kept.
    template <class Take>
    void visit_page(uint32_t page, Take take) const {
        if (touched_[page] == 0) return;
        const uint32_t end = std::min((page + 1) * page_size, blocks_.rank_count());
        for (uint32_t rank = std::max(page * page_size, nowhere + 1); rank < end; ++rank) {
            if (!(states_[rank].distance <= reach_) || states_[rank].distance == unreachable) continue;
            take(blocks_.vertex_of_rank[rank], states_[rank].distance, labelled_ ? labels_[rank] : no_index);
        }
    }

private:
    friend Task<void> spread_wave(Pace&, RefinedSolver&, std::span<const Seed>, const SolveLimits&);
    friend Task<void> solve_distances(Pace&, RefinedSolver&, std::span<const Seed>, const SolveLimits&, bool,
                                      const GeodesicRegion*);
    friend Task<void> extend_distances(Pace&, RefinedSolver&, std::span<const Seed>, const SolveLimits&);
    struct Batch {
        uint32_t size = 0;
        std::array<uint32_t, wave_step_vertices> ranks;
        std::array<WaveVertex, wave_step_vertices> vertices;
        WaveStep step;
    };
    // A vertex that waits, as long as its distance is this one: else it has come in again, nearer.
    struct Waiting {
        uint32_t rank;
        float distance;
    };

    void begin(std::span<const Seed> seeds, bool labelled, const GeodesicRegion* region);
    void begin_wave(const SolveLimits& limits);
    // Takes `count` vertices out of the buckets, or some more: about 70 ns each. True when the field is complete. (How
    // many there will be is not known: a loop of its own.)
    bool run(uint32_t count);
    void clear(uint32_t page);
    void place(const Seed& seed);
    uint32_t bucket_of(float distance) const;
    void wait(const Waiting& waiting);
    void improve(uint32_t rank, const WaveState& state);
    bool take(Waiting& taken);
    void solve_batch();
    void spread(Batch& batch);
    void spread_on(const Batch& batch);
    void apply(const Batch& batch);
    bool has_own_front(const Batch& batch, uint32_t place, WaveState& state) const;
    void next_bucket();
    bool targets_are_nearer_than(float distance);

    const GeodesicBlocks& blocks_;
    Memory* memory_;
    const WaveStepFunction step_;
    Buffer<WaveState> states_;  // by rank
    Buffer<uint32_t> labels_;   // by rank
    Buffer<uint8_t> touched_;   // by page: whether a state may differ from a cleared one
    BucketQueue<Waiting> queue_;
    const SolveLimits* limits_ = nullptr;
    const GeodesicRegion* region_ = nullptr;
    bool labelled_ = false;
    float buckets_per_metre_ = 1;
    float bend_max_ = 0;
    float longest_edge_ = 0;
    bool fronts_meet_ = false;         // of more than one seed
    bool labels_tell_fronts_ = false;  // each source is a point: what has its label has its front
    bool any_beyond_ring_ = false;     // some wait in a bucket that is too near
    uint32_t bucket_ = 0;              // that is being emptied
    uint32_t targets_met_ = 0;         // the first targets that have a distance
    float furthest_target_ = 0;        // of them
    float reach_ = unreachable;        // the last limit
    bool is_complete_ = true;
};

// Makes a field. Labels are kept if `labelled`. A region keeps the field to it, until the next field, also while that
// is extended; seeds must lie inside.
Task<void> solve_distances(Pace& pace, RefinedSolver& solver, std::span<const Seed> seeds, const SolveLimits& limits,
                           bool labelled, const GeodesicRegion* region = nullptr);

// Adds sources to the field that was made last: what is nearer to them changes, nothing else is visited.
Task<void> extend_distances(Pace& pace, RefinedSolver& solver, std::span<const Seed> seeds, const SolveLimits& limits);

// Copies the field out, with labels if they were kept and are wanted.
Task<void> take_field(Pace& pace, const RefinedSolver& solver, bool labelled, DistanceField& field);

}  // namespace flg
