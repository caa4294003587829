// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/refined_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "runtime/each.h"

namespace flg {

namespace {

// Of the mean edge; narrower buckets are nearer to the order of distances and hold less work for one after the other.
constexpr float bucket_width = 1.0f;
// Of a front, times the mean edge: sharper ones are noise.
constexpr float sharpest_bend = 0.15f;
// So that a few long edges do not ask for a ring without end.
constexpr float max_buckets = 4000.0f;
constexpr uint32_t vertices_at_a_time = 100;  // some 10 us

// Where the fronts of two sources meet, or those of a curve with itself. Unfolding (wave_step.h) takes both ends of an
// edge v-n to have their distances from one point; where v has its from one front and n from another, that point is
// none of either's, and what lies behind the edge would get a distance that is too short, by up to half an edge.
//
// A wave that comes to the edge through the triangle v-n-m has passed m: if the unfolded point is nearer to m than to
// the edge's ends, then m has at most that distance. Else the ends have different fronts. Then v's own front is
// unfolded across the edge v-m, or the next one around v for which the same holds, and goes on through the triangles
// between. No paper has this that we know of.

// Of the edge from v to m: how much further than from the unfolded point m may be. That point is not where it should be
// by the surface's curvature and by the distances' errors.
constexpr float tolerance = 0.015f;
constexpr uint32_t max_edges = 4;  // looked at around v

struct Angle {
    float cosine = 1, sine = 0;

