// SPDX-License-Identifier: MIT
// The nodes of a glTF document as the trees they must be, and where they are.
//
// A glTF skin's joints as Filigree has them: at rest none is turned, and each comes after its parent. A joint's motion
// in a pose of the nodes is G A^-1 with G = (its node's transform) (its inverse bind matrix), where A places the whole:
// it is what the nodes above the first root say.
#pragma once

#include <span>

#include "io/base/memory.h"
#include "io/base/skin_data.h"
#include "io/gltf/gltf_scene.h"

namespace flg::io {

class GltfNodes {
public:
    // Refuses nodes with two parents, and circles.
    explicit GltfNodes(const GltfDocument& document);

    size_t size() const { return parents_.size(); }
    uint64_t parent(uint64_t node) const { return parents_[node]; }
    // All of them, parents first.
    const Vector<uint64_t>& order() const { return order_; }
    // Whether the scene shows a node.
    bool is_shown(uint64_t node) const { return shown_[node]; }
    const Json& json(uint64_t node) const;
    static String place(uint64_t node) { return "nodes[" + to_text(node) + "]"; }

private:
    const GltfDocument& document_;
    Vector<uint64_t> parents_, order_;
    Vector<bool> shown_;
};

struct GltfJoint {
    uint64_t node;
    uint32_t parent;        // FLG_NO_INDEX: a root; else lower
    Transform from_placed;  // inverse bind matrix, after the inverse of A
};

class GltfSkeleton {
public:
    // Refuses what is no skin, and joints that are scaled at rest.
    GltfSkeleton(const GltfDocument& document, const GltfNodes& nodes, uint64_t skin);

    const Vector<GltfJoint>& joints() const { return joints_; }
    // Of the file's numbers of joints: ours.
    const Vector<uint16_t>& order() const { return order_; }
    // A.
    const Transform& placement() const { return placement_; }
    void store(SkinData& data) const;

private:
    void read_joints(const GltfDocument& document, const String& place, const Json& json);
    void read_bind_matrices(const GltfDocument& document, const String& place, const Json& json);

    const GltfNodes& nodes_;
    Transform placement_ = identity_transform;
    Vector<GltfJoint> joints_;
    Vector<uint16_t> order_;
    Vector<double> positions_;  // 3 a joint, placed
};

// The inverse of an affine map, which must have one.
Transform inverse(const Transform& t);

inline std::array<double, 3> place_by(const Transform& t, const double* p) {
    std::array<double, 3> q;
    for (size_t row = 0; row < 3; ++row) q[row] = t[row] * p[0] + t[3 + row] * p[1] + t[6 + row] * p[2] + t[9 + row];
    return q;
}

}  // namespace flg::io
