// SPDX-License-Identifier: MIT
#include "surfaces/refined_solver.h"

#include <algorithm>
#include <bit>

namespace flg {

namespace {

// Of the mean edge; narrower buckets are nearer to the order of distances and hold less work for one after the other.
constexpr float bucket_width = 1.0f;
// So that a few long edges do not ask for a ring without end.
constexpr float most_buckets = 4000.0f;

}  // namespace

RefinedSolver::RefinedSolver(const GeodesicBlocks& blocks, Memory* memory)
    : blocks_(blocks), memory_(memory), step_(choose_wave_step()), queue_(memory) {}

void RefinedSolver::begin(std::span<const Seed> seeds, const SolveLimits& limits, bool labelled) {
    const uint32_t ranks = blocks_.rank_count();
    if (states_.size() < ranks) {
        states_ = Buffer<WaveState>(blocks_.blocks.capacity(), memory_);
        waiting_ = Buffer<uint32_t>(blocks_.blocks.capacity(), memory_);
    }
    if (labelled && labels_.size() < ranks) labels_ = Buffer<uint32_t>(blocks_.blocks.capacity(), memory_);
    labelled_ = labelled;
    const float width = std::max(bucket_width * blocks_.edges.mean(), blocks_.edges.longest() / most_buckets);
    buckets_per_metre_ = 1 / width;
    queue_.reset(static_cast<uint32_t>(blocks_.edges.longest() * buckets_per_metre_) + 3);
    extend(seeds, limits);
    pass_ = Pass::clear;
}

void RefinedSolver::extend(std::span<const Seed> seeds, const SolveLimits& limits) {
    seeds_ = seeds;
    limits_ = &limits;
    reach_ = limits.distance;
    bucket_ = no_index;
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
                advance(blocks_.rank_count());
                break;
            case Pass::find_first:
                if (at_ < seeds_.size()) bucket_ = std::min(bucket_, bucket_of(seeds_[at_].distance));
                advance(seeds_.size());
                break;
            case Pass::seed:
                if (at_ < seeds_.size()) place(seeds_[at_]);
                advance(seeds_.size());
                break;
            case Pass::solve: solve_pair(); break;
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

void RefinedSolver::clear(uint32_t rank) {
    states_[rank] = {rank == nowhere ? -unreachable : unreachable, 0, 0, 0};
    waiting_[rank] = no_index;
}

void RefinedSolver::place(const Seed& seed) {
    const uint32_t rank = blocks_.rank_of_vertex[seed.vertex];
    if (seed.distance < states_[rank].distance) improve(rank, {seed.distance, 0, 0, 0}, seed.label);
}

uint32_t RefinedSolver::bucket_of(float distance) const {
    return static_cast<uint32_t>(std::min(distance * buckets_per_metre_, 4e9f));
}

// Never into a bucket that is behind, nor beyond the ring's end: from there it goes on when its time has come.
void RefinedSolver::wait(uint32_t rank) {
    const uint32_t bucket = std::clamp(bucket_of(states_[rank].distance), bucket_, bucket_ + queue_.span() - 1);
    if (waiting_[rank] == bucket) return;
    waiting_[rank] = bucket;
    queue_.push(bucket, rank);
}

void RefinedSolver::improve(uint32_t rank, const WaveState& state, uint32_t label) {
    states_[rank] = state;
    if (labelled_) labels_[rank] = label;
    wait(rank);
}

// The next vertex of the bucket that still waits there.
bool RefinedSolver::take(uint32_t& rank) {
    while (queue_.pop(bucket_, rank)) {
        if (waiting_[rank] != bucket_) continue;
        waiting_[rank] = no_index;
        if (bucket_of(states_[rank].distance) <= bucket_) return true;
        wait(rank);
    }
    return false;
}

// Two vertices at a time: the processor works on both steps at once.
void RefinedSolver::solve_pair() {
    uint32_t first, second;
    if (!take(first)) {
        next_bucket();
        return;
    }
    spread(first);
    if (take(second)) spread(second);
}

void RefinedSolver::spread(uint32_t rank) {
    const GeodesicBlock* block = &blocks_.blocks[rank];
    for (size_t more = blocks_.overflow_of_rank[rank];; ++more) {
        std::array<uint32_t, lane_count> lanes = block->lanes;
        const bool continues = (lanes[lane_count - 1] & block_continues) != 0;
        lanes[lane_count - 1] &= ~block_continues;
        WaveStep step;
        step_(lanes.data(), blocks_.positions.data(), states_.data(), rank, step);
        apply(rank, lanes, step);
        if (!continues) return;
        block = &blocks_.overflow[more];
    }
}

void RefinedSolver::apply(uint32_t rank, const std::array<uint32_t, lane_count>& lanes, const WaveStep& step) {
    for (uint32_t improved = step.improved; improved != 0; improved &= improved - 1) {
        const uint32_t lane = static_cast<uint32_t>(std::countr_zero(improved));
        const WaveState& state = step.states[lane];
        if (state.distance < states_[lanes[lane]].distance) {
            improve(lanes[lane], state, labelled_ ? labels_[rank] : no_index);
        }
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

DistanceFieldKernel::DistanceFieldKernel(const RefinedSolver& solver, uint32_t vertex_count, bool labelled,
                                         DistanceField& field, Memory* memory)
    : solver_(solver), field_(field) {
    field.distances = Buffer<float>(vertex_count, memory);
    field.labels = Buffer<uint32_t>(labelled ? vertex_count : 0, memory);
}

bool DistanceFieldKernel::run(uint32_t count) {
    const size_t size = field_.distances.size();
    for (; count > 0 && at_ < size; --count, ++at_) {
        field_.distances[at_] = solver_.distance(at_);
        if (!field_.labels.empty()) field_.labels[at_] = solver_.label(at_);
    }
    return at_ == size;
}

}  // namespace flg
