// SPDX-License-Identifier: MIT
// Nodes that count as one: sets that grow by joining (union-find with path halving). The least node stands for its set.
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/memory.h"

namespace flg {

class NodeClusters {
public:
    NodeClusters(size_t nodes, Memory* memory) : towards_(nodes, memory) {}

    // Each node has to be begun, before any other call for it.
    void begin(uint32_t node) { towards_[node] = node; }
    uint32_t first(uint32_t node) {
        while (towards_[node] != node) node = towards_[node] = towards_[towards_[node]];
        return node;
    }
    // False if they were one already.
    bool join(uint32_t a, uint32_t b) {
        const uint32_t first_a = first(a), first_b = first(b);
        towards_[std::max(first_a, first_b)] = std::min(first_a, first_b);
        return first_a != first_b;
    }

private:
    Buffer<uint32_t> towards_;
};

}  // namespace flg
