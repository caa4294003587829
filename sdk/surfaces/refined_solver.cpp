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
        waiting_ = Buffer<uint32_t>(blocks_.blocks.capacity(), memory_);
        touched_ = Buffer<uint8_t>(blocks_.blocks.capacity() / page_size + 1, memory_);
        std::fill(touched_.begin(), touched_.end(), uint8_t{1});
    }
    if (labelled && labels_.size() < ranks) labels_ = Buffer<uint32_t>(blocks_.blocks.capacity(), memory_);
    labelled_ = labelled;
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
    batches_[0].size = batches_[1].size = 0;
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
            case Pass::solve: solve_batch(); break;
            case Pass::drain: drain(); break;
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
        waiting_[rank] = no_index;
    }
}

void RefinedSolver::place(const Seed& seed) {
    const uint32_t rank = blocks_.rank_of_vertex[seed.vertex];
    if (!(seed.distance < states_[rank].distance)) return;
    const float front = seed.straight ? 0.0f : seed.distance > 0 ? 1 / seed.distance : sharpest_front;
    if (labelled_) labels_[rank] = seed.label;
    improve(rank, {seed.distance, front});
}

uint32_t RefinedSolver::bucket_of(float distance) const {
    return static_cast<uint32_t>(std::min(distance * buckets_per_metre_, 4e9f));
}

// Never into a bucket that is behind, nor beyond the ring's end: from there it goes on when its time has come.
void RefinedSolver::wait(uint32_t rank) {
    uint32_t bucket = std::max(bucket_of(states_[rank].distance), bucket_);
    if (bucket - bucket_ >= queue_.span()) {
        bucket = bucket_ + queue_.span() - 1;
        any_beyond_ring_ = true;
    }
    if (waiting_[rank] == bucket) return;
    waiting_[rank] = bucket;
    queue_.push(bucket, rank);
}

void RefinedSolver::improve(uint32_t rank, const WaveState& state) {
    states_[rank] = state;
    touched_[rank / page_size] = 1;
    wait(rank);
}

[[gnu::always_inline]] inline void prefetch_block(const GeodesicBlock& block) {
    __builtin_prefetch(&block);
    __builtin_prefetch(&block.tangents);
}

// Memory is slow: what the vertices that come next will read is asked for ahead. (Inlined: GCC drops calls of functions that
// do nothing but prefetch.)
[[gnu::always_inline]] inline void RefinedSolver::prefetch() const {
    const uint32_t later = queue_.upcoming(bucket_, 8);
    prefetch_block(blocks_.blocks[later]);
    __builtin_prefetch(&states_[later]);
    const uint32_t sooner = queue_.upcoming(bucket_, 4);
    for (uint32_t lane : blocks_.blocks[sooner].lanes) __builtin_prefetch(&states_[lane & ~block_continues]);
    if (blocks_.blocks[sooner].continues()) __builtin_prefetch(&blocks_.overflow_of_rank[sooner]);
}

// The next vertex of the bucket that still waits there.
bool RefinedSolver::take(uint32_t& rank) {
    for (;;) {
        prefetch();
        if (!queue_.pop(bucket_, rank)) return false;
        if (waiting_[rank] != bucket_) continue;
        waiting_[rank] = no_index;
        if (!any_beyond_ring_ || bucket_of(states_[rank].distance) <= bucket_) return true;
        wait(rank);
    }
}

// The steps of some vertices at a time, and what the ones before them found: so the processor works on many steps at once,
// and a branch that it guessed wrong never waits for one.
void RefinedSolver::solve_batch() {
    Batch& batch = batches_[turn_];
    const Batch& before = batches_[1 - turn_];
    turn_ = 1 - turn_;
    batch.size = 0;
    while (batch.size < batch_size && take(batch.ranks[batch.size])) ++batch.size;
    for (uint32_t i = 0; i < batch.size; ++i) {
        const uint32_t rank = batch.ranks[i];
        const GeodesicBlock* bounded = region_ != nullptr ? region_->find(rank) : nullptr;
        batch.blocks[i] = bounded != nullptr ? bounded : &blocks_.blocks[rank];
        if (batch.blocks[i]->continues() && bounded == nullptr) {
            prefetch_block(blocks_.overflow[blocks_.overflow_of_rank[rank]]);
        }
        step_(*batch.blocks[i], states_.data(), states_[rank], bend_max_, labelled_, batch.steps[i]);
    }
    for (uint32_t i = 0; i < before.size; ++i) apply(before.ranks[i], *before.blocks[i], before.steps[i]);
    for (uint32_t i = 0; i < before.size; ++i) {
        if (before.blocks[i]->continues()) spread_on(before.ranks[i]);
    }
    if (batch.size + before.size == 0) next_bucket();
}

// The further blocks of a vertex.
void RefinedSolver::spread_on(uint32_t rank) {
    const bool bounded = region_ != nullptr && region_->find(rank) != nullptr;
    for (uint32_t i = 0;; ++i) {
        const GeodesicBlock& block =
            bounded ? region_->block(rank, i + 1) : blocks_.overflow[size_t{blocks_.overflow_of_rank[rank]} + i];
        WaveStep step;
        step_(block, states_.data(), states_[rank], bend_max_, labelled_, step);
        apply(rank, block, step);
        if (!block.continues()) return;
    }
}

void RefinedSolver::apply(uint32_t rank, const GeodesicBlock& block, const WaveStep& step) {
    for (uint32_t improved = step.improved; improved != 0; improved &= improved - 1) {
        const uint32_t lane = static_cast<uint32_t>(std::countr_zero(improved));
        const uint32_t neighbour = block.rank(lane);
        WaveState state = step.states[lane];
        bool is_own_front = false;
        if (fronts_meet_ && ((step.across_next | step.across_previous) >> lane & 1) != 0) {
            const bool across_next = (step.across_next >> lane & 1) != 0;
            if (const auto distance = distance_by_own_front(block, states_.data(), states_[rank], lane, across_next)) {
                const WaveState& own = states_[rank];
                state = {*distance, own.front / (1 + own.front * (*distance - own.distance))};
                is_own_front = true;
            }
        }
        if (!(state.distance < states_[neighbour].distance)) continue;
        if (labelled_) {
            const int32_t side = is_own_front ? 0 : step.sides[lane];
            labels_[neighbour] = labels_[side == 0 ? rank : block.rank(lane + static_cast<uint32_t>(side))];
        }
        improve(neighbour, state);
    }
}

// Nothing further than the bucket's beginning can improve what is nearer by more than an edge: a distance across an edge
// is never below those at its ends. So what is within the limits, that far behind, is final.
void RefinedSolver::next_bucket() {
    ++bucket_;
    const float final = static_cast<float>(bucket_) / buckets_per_metre_ - blocks_.edges.longest();
    if (queue_.size() == 0 || final > limits_->distance || targets_are_nearer_than(final)) pass_ = Pass::drain;
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

void RefinedSolver::drain() {
    uint32_t rank;
    if (queue_.size() == 0) {
        pass_ = Pass::done;
    } else if (queue_.pop(bucket_, rank)) {
        waiting_[rank] = no_index;
    } else {
        ++bucket_;
    }
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