    static Angle from_half_tangent(float tangent) {
        const float inverse = 1 / (1 + tangent * tangent);
        return {(1 - tangent * tangent) * inverse, (tangent + tangent) * inverse};
    }
    Angle operator+(const Angle& other) const {
        return {cosine * other.cosine - sine * other.sine, sine * other.cosine + cosine * other.sine};
    }
    Angle operator-() const { return {cosine, -sine}; }
};

// Goes around a vertex from lane to lane, one way or the other.
class FanWalk {
public:
    FanWalk(const GeodesicBlock& block, uint32_t lane, bool forth) : block_(block), lane_(lane), forth_(forth) {
        while (last_ > 0 && block.rank(last_) == nowhere) --last_;
        // Edges that were flipped stand behind the fan.
        if (block.rank(0) != block.rank(last_)) {
            last_ = 0;
            while (last_ + 1 < lane_count && block.tangents[last_] > 0) ++last_;
        }
        closed_ = last_ > 2 && block.rank(0) == block.rank(last_);
        if (!closed_) last_ = lane_count - 1;
    }
    // False where the fan, or the block, has no further triangle.
    bool advance() {
        if (lane_ == (forth_ ? last_ : 0)) {
            if (!closed_) return false;
            lane_ = last_ - lane_;
        }
        const float tangent = block_.tangents[forth_ ? lane_ : lane_ - 1];
        lane_ = forth_ ? lane_ + 1 : lane_ - 1;
        turned_ = Angle::from_half_tangent(tangent);
        return tangent > 0;
    }
    uint32_t rank() const { return block_.rank(lane_); }
    float length() const { return block_.lengths[lane_]; }
    const Angle& turned() const { return turned_; }  // by the last advance

private:
    const GeodesicBlock& block_;
    uint32_t lane_;
    uint32_t last_ = lane_count - 1;
    bool forth_;
    bool closed_;
    Angle turned_;
};

// How much further it is to a point that is `length` from the vertex, the front having that curvature at it and its
// source being seen at that angle from the point.
float way_on(float front, float length, float cosine) {
    const float excess = length * (front * length - (cosine + cosine));
    return excess / (1 + std::sqrt(std::max(1 + front * excess, 0.0f)));
}

// What the vertex and the end of one of its edges tell together, as in the step.
struct Sight {
    Sight(const WaveState& own, const WaveState& end, float length) {
        const float ahead_by = own.distance - end.distance, slope = ahead_by / length;
        const float moved = end.front / (1 + end.front * ahead_by);
        const float trust = own.distance / std::max(own.distance + end.distance, 1e-30f);
        front = own.front + trust * (moved - own.front);
        source.cosine = std::clamp(slope + 0.5f * length * front * (1 - slope * slope), -1.0f, 1.0f);
        source.sine = std::sqrt((1 - source.cosine) * (1 + source.cosine));
    }
    float front;
    Angle source;  // from the edge, on its other side
};

// How far, by v's own front, the neighbour at `lane` is that the step reached across the edge to the lane behind it, or
// before it. Nothing where the edge's ends have one front: the step's distance holds.
std::optional<float> distance_by_own_front(const GeodesicBlock& block, const WaveState* states, const WaveState& own,
                                           uint32_t lane, bool across_next) {
    const float target = block.lengths[lane], along = own.distance + target;
    FanWalk walk(block, lane, across_next);
    if (!walk.advance()) return {};
    Angle from_target = walk.turned();
    for (uint32_t edge = 0; edge < max_edges; ++edge) {
        const WaveState& end = states[walk.rank()];
        if (end.distance == std::numeric_limits<float>::infinity()) return along;
        const Sight sight(own, end, walk.length());
        bool is_one_front = true;
        if (walk.advance()) {
            const float passed =
                own.distance + way_on(sight.front, walk.length(), (sight.source + -walk.turned()).cosine);
            is_one_front = passed > std::max(own.distance, end.distance) ||
                           states[walk.rank()].distance <= passed + tolerance * walk.length();
        }
        if (is_one_front && edge == 0) return {};
        if (is_one_front) {
            const Angle apart = sight.source + from_target;
            const bool is_straight = from_target.sine > 0 && apart.sine >= 0;
            return is_straight ? own.distance + std::max(way_on(sight.front, target, apart.cosine), 0.0f) : along;
        }
        from_target = from_target + walk.turned();
    }
    return along;
}

}  // namespace

RefinedSolver::RefinedSolver(const GeodesicBlocks& blocks, Memory* memory)
    : blocks_(blocks), memory_(memory), step_(choose_wave_step()), queue_(memory) {}

void RefinedSolver::begin(std::span<const Seed> seeds, bool labelled, const GeodesicRegion* region) {
    region_ = region;
    const uint32_t ranks = blocks_.rank_count();
    if (states_.size() < ranks) {
        states_ = Buffer<WaveState>(blocks_.blocks.capacity(), memory_);
        touched_ = Buffer<uint8_t>(blocks_.blocks.capacity() / page_size + 1, memory_);
        std::fill(touched_.begin(), touched_.end(), uint8_t{1});
    }
    if (labelled && labels_.size() < ranks) labels_ = Buffer<uint32_t>(blocks_.blocks.capacity(), memory_);
    labelled_ = labels_tell_fronts_ = labelled;
    longest_edge_ = std::max(blocks_.edges.longest(), region ? region->longest_edge() : 0.0f);
    const float width = std::max(bucket_width * blocks_.edges.mean(), longest_edge_ / max_buckets);
    buckets_per_metre_ = 1 / width;
    bend_max_ = sharpest_bend / blocks_.edges.mean();
    queue_.reset(static_cast<uint32_t>(longest_edge_ * buckets_per_metre_) + 3);
    fronts_meet_ = seeds.size() > 1;
}

void RefinedSolver::begin_wave(const SolveLimits& limits) {
    limits_ = &limits;
    reach_ = limits.distance;
    bucket_ = no_index;
    any_beyond_ring_ = false;
    queue_.clear();
    targets_met_ = 0;
    furthest_target_ = 0;
    is_complete_ = false;
}

bool RefinedSolver::run(uint32_t count) {
    for (; count > 0 && !is_complete_; count -= std::min(count, wave_step_vertices)) solve_batch();
    return is_complete_;
}

Task<void> spread_wave(Pace& pace, RefinedSolver& solver, std::span<const Seed> seeds, const SolveLimits& limits) {
    solver.begin_wave(limits);
    co_await each(pace, seeds.size(), Cost::tens_of_ns,
                  [&](uint32_t i) { solver.bucket_ = std::min(solver.bucket_, solver.bucket_of(seeds[i].distance)); });
    co_await each(pace, seeds.size(), Cost::tens_of_ns, [&](uint32_t i) { solver.place(seeds[i]); });
    while (!solver.run(vertices_at_a_time)) co_await pace;
}

Task<void> solve_distances(Pace& pace, RefinedSolver& solver, std::span<const Seed> seeds, const SolveLimits& limits,
                           bool labelled, const GeodesicRegion* region) {
    solver.begin(seeds, labelled, region);
    co_await each(pace, solver.page_count(), Cost::tens_of_ns, [&](uint32_t page) { solver.clear(page); });
    co_await spread_wave(pace, solver, seeds, limits);
}

Task<void> extend_distances(Pace& pace, RefinedSolver& solver, std::span<const Seed> seeds, const SolveLimits& limits) {
    solver.fronts_meet_ = true;
    co_await spread_wave(pace, solver, seeds, limits);
}

Task<void> take_field(Pace& pace, const RefinedSolver& solver, bool labelled, DistanceField& field) {
    const uint32_t vertices = solver.vertex_count();
    field.distances = Buffer<float>(vertices, pace.memory());
    field.labels = Buffer<uint32_t>(labelled ? vertices : 0, pace.memory());
    float* const distances = field.distances.data();
    uint32_t* const labels = field.labels.data();
    co_await each(pace, vertices, Cost::some_ns, [=](uint32_t v) { distances[v] = unreachable; });
    co_await each(pace, labelled ? vertices : 0, Cost::some_ns, [=](uint32_t v) { labels[v] = no_index; });
    co_await each(pace, solver.page_count(), Cost::hundreds_of_ns, [=, &solver](uint32_t page) {
        solver.visit_page(page, [=](uint32_t vertex, float distance, uint32_t label) {
            distances[vertex] = distance;
            if (labelled) labels[vertex] = label;
        });
    });
}

// To the end of the page, whatever ranks there are now: a page is not looked at again until it is touched.
void RefinedSolver::clear(uint32_t page) {
    if (touched_[page] == 0) return;
    touched_[page] = 0;
    const size_t end = std::min(size_t{page + 1} * page_size, states_.size());
    for (size_t rank = size_t{page} * page_size; rank < end; ++rank) {
        states_[rank] = {rank == nowhere ? -unreachable : unreachable, 0};
    }
}

void RefinedSolver::place(const Seed& seed) {
    const uint32_t rank = blocks_.rank_of_vertex[seed.vertex];
    if (!(seed.distance < states_[rank].distance)) return;
    const float front = seed.straight ? 0.0f : seed.distance > 0 ? 1 / seed.distance : sharpest_front;
    if (labelled_) labels_[rank] = seed.label;
    if (seed.straight) labels_tell_fronts_ = false;
    improve(rank, {seed.distance, front});
}

uint32_t RefinedSolver::bucket_of(float distance) const {
    return static_cast<uint32_t>(std::min(distance * buckets_per_metre_, 4e9f));
}

// (Inlined: GCC drops calls of functions that do nothing but prefetch.)
[[gnu::always_inline]] inline void prefetch_block(const GeodesicBlock& block) {
    __builtin_prefetch(&block);
    __builtin_prefetch(&block.tangents);
}

// Never into a bucket that is behind, nor beyond the ring's end: from there it goes on when its time has come.
inline void RefinedSolver::wait(const Waiting& waiting) {
    uint32_t bucket = std::max(bucket_of(waiting.distance), bucket_);
    if (bucket - bucket_ >= queue_.span()) {
        bucket = bucket_ + queue_.span() - 1;
        any_beyond_ring_ = true;
    }
    queue_.push(bucket, waiting);
}

// Memory is slow: the block is asked for when its vertex begins to wait, thousands of cycles before it is looked at.
inline void RefinedSolver::improve(uint32_t rank, const WaveState& state) {
    states_[rank] = state;
    touched_[rank / page_size] = 1;
    prefetch_block(blocks_.blocks[rank]);
    wait({rank, state.distance});
}

// The next vertex of the bucket that still waits there.
inline bool RefinedSolver::take(Waiting& taken) {
    for (;;) {
        if (!queue_.pop(bucket_, taken)) return false;
        if (states_[taken.rank].distance != taken.distance) continue;
        if (!any_beyond_ring_ || bucket_of(taken.distance) <= bucket_) return true;
        wait(taken);
    }
}

// The steps of some vertices at a time, so that the processor works on them at once.
void RefinedSolver::solve_batch() {
    Batch batch;
    for (Waiting taken; batch.size < wave_step_vertices && take(taken); ++batch.size) {
        const GeodesicBlock* bounded = region_ != nullptr ? region_->find(taken.rank) : nullptr;
        const GeodesicBlock* block = bounded != nullptr ? bounded : &blocks_.blocks[taken.rank];
        batch.ranks[batch.size] = taken.rank;
        batch.vertices[batch.size] = {block, states_[taken.rank]};
        if (block->continues() && bounded == nullptr) {
            prefetch_block(blocks_.overflow[blocks_.overflow_of_rank[taken.rank]]);
        }
    }
    if (batch.size == 0) return next_bucket();
    spread(batch);
    spread_on(batch);
}

void RefinedSolver::spread(Batch& batch) {
    step_(batch.vertices.data(), batch.size, states_.data(), bend_max_, labelled_, batch.step);
    apply(batch);
}

// The further blocks of vertices.
void RefinedSolver::spread_on(const Batch& batch) {
    Batch parts;
    for (uint32_t i = 0; i < batch.size; ++i) {
        const uint32_t rank = batch.ranks[i];
        const GeodesicBlock* block = batch.vertices[i].block;
        const bool bounded = region_ != nullptr && region_->find(rank) != nullptr;
        for (uint32_t part = 0; block->continues(); ++part) {
            block = bounded ? &region_->block(rank, part + 1)
                            : &blocks_.overflow[size_t{blocks_.overflow_of_rank[rank]} + part];
            parts.ranks[parts.size] = rank;
            parts.vertices[parts.size++] = {block, states_[rank]};
            if (parts.size < wave_step_vertices) continue;
            spread(parts);
            parts.size = 0;
        }
    }
    if (parts.size != 0) spread(parts);
}

void RefinedSolver::apply(const Batch& batch) {
    const WaveStep& step = batch.step;
    for (uint32_t improved = step.improved; improved != 0; improved &= improved - 1) {
        const uint32_t place = static_cast<uint32_t>(std::countr_zero(improved));
        const GeodesicBlock& block = *batch.vertices[place / lane_count].block;
        const uint32_t neighbour = block.rank(place % lane_count);
        WaveState state = {step.distances[place], step.fronts[place]};
        const bool is_own_front = fronts_meet_ && has_own_front(batch, place, state);
        if (!(state.distance < states_[neighbour].distance)) continue;
        if (labelled_) {
            const int32_t side = is_own_front ? 0 : step.sides[place];
            labels_[neighbour] = labels_[side == 0 ? batch.ranks[place / lane_count]
                                                   : block.rank(place % lane_count + static_cast<uint32_t>(side))];
        }
        improve(neighbour, state);
    }
}

// Where the ends of the edge that the way crosses have different fronts, the state by the vertex's own.
bool RefinedSolver::has_own_front(const Batch& batch, uint32_t place, WaveState& state) const {
    const bool across_next = (batch.step.across_next >> place & 1) != 0;
    if (!across_next && (batch.step.across_previous >> place & 1) == 0) return false;
    const uint32_t rank = batch.ranks[place / lane_count], lane = place % lane_count;
    const GeodesicBlock& block = *batch.vertices[place / lane_count].block;
    if (labels_tell_fronts_ && labels_[rank] == labels_[block.rank(across_next ? lane + 1 : lane - 1)]) return false;
    const WaveState& own = states_[rank];
    const auto distance = distance_by_own_front(block, states_.data(), own, lane, across_next);
    if (!distance) return false;
    state = {*distance, own.front / (1 + own.front * (*distance - own.distance))};
    return true;
}

// Nothing further than the bucket's beginning can improve what is nearer by more than an edge: a distance across an
// edge is never below those at its ends. So what is within the limits, that far behind, is final.
void RefinedSolver::next_bucket() {
    ++bucket_;
    const float final = static_cast<float>(bucket_) / buckets_per_metre_ - longest_edge_;
    if (queue_.size() == 0 || final > limits_->distance || targets_are_nearer_than(final)) {
        is_complete_ = true;
    }
}

bool RefinedSolver::targets_are_nearer_than(float distance) {
    const auto& targets = limits_->targets;
    if (targets.empty()) return false;
    for (; targets_met_ < targets.size(); ++targets_met_) {
        const float target = states_[blocks_.rank_of_vertex[targets[targets_met_]]].distance;
        if (target == unreachable) return false;
        furthest_target_ = std::max(furthest_target_, target);
    }
    return furthest_target_ < distance;
}

float RefinedSolver::distance(uint32_t vertex) const {
    const float distance = states_[blocks_.rank_of_vertex[vertex]].distance;
    return distance <= reach_ ? distance : unreachable;
}

uint32_t RefinedSolver::label(uint32_t vertex) const {
    return distance(vertex) == unreachable ? no_index : labels_[blocks_.rank_of_vertex[vertex]];
}

}  // namespace flg
