// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.5.2 node hierarchy: strict trees).
#include "io/gltf_nodes.h"

#include "io/failure.h"

namespace flg::io {

GltfNodes::GltfNodes(const GltfDocument& document)
    : document_(document), parents_(document.size("nodes"), no_node), shown_(parents_.size()) {
    std::vector<size_t> first_child(size() + 1);
    std::vector<uint64_t> children;
    for (uint64_t i = 0; i < size(); ++i) {
        for (const uint64_t child : read_node_list(json(i), "children", place(i))) {
            document.element("nodes", child, place(i) + ".children");
            if (parents_[child] != no_node) {
                fail(FLG_ERROR_FORMAT, place(child),
                     "is a child of nodes[%llu] and of nodes[%llu]: nodes must form trees",
                     static_cast<unsigned long long>(parents_[child]), static_cast<unsigned long long>(i));
            }
            parents_[child] = i;
            children.push_back(child);
        }
        first_child[i + 1] = children.size();
    }
    order_.reserve(size());
    for (uint64_t i = 0; i < size(); ++i) {
        if (parents_[i] == no_node) order_.push_back(i);
    }
    for (size_t at = 0; at < order_.size(); ++at) {
        for (size_t c = first_child[order_[at]]; c < first_child[order_[at] + 1]; ++c) order_.push_back(children[c]);
    }
    if (order_.size() < size()) {
        std::vector<bool> is_reached(size());
        for (const uint64_t node : order_) is_reached[node] = true;
        uint64_t node = 0;
        while (is_reached[node]) ++node;
        fail(FLG_ERROR_FORMAT, place(node), "is below itself: nodes must form trees");
    }
    for (const uint64_t root : root_nodes(document)) {
        document.element("nodes", root, "scenes");
        shown_[root] = true;
    }
    for (const uint64_t node : order_) {
        if (parents_[node] != no_node && shown_[parents_[node]]) shown_[node] = true;
    }
}

const Json& GltfNodes::json(uint64_t node) const {
    return document_.element("nodes", node, place(node));
}

}  // namespace flg::io
