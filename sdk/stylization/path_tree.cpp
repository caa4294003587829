// SPDX-License-Identifier: MIT
#include "stylization/path_tree.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace flg {

namespace {

constexpr uint32_t arity = 4;
constexpr uint64_t no_key = std::numeric_limits<uint64_t>::max();

uint64_t make_key(float distance, uint32_t node) {
    return static_cast<uint64_t>(std::bit_cast<uint32_t>(distance)) << 32 | node;
}

}  // namespace

void PathTreeKernel::begin(const PatchGraph& graph, float temperature, uint32_t destination, uint16_t* next_hop) {
    graph_ = &graph;
    next_hop_ = next_hop;
    temperature_ = temperature + 0.0f;  // -0 would be the largest key
    const size_t keys = graph.edge_count() + arity;
    if (distance_.size() < graph.node_count) distance_ = Buffer<float>(graph.node_count, memory_);
    if (settled_.size() < graph.node_count) settled_ = Buffer<uint8_t>(graph.node_count, memory_);
    if (heap_.size() < keys) heap_ = Buffer<uint64_t>(keys, memory_);
    std::fill_n(distance_.data(), graph.node_count, std::numeric_limits<float>::infinity());
    std::fill_n(settled_.data(), graph.node_count, uint8_t{0});
    std::fill_n(next_hop, graph.node_count, no_hop);
    distance_[destination] = 0;
    next_hop[destination] = static_cast<uint16_t>(destination);
    heap_size_ = 0;
    std::fill_n(heap_.data(), arity - 1, no_key);
    held_ = no_key;
    push(make_key(0, destination));
}

bool PathTreeKernel::run(uint32_t& units) {
    while (heap_size_ > 0 || held_ != no_key) {
        if (units == 0) return false;
        --units;
        const uint64_t key = pop();
        const uint32_t node = static_cast<uint32_t>(key);
        const float distance = std::bit_cast<float>(static_cast<uint32_t>(key >> 32));
        if (distance == distance_[node]) settle(node, distance);
    }
    return true;
}

void PathTreeKernel::settle(uint32_t node, float distance) {
    settled_[node] = 1;
    if (node > 0 && graph_->curve_end[node - 1] != node) {
        const uint32_t before = node - 1;
        const float through = temperature_ + distance;
        if (through < distance_[before]) {
            distance_[before] = through;
            next_hop_[before] = static_cast<uint16_t>(node);
            push(make_key(through, before));
        } else if (through == distance_[before] && !settled_[before]) {
            next_hop_[before] = static_cast<uint16_t>(node);
        }
    }
    const uint32_t end = graph_->in_begin[node + 1];
    for (uint32_t k = graph_->in_begin[node]; k < end; ++k) {
        const uint32_t source = graph_->in_source[k];
        const float through = graph_->in_cost[k] + distance;
        if (through < distance_[source]) {
            distance_[source] = through;
            next_hop_[source] = static_cast<uint16_t>(node);
            push(make_key(through, source));
        }
    }
}

void PathTreeKernel::push(uint64_t key) {
    if (key < held_) std::swap(key, held_);
    if (key == no_key) return;
    uint64_t* heap = heap_.data();
    uint32_t at = heap_size_++;
    heap[at + arity - 1] = no_key;
    while (at > 0) {
        const uint32_t parent = (at - 1) / arity;
        if (heap[parent] <= key) break;
        heap[at] = heap[parent];
        at = parent;
    }
    heap[at] = key;
}

uint64_t PathTreeKernel::pop() {
    uint64_t* heap = heap_.data();
    const uint64_t top = heap[0];
    if (held_ <= top) return std::exchange(held_, no_key);
    const uint64_t key = heap[--heap_size_];
    const uint32_t size = heap_size_;
    heap[size] = no_key;
    if (size == 0) return top;
    uint32_t at = 0;
    for (;;) {
        const uint32_t first = at * arity + 1;
        if (first >= size) break;
        const uint64_t* child = heap + first;
        const uint32_t low = child[1] < child[0] ? 1 : 0;
        const uint32_t high = child[3] < child[2] ? 3 : 2;
        const uint32_t least = child[high] < child[low] ? high : low;
        if (child[least] >= key) break;
        heap[at] = child[least];
        at = first + least;
    }
    heap[at] = key;
    return top;
}

}  // namespace flg
