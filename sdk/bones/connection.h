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
#include <vector>

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
    // `outline`: points around the part. All outlive the kernel; the graph and `out` are complete when run() returns
    // true.
    ConnectionKernel(BoneGraph& graph, uint32_t part, uint32_t twin, uint32_t first_joint, uint32_t first_bone,
                     std::span<const Vec3> outline, PartLink& out, Memory* memory);

    // A unit is a joint held against 16 bones or joints: about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { box, list, joints, outline, nearest };
    struct Place {
        double distance;
        uint32_t child, bone, joint;  // nearest to a bone, or to a joint that has none
        double share;                 // along the bone, in [0, 1]
    };

    bool step();
    void enter(Pass pass);
    void widen(const Vec3& at, double radius);
    void list(uint32_t number);
    bool compare();
    // The bone or joint without a bone that is number `number`, from a point; a place at infinity if it doesn't count.
    Place from(const Vec3& point, uint32_t child, uint32_t number, double& radius, uint32_t& part) const;
    void look(const Vec3& point, uint32_t child, uint32_t number);
    void connect(const Place& place);

    BoneGraph& graph_;
    uint32_t twin_, first_joint_, first_bone_;
    uint32_t last_joint_;  // one beyond the part's
    std::span<const Vec3> outline_;
    PartLink& out_;
    Place inside_, near_, nearest_;
    std::pmr::vector<bool> meets_;             // by part, that a point of the outline is in
    Vec3 low_, high_;                          // of what may be near the new part
    std::pmr::vector<uint32_t> near_numbers_;  // bones, then joints, that are there
    Pass pass_ = Pass::box;
    uint32_t point_ = 0;  // the joint or point of the outline that is held against the others
    uint32_t at_ = 0;
};

}  // namespace flg
