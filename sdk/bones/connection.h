// SPDX-License-Identifier: MIT
// Parts are connected in the order they were modelled (Ma, Wang, Li, Zhang 2021, sec. 3.2). A shape is approximated by
// balls at its joints and cones along its bones. Where an end or junction of the new part lies inside of that of an
// earlier one, the parts meet; of all such joints and all bones of earlier parts the nearest two are connected: bone
// split event if the joint is between the planes at the bone's ends (a new joint, a bone from it), joint connect event
// otherwise (a bone from the bone's nearer end).
//
// Departures. If no joint of the new part is inside of an earlier one, joints count whose balls touch one: the axes of
// thin parts end well before the parts do. Bones from part to part are no part's, and nothing is connected to them. A
// joint so near to a bone's end that the split would make a bone of no length is connected to that end. Distances are
// |v_i v_k| sin(theta) (Eq. 3 has v_i v_j).
#pragma once

#include <span>

#include "bones/bone_graph.h"

namespace flg {

// How a part was connected.
struct PartLink {
    enum class Event : uint32_t { root, bone_split, joint_connect };
    Event event = Event::root;
    uint32_t parent = no_number;        // the part it hangs on
    uint32_t joint = no_number;         // of this part, as it was when connected
    uint32_t parent_joint = no_number;  // that the new bone comes from
};

class ConnectionKernel {
public:
    // Connects the joints from `first_joint` on, all of the part `part`, with those before; never with those of `twin`.
    // All outlive the kernel; the graph and `out` are complete when run() returns true.
    ConnectionKernel(BoneGraph& graph, uint32_t part, uint32_t twin, uint32_t first_joint, uint32_t first_bone,
                     PartLink& out);

    // A unit is a joint held against 16 bones or joints: about 0.3 us.
    bool run(uint32_t count);

private:
    struct Place {
        double distance;
        uint32_t child, bone, joint;  // nearest to a bone, or to a joint that has none
        double share;                 // along the bone, in [0, 1]
    };

    bool holds(uint32_t child) const { return graph_.joints()[child].degree != 2; }
    void look_at_bone(uint32_t child, uint32_t bone);
    void look_at_joint(uint32_t child, uint32_t joint);
    void look(const Place& place, double parent_radius);
    void connect();

    BoneGraph& graph_;
    uint32_t part_, twin_, first_joint_, first_bone_;
    uint32_t last_joint_;  // one beyond the part's
    PartLink& out_;
    Place inside_, touching_;
    uint32_t child_;
    uint32_t at_ = 0;  // bones, then joints
};

}  // namespace flg
