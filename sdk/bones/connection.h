// SPDX-License-Identifier: MIT
// Parts are connected in the order they were modelled (Ma, Wang, Li, Zhang 2021, sec. 3.2). A shape is approximated by
// balls at its joints and cones along its bones. Where an end or junction of the new part lies inside of that of an
// earlier one, the parts meet; of all such joints and all bones of earlier parts the nearest two are connected: bone
// split event if the joint is between the planes at the bone's ends (a new joint, a bone from it), joint connect event
// otherwise (a bone from the bone's nearer end).
//
// Departures. Joints are inside of their parts, and balls do not fill them; so parts that meet only at their ends would
// be left apart. If no joint of the new part is inside of an earlier one, joints count that are in a wide part's shape,
// corners and all (wide_part.h); then joints whose balls come near one; then parts that a point of the new one's
// outline is inside of. Where all are placed, what still meets none hangs across a small gap. Where both ends of a limb
// are inside, or touch, the one that is thicker by a quarter counts, or else, of two inside, the upper one: an arm over
// the chest or beside it hangs by its shoulder. A part that lies across the mirror plane of what it hangs on, alike to
// both sides, hangs by its middle. A limb with an image, such as an arm that prays, does not hang by the end that meets
// the image's, but by the other one, if that is near. Limbs hang on the trunk, not on each other: where the joint is
// inside of the root end of a part and of the one that this hangs on, it is connected with the latter. Bones from part
// to part are no part's, and nothing is connected to them. A joint so near to a bone's end that the split would make a
// bone of no length is connected to that end. Distances are |v_i v_k| sin(theta) (Eq. 3 has v_i v_j).
#pragma once

#include <span>

#include "bones/bone_graph.h"
#include "bones/wide_part.h"
#include "runtime/task.h"

namespace flg {

// How a part was connected.
struct PartLink {
    enum class Event : uint32_t { root, bone_split, joint_connect };
    Event event = Event::root;
    uint32_t parent = no_number;        // the part it hangs on
    uint32_t joint = no_number;         // of this part, as it was when connected
    uint32_t parent_joint = no_number;  // that the new bone comes from
    uint32_t child = no_number;         // the part that hangs there: not always the new one
};

// Of a part that is its own mirror image, or between a part and its image.
struct MirrorPlane {
    Vec3 at = Vec3::Zero(), normal = Vec3::Zero();  // 0: there is none

    double side(const Vec3& point) const { return normal.dot(point - at); }
};

// A part, whose own joints are these of the graph.
struct NewPart {
    uint32_t number;
    uint32_t first_joint, end_joint;
    std::span<const Vec3> outline;  // points around it
    MirrorPlane twin = {};          // beyond which its image is; none: it has none
};

// What it may be connected with. By part; all outlive the task.
struct OtherParts {
    std::span<const uint8_t> may_meet;          // 1: yes; none: all but itself
    std::span<const PartLink> links = {};       // of those before; none: not known
    std::span<const WidePart> shapes = {};      // none: not known
    std::span<const MirrorPlane> mirrors = {};  // none: not known
};

// Connects a part with the nearest of the others that it meets.
Task<PartLink> connect_part(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others);

// Likewise with a part whose ends or junctions are inside of this one: that part hangs on this one.
Task<PartLink> connect_to_part(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others);

// Connects a part that meets none with what lies across the least gap, if that is small by both radii.
Task<PartLink> connect_across_gap(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others);

// The end or junction of a part and the place of the others that are nearest to each other, wherever they are.
Task<PartLink> connect_anyway(Pace& pace, BoneGraph& graph, NewPart part, OtherParts others);

}  // namespace flg
