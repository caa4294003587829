// SPDX-License-Identifier: MIT
// The path trees of one style at one temperature, made when first asked for and shared by all threads.
//
// Departure from the paper, whose destinations are all nodes with a patch: at most `destinations_max` of them, spread
// evenly, so that a long run of synthesis costs so many trees and no more.
#pragma once

#include <atomic>
#include <vector>

#include "stylization/path_tree.h"

namespace flg {

class PathTrees {
public:
    static constexpr uint32_t destinations_max = 256;

    // `temperature`, or less where the cost of a path might pass what a float holds.
    static float finite_temperature(const PatchGraph& graph, float temperature);

    // `graph` outlives it; `temperature` in metres. `memory` must be thread-safe.
    PathTrees(const PatchGraph& graph, float temperature, Memory* memory);
    ~PathTrees();
    PathTrees(const PathTrees&) = delete;
    PathTrees& operator=(const PathTrees&) = delete;

    const PatchGraph& graph() const { return *graph_; }
    float temperature() const { return temperature_; }
    // 1 at least.
    uint32_t destination_count() const { return static_cast<uint32_t>(trees_.size()); }
    // The node that is destination `k`; rises with k.
    uint32_t destination(uint32_t k) const;

    // [any thread] The next hops to destination k, or null if they have not been computed yet.
    const uint16_t* find(uint32_t k) const { return trees_[k].load(std::memory_order_acquire); }
    // [any thread] Memory for a tree that is about to be computed, then to be handed to publish() or discard().
    uint16_t* allocate() const;
    void discard(uint16_t* tree) const;
    // [any thread] Takes a computed tree; if another thread was faster, frees it (the two are equal). Returns what
    // counts.
    const uint16_t* publish(uint32_t k, uint16_t* tree);

private:
    const PatchGraph* graph_;
    float temperature_;
    Memory* memory_;
    std::pmr::vector<std::atomic<const uint16_t*>> trees_;
};

}  // namespace flg
