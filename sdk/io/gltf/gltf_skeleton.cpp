// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.5.2 node hierarchy: strict trees; 3.7.3 skins, 5.28 skin).
#include "io/gltf/gltf_skeleton.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "io/base/failure.h"
#include "io/base/limits.h"

namespace flg::io {

GltfNodes::GltfNodes(const GltfDocument& document)
    : document_(document), parents_(document.size("nodes"), no_node), shown_(parents_.size()) {
    Vector<size_t> first_child(size() + 1);
    Vector<uint64_t> children;
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
        Vector<bool> is_reached(size());
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

namespace {

String joint_name(const Json& node, size_t joint) {
    const Json* const name = node.find("name");
    if (name && name->is_string()) return String(name->string());
    return "joint " + to_text(joint);
}

}  // namespace

Transform inverse(const Transform& t) {
    const double d = determinant(t);
    const auto minor = [&](size_t a, size_t b, size_t c, size_t e) { return (t[a] * t[b] - t[c] * t[e]) / d; };
    Transform r = {minor(4, 8, 7, 5),
                   minor(7, 2, 1, 8),
                   minor(1, 5, 4, 2),
                   minor(6, 5, 3, 8),
                   minor(0, 8, 6, 2),
                   minor(3, 2, 0, 5),
                   minor(3, 7, 6, 4),
                   minor(6, 1, 0, 7),
                   minor(0, 4, 3, 1),
                   0,
                   0,
                   0};
    for (size_t row = 0; row < 3; ++row) r[9 + row] = -(r[row] * t[9] + r[3 + row] * t[10] + r[6 + row] * t[11]);
    return r;
}

GltfSkeleton::GltfSkeleton(const GltfDocument& document, const GltfNodes& nodes, uint64_t skin) : nodes_(nodes) {
    const String place = "skins[" + to_text(skin) + "]";
    const Json& json = document.element("skins", skin, place);
    read_joints(document, place, json);
    read_bind_matrices(document, place, json);
}

void GltfSkeleton::read_joints(const GltfDocument& document, const String& place, const Json& json) {
    const Vector<uint64_t> listed = read_node_list(json, "joints", place);
    if (listed.empty()) fail(FLG_ERROR_FORMAT, place, "has no joints");
    if (listed.size() > max_joints) {
        fail(FLG_ERROR_LIMIT, place, "has %zu joints, more than the limit of %u", listed.size(), max_joints);
    }
    constexpr uint32_t none = 0xffffffffu;
    Vector<uint32_t> joint_of(nodes_.size(), none);  // of nodes: the file's number, later ours
    for (size_t j = 0; j < listed.size(); ++j) {
        const String here = place + ".joints[" + to_text(j) + "]";
        document.element("nodes", listed[j], here);
        if (joint_of[listed[j]] != none)
            fail(FLG_ERROR_FORMAT, here, "is nodes[%llu], as joint %u is", static_cast<unsigned long long>(listed[j]),
                 joint_of[listed[j]]);
        joint_of[listed[j]] = static_cast<uint32_t>(j);
    }
    // Of each node: the nearest joint above or at it, as a node.
    Vector<uint64_t> nearest(nodes_.size(), no_node);
    Vector<uint64_t> by_depth;
    bool in_order = true;
    for (const uint64_t node : nodes_.order()) {
        const uint64_t above = nodes_.parent(node) == no_node ? no_node : nearest[nodes_.parent(node)];
        nearest[node] = above;
        if (joint_of[node] == none) continue;
        in_order = in_order && (above == no_node || joint_of[above] < joint_of[node]);
        by_depth.push_back(node);
        nearest[node] = node;
    }
    const Vector<uint64_t>& ours = in_order ? listed : by_depth;
    order_.resize(listed.size());
    for (size_t j = 0; j < ours.size(); ++j) order_[joint_of[ours[j]]] = static_cast<uint16_t>(j);
    for (size_t j = 0; j < ours.size(); ++j) {
        const uint64_t above = nodes_.parent(ours[j]) == no_node ? no_node : nearest[nodes_.parent(ours[j])];
        joints_.push_back({ours[j], above == no_node ? FLG_NO_INDEX : order_[joint_of[above]], identity_transform});
    }
}

void GltfSkeleton::read_bind_matrices(const GltfDocument& document, const String& place, const Json& json) {
    Vector<uint64_t> above;
    for (uint64_t node = nodes_.parent(joints_[0].node); node != no_node; node = nodes_.parent(node))
        above.push_back(node);
    for (size_t i = above.size(); i-- > 0;) {
        placement_ = compose(placement_, local_transform(nodes_.json(above[i]), GltfNodes::place(above[i])));
    }
    if (!(std::abs(determinant(placement_)) > 0)) {
        fail(FLG_ERROR_FORMAT, GltfNodes::place(joints_[0].node), "is a joint below nodes that have no size");
    }
    const Transform unplaced = inverse(placement_);

    Vector<Transform> bind(joints_.size(), identity_transform);
    if (json.find("inverseBindMatrices")) {
        const String here = place + ".inverseBindMatrices";
        const GltfValues values = document.matrices(gltf_required(json, "inverseBindMatrices", place), here);
        if (values.count < joints_.size()) {
            fail(FLG_ERROR_FORMAT, values.place + ".count", "is %llu, but there are %zu joints",
                 static_cast<unsigned long long>(values.count), joints_.size());
        }
        for (size_t file_joint = 0; file_joint < joints_.size(); ++file_joint) {
            Transform& to = bind[order_[file_joint]];
            for (uint32_t column = 0; column < 4; ++column)
                for (uint32_t row = 0; row < 3; ++row)
                    to[3 * column + row] = values.number(file_joint, 4 * column + row);
            const bool sound =
                std::all_of(to.begin(), to.end(), [](double v) { return std::abs(v) <= max_coordinate; });
            if (!sound || !(std::abs(determinant(to)) > 0))
                fail(FLG_ERROR_FORMAT, values.place, "the matrix of joint %zu is not finite, or has no inverse",
                     file_joint);
        }
    }
    for (size_t j = 0; j < joints_.size(); ++j) {
        joints_[j].from_placed = compose(bind[j], unplaced);
        // What the matrix takes to the origin. Of one that only moves it is read off, so that no bit is lost.
        bool only_moves = true;
        for (size_t k = 0; k < 9; ++k) only_moves = only_moves && joints_[j].from_placed[k] == identity_transform[k];
        const Transform place_of = only_moves ? joints_[j].from_placed : inverse(joints_[j].from_placed);
        for (size_t k = 9; k < 12; ++k) positions_.push_back(only_moves ? 0 - place_of[k] : place_of[k]);
    }
}

void GltfSkeleton::store(SkinData& data) const {
    for (const double value : positions_) {
        if (!(std::abs(value) <= max_coordinate)) fail(FLG_ERROR_FORMAT, "skins", "a joint is at %g", value);
        data.joint_positions.push_back(static_cast<float>(value));
    }
    for (size_t j = 0; j < joints_.size(); ++j) {
        data.joint_parents.push_back(joints_[j].parent);
        data.joint_names.push_back(joint_name(nodes_.json(joints_[j].node), j));
    }
}

}  // namespace flg::io
