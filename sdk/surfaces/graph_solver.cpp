// SPDX-License-Identifier: MIT
#include "surfaces/graph_solver.h"

#include <algorithm>

namespace flg {

namespace {

constexpr uint32_t arcs_at_a_time = 64;
constexpr uint32_t fetch_ahead = 6;  // nodes

}  // namespace

void GraphSolver::begin(std::span<const Seed> seeds, const SolveLimits& limits, const RegionSet& regions,
                        bool labelled) {
    const size_t nodes = graph_.node_count(), capacity = graph_.rows.capacity();
    if (distances_.size() < nodes) {
        distances_ = Buffer<float>(capacity, memory_);
        waiting_ = Buffer<uint32_t>(capacity, memory_);
    }
    if (labelled && labels_.size() < nodes) labels_ = Buffer<uint32_t>(capacity, memory_);
    if (!regions.all() && is_bounded_.size() < nodes) is_bounded_ = Buffer<uint8_t>(capacity, memory_);
    regions_ = &regions;
    labelled_ = labelled;
    limit_ = limits.distance;
    buckets_per_metre_ = 1 / graph_.bucket_width();
    queue_.reset(static_cast<uint32_t>(graph_.longest * buckets_per_metre_) + 3);
    extend(seeds, limits);
    pass_ = Pass::clear;
}

void GraphSolver::extend(std::span<const Seed> seeds, const SolveLimits& limits) {
    seeds_ = seeds;
    limits_ = &limits;
    bucket_ = no_index;
    met_ = 0;
    at_ = 0;
    pass_ = Pass::find_first;
}

bool GraphSolver::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::clear: pass_over(graph_.node_count(), 64, [this](uint32_t node) { clear(node); }); break;
            case Pass::bound:
                pass_over(regions_->all() ? 0 : mesh_.triangle_count(), 16, [this](uint32_t t) { bound(t); });
                break;
            case Pass::find_first:
                pass_over(seeds_.size(), 16,
                          [this](uint32_t i) { bucket_ = std::min(bucket_, bucket_of(seeds_[i].distance)); });
                break;
            case Pass::seed: pass_over(seeds_.size(), 1, [this](uint32_t i) { place(seeds_[i]); }); break;
            case Pass::solve: solve(); break;
            case Pass::drain: drain(); break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

// The next `step` items, or on to the next pass.
template <class Visit>
void GraphSolver::pass_over(size_t size, uint32_t step, Visit visit) {
    const uint32_t end = static_cast<uint32_t>(std::min<size_t>(size, size_t{at_} + step));
    for (; at_ < end; ++at_) visit(at_);
    if (at_ < size) return;
    at_ = 0;
    pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
}

void GraphSolver::clear(uint32_t node) {
    waiting_[node] = no_index;
    if (labelled_) labels_[node] = 0;  // none is less: sums that overflow are no improvement
    distances_[node] = regions_->all() ? unreachable : -1.0f;
    if (!regions_->all()) is_bounded_[node] = 0;
}

// Lets paths into a triangle of the regions.
void GraphSolver::bound(uint32_t triangle) {
    const auto is_inside = [this](uint32_t t) { return t == no_index || regions_->contains(mesh_.regions[t]); };
    if (!is_inside(triangle)) return;
    const Triple& neighbours = mesh_.neighbours[triangle];
    const bool at_border = !is_inside(neighbours[0]) || !is_inside(neighbours[1]) || !is_inside(neighbours[2]);
    for (uint32_t vertex : mesh_.triangles[triangle]) {
        const uint32_t node = graph_.node_of(vertex);
        distances_[node] = unreachable;
        if (at_border) is_bounded_[node] = 1;
    }
}

void GraphSolver::place(const Seed& seed) {
    reach(graph_.node_of(seed.vertex), seed.distance, seed.label);
}

uint32_t GraphSolver::bucket_of(float distance) const {
    return static_cast<uint32_t>(std::min(distance * buckets_per_metre_, 4e9f));
}

// Of distances that are the same the one with the least label counts.
void GraphSolver::reach(uint32_t node, float distance, uint32_t label) {
    const float old = distances_[node];
    if (distance >= old && (!labelled_ || distance > old || label >= labels_[node])) return;
    distances_[node] = distance;
    if (labelled_) labels_[node] = label;
    wait(node);
}

// Not beyond the ring's end: from there it goes on when its time has come.
void GraphSolver::wait(uint32_t node) {
    const uint32_t bucket = std::min(bucket_of(distances_[node]), bucket_ + queue_.span() - 1);
    if (waiting_[node] == bucket) return;
    waiting_[node] = bucket;
    queue_.push(bucket, node);
}

void GraphSolver::solve() {
    if (row_.count != 0) return follow_row();
    if (corner_ != no_index) return cross_triangle();
    if (!queue_.pop(bucket_, node_)) return next_bucket();
    if (waiting_[node_] != bucket_) return;
    waiting_[node_] = no_index;
    if (bucket_of(distances_[node_]) != bucket_) return wait(node_);
    if (!regions_->all() && is_bounded_[node_] != 0) {
        corner_ = mesh_.corner_of_vertex[graph_.vertex_of(node_)];
        return cross_triangle();
    }
    const GraphArc* upcoming = graph_.arcs.data() + graph_.rows[queue_.upcoming(bucket_, fetch_ahead)].first;
    __builtin_prefetch(upcoming);
    __builtin_prefetch(upcoming + 8);
    row_ = graph_.rows[node_];
    follow_row();
}

void GraphSolver::follow_row() {
    const float distance = distances_[node_];
    const uint32_t label = labelled_ ? labels_[node_] : no_index;
    const uint32_t count = std::min(row_.count, arcs_at_a_time);
    const GraphArc* arcs = graph_.arcs.data() + row_.first;
    const float* distances = distances_.data();
    for (uint32_t i = 0; i < count; ++i) {
        const float through = distance + arcs[i].length;
        if (through <= distances[arcs[i].target]) reach(arcs[i].target, through, label);
    }
    row_.first += count;
    row_.count -= count;
}

// The arcs along and across one triangle of the node's fan, if it belongs to the regions.
void GraphSolver::cross_triangle() {
    const auto enters = [this](uint32_t triangle) { return regions_->contains(mesh_.regions[triangle]); };
    const float distance = distances_[node_];
    const uint32_t label = labelled_ ? labels_[node_] : no_index;
    const Corner next = mesh_.turn(corner_);
    if (enters(triangle_of(corner_))) {
        const bool goes_on = next != no_index && enters(triangle_of(next));
        visit_arcs(mesh_, positions_, corner_, goes_on ? next : no_index, enters,
                   [&](uint32_t vertex, float length) { reach(graph_.node_of(vertex), distance + length, label); });
    }
    corner_ = next == mesh_.corner_of_vertex[graph_.vertex_of(node_)] ? no_index : next;
}

// What is nearer than the bucket is final. Targets are looked at one after the other.
void GraphSolver::next_bucket() {
    const auto& targets = limits_->targets;
    if (met_ < targets.size()) {
        const float distance = distances_[graph_.node_of(targets[met_])];
        if (distance < 0 || bucket_of(distance) <= bucket_) {
            if (++met_ == targets.size()) pass_ = Pass::drain;
            return;
        }
    }
    ++bucket_;
    if (queue_.size() == 0 || bucket_ > bucket_of(limits_->distance)) pass_ = Pass::drain;
}

void GraphSolver::drain() {
    uint32_t node;
    if (queue_.size() == 0) {
        pass_ = Pass::done;
    } else if (queue_.pop(bucket_, node)) {
        waiting_[node] = no_index;
    } else {
        ++bucket_;
    }
}

}  // namespace flg
