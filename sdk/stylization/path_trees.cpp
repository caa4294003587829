// SPDX-License-Identifier: MIT
#include "stylization/path_trees.h"

#include <algorithm>
#include <limits>

namespace flg {

float PathTrees::finite_temperature(const PatchGraph& graph, float temperature) {
    const float highest = std::numeric_limits<float>::max() / (2.0f * static_cast<float>(graph.node_count));
    return std::min(temperature, highest);
}

PathTrees::PathTrees(const PatchGraph& graph, float temperature, Memory* memory)
    : graph_(&graph),
      temperature_(finite_temperature(graph, temperature)),
      memory_(memory),
      trees_(std::min(static_cast<size_t>(destinations_max), graph.destinations.size()), memory) {}

PathTrees::~PathTrees() {
    for (std::atomic<const uint16_t*>& tree : trees_) discard(const_cast<uint16_t*>(tree.load()));
}

uint32_t PathTrees::destination(uint32_t k) const {
    const uint32_t last = destination_count() - 1;
    if (last == 0) return graph_->destinations[0];
    return graph_->destinations[static_cast<uint64_t>(k) * (graph_->destinations.size() - 1) / last];
}

uint16_t* PathTrees::allocate() const {
    return static_cast<uint16_t*>(memory_->allocate(graph_->node_count * sizeof(uint16_t), alignof(uint16_t)));
}

void PathTrees::discard(uint16_t* tree) const {
    if (tree) memory_->deallocate(tree, graph_->node_count * sizeof(uint16_t), alignof(uint16_t));
}

const uint16_t* PathTrees::publish(uint32_t k, uint16_t* tree) {
    const uint16_t* expected = nullptr;
    if (trees_[k].compare_exchange_strong(expected, tree, std::memory_order_acq_rel, std::memory_order_acquire)) {
        return tree;
    }
    discard(tree);
    return expected;
}

}  // namespace flg
