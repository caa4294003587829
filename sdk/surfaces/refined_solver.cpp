// SPDX-License-Identifier: MIT
#include "surfaces/refined_solver.h"

#include <algorithm>
#include <bit>

#include "surfaces/refined_solver_fronts.h"

namespace flg {

namespace {

// Of the mean edge; narrower buckets are nearer to the order of distances and hold less work for one after the other.
constexpr float bucket_width = 1.0f;
// Of a front, times the mean edge: sharper ones are noise.
constexpr float sharpest_bend = 0.15f;
// So that a few long edges do not ask for a ring without end.
constexpr float most_buckets = 4000.0f;

}  // namespace

RefinedSolver::RefinedSolver(const GeodesicBlocks& blocks, Memory* memory)
    : blocks_(blocks), memory_(memory), step_(choose_wave_step()), queue_(memory) {}

void RefinedSolver::begin(std::span<const Seed> seeds, const SolveLimits& limits, bool labelled,
                          const GeodesicRegion* region) {
    region_ = region;
    const uint32_t ranks = blocks_.rank_count();
    if (states_.size() < ranks) {
        states_ = Buffer<WaveState>(blocks_.blocks.capacity(), memory_);
        touched_ = Buffer<uint8_t>(blocks_.blocks.capacity() / page_size + 1, memory_);
        std::fill(touched_.begin(), touched_.end(), uint8_t{1});
    }
    if (labelled && labels_.size() < ranks) labels_ = Buffer<uint32_t>(blocks_.blocks.capacity(), memory_);
    labelled_ = labels_tell_fronts_ = labelled;
    const float width = std::max(bucket_width * blocks_.edges.mean(), blocks_.edges.longest() / most_buckets);
    buckets_per_metre_ = 1 / width;
    bend_max_ = sharpest_bend / blocks_.edges.mean();
    queue_.reset(static_cast<uint32_t>(blocks_.edges.longest() * buckets_per_metre_) + 3);
    extend(seeds, limits);
    fronts_meet_ = seeds.size() > 1;
    pass_ = Pass::clear;
}

void RefinedSolver::extend(std::span<const Seed> seeds, const SolveLimits& limits) {
    seeds_ = seeds;
    limits_ = &limits;
    reach_ = limits.distance;
    bucket_ = no_index;
    fronts_meet_ = true;
    any_beyond_ring_ = false;
    queue_.clear();
    targets_met_ = 0;
    furthest_target_ = 0;
    at_ = 0;
    pass_ = Pass::find_first;
}

bool RefinedSolver::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::clear:
                clear(at_);
                advance(page_count());
                break;
            case Pass::find_first:
                if (at_ < seeds_.size()) bucket_ = std::min(bucket_, bucket_of(seeds_[at_].distance));
                advance(seeds_.size());
                break;
            case Pass::seed:
                if (at_ < seeds_.size()) place(seeds_[at_]);
                advance(seeds_.size());
                break;
            case Pass::solve:
                solve_batch();
                count -= std::min(count, wave_step_vertices) - 1;
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

// Of the passes that go over an array: on to the next item, or pass.
void RefinedSolver::advance(size_t size) {
    if (++at_ < size) return;
    at_ = 0;
    pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
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

// Nothing further than the bucket's beginning can improve what is nearer by more than an edge: a distance across an edge
// is never below those at its ends. So what is within the limits, that far behind, is final.
void RefinedSolver::next_bucket() {
    ++bucket_;
    const float final = static_cast<float>(bucket_) / buckets_per_metre_ - blocks_.edges.longest();
    if (queue_.size() == 0 || final > limits_->distance || targets_are_nearer_than(final)) pass_ = Pass::done;
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

DistanceFieldKernel<RefinedSolver>::DistanceFieldKernel(const RefinedSolver& solver, uint32_t vertex_count,
                                                        bool labelled, DistanceField& field, Memory* memory)
    : solver_(solver), field_(field) {
    field.distances = Buffer<float>(vertex_count, memory);
    field.labels = Buffer<uint32_t>(labelled ? vertex_count : 0, memory);
}

bool DistanceFieldKernel<RefinedSolver>::run(uint32_t count) {
    const uint32_t size = static_cast<uint32_t>(field_.distances.size());
    for (; count > 0 && filled_ < size; --count) fill(filled_);
    for (; count > 0 && page_ < solver_.page_count(); --count) copy(page_++);
    return filled_ == size && page_ == solver_.page_count();
}

void DistanceFieldKernel<RefinedSolver>::fill(uint32_t first) {
    constexpr uint32_t fill_size = 64;
    filled_ = std::min(first + fill_size, static_cast<uint32_t>(field_.distances.size()));
    std::fill(field_.distances.data() + first, field_.distances.data() + filled_, unreachable);
    if (field_.labels.empty()) return;
    std::fill(field_.labels.data() + first, field_.labels.data() + filled_, no_index);
}

void DistanceFieldKernel<RefinedSolver>::copy(uint32_t page) {
    solver_.visit_page(page, [this](uint32_t vertex, float distance, uint32_t label) {
        field_.distances[vertex] = distance;
        if (!field_.labels.empty()) field_.labels[vertex] = label;
    });
}

}  // namespace flg
