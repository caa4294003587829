// SPDX-License-Identifier: MIT
// Parts are connected in the order they were modelled (Ma, Wang, Li, Zhang 2021, sec. 3.2). A shape is approximated by
// balls at its joints and cones along its bones. Where an end or junction of the new part lies inside of that of an
// earlier one, the parts meet; of all such joints and all bones of earlier parts the nearest two are connected: bone
// split event if the joint is between the planes at the bone's ends (a new joint, a bone from it), joint connect event
// otherwise (a bone from the bone's nearer end).
//
// Departures. Joints are inside of their parts, and balls do not fill them; so parts that meet only at their ends would
// be left apart. If no joint of the new part is inside of an earlier one, joints count whose balls come near one, and
// if there is none, parts that a point of the new one's outline is inside of. Bones from part to part are no part's,
// and nothing is connected to them. A joint so near to a bone's end that the split would make a bone of no length is
// connected to that end. Distances are |v_i v_k| sin(theta) (Eq. 3 has v_i v_j).
#pragma once

#include <span>

#include "bones/bone_graph.h"
#include "runtime/task.h"

namespace flg {

// How a part was connected.
struct PartLink {
    enum class Event : uint32_t { root, bone_split, joint_connect };
    Event event = Event::root;
    uint32_t parent = no_number;        // the part it hangs on
    uint32_t joint = no_number;         // of this part, as it was when connected
    uint32_t parent_joint = no_number;  // that the new bone comes from
};

// A part whose joints and bones are the graph's last ones, from these on.
struct NewPart {
    uint32_t number;
    uint32_t twin;  // a part that it is never connected with; no_number: none
    uint32_t first_joint, first_bone;
    std::span<const Vec3> outline;  // points around it
};

// Connects a part with those before. The graph outlives the task.
Task<PartLink> connect_part(Pace& pace, BoneGraph& graph, NewPart part);

}  // namespace flg
