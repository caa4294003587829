// SPDX-License-Identifier: MIT
// The hierarchy of a model's parts, as animators expect it: the trunk is the root, limbs hang on it, and what is known
// of a part alone does not depend on where other parts are.
//
// 1. The trunk comes first: the part that the host names, else the one of the largest area that is not there twice. The
//    others follow in modelling order, those that a host hung on a part after that. Each is connected with the parts
//    before it that it meets (connection.h): with the nearest, and where these do not hang together yet, with more.
// 2. Parts that meet no other are roots too. From the roots on every part is directed and its joints are numbered.
// 3. The root is the middle of its part; where that is on a limb that is thinner than the joint that it hangs on, it is
//    that joint.
//
// Departure from the paper: there a part drawn before the trunk is a root, and what it met is all it is connected with.
#pragma once

#include "bones/bone_graph.h"
#include "bones/connection.h"
#include "bones/model.h"
#include "runtime/task.h"

namespace flg {

struct JointLabel {
    explicit JointLabel(Memory* memory) : key(memory), name(memory) {}

    std::pmr::string key;
    std::pmr::string name;   // that a host gave it; none: the key
    bool is_pinned = false;  // by an edit
};

struct Hierarchy {
    explicit Hierarchy(Memory* memory) : links(memory), roots(memory), labels(memory) {}

    std::pmr::vector<PartLink> links;  // by part
    std::pmr::vector<uint32_t> roots;  // joints, the trunk's first; pinned
    std::pmr::vector<JointLabel> labels;
};

// The graph has all parts' joints, refined but not connected: first_joints[p] is the first of part p, and one more is
// the end. Sets the model's own joints.
Task<Hierarchy> connect_parts(Pace& pace, HeldModel& model, BoneGraph& graph, std::span<const uint32_t> first_joints,
                              double collapse);

}  // namespace flg
