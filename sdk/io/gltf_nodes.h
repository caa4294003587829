// SPDX-License-Identifier: MIT
// The nodes of a glTF document as the trees they must be, and where they are.
#pragma once

#include <span>
#include <vector>

#include "io/gltf_scene.h"

namespace flg::io {

constexpr uint64_t no_node = UINT64_MAX;

class GltfNodes {
public:
    // Refuses nodes with two parents, and circles.
    explicit GltfNodes(const GltfDocument& document);

    size_t size() const { return parents_.size(); }
    uint64_t parent(uint64_t node) const { return parents_[node]; }
    // All of them, parents first.
    const std::vector<uint64_t>& order() const { return order_; }
    // Whether the scene shows a node.
    bool is_shown(uint64_t node) const { return shown_[node]; }
    const Json& json(uint64_t node) const;
    static std::string place(uint64_t node) { return "nodes[" + std::to_string(node) + "]"; }

private:
    const GltfDocument& document_;
    std::vector<uint64_t> parents_, order_;
    std::vector<bool> shown_;
};

}  // namespace flg::io
