// SPDX-License-Identifier: MIT
// The bones of a model while they are put together: joints and bones without a direction, that can be split, contracted
// and removed. Always a forest.
//
// Directions for bones: joints numbered from the roots on, parents first, each branch in one piece.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/memory.h"
#include "core/vec.h"
#include "runtime/task.h"
#include "skeletons/bone_tree.h"

namespace flg {

inline constexpr uint32_t no_number = 0xffffffffu;

class BoneGraph {
public:
    // What refinement does with a joint: one on the mirror axis of its part is kept where an image could be kept too;
    // one that is pinned is never moved or removed.
    enum class Hold : uint8_t { none, middle, pinned };
    struct Joint {
        Vec3 at;
        double radius;
        uint32_t part;
        uint32_t heir = no_number;  // what it was contracted to or cut off from; no_number: it is there
        uint32_t degree = 0;
        uint32_t first = no_number, last = no_number;  // ends, chained; those of bones that are gone are passed over
        uint32_t label = no_number;                    // who it is, for those who name joints
        uint32_t own_degree = no_number;               // before parts were connected; no_number: as it is now
        Hold hold = Hold::none;
    };
    struct Bone {
        uint32_t joints[2];
        uint32_t part;  // no_number: from one part to another
        bool gone;
    };

    explicit BoneGraph(Memory* memory) : joints_(memory), bones_(memory), ends_(memory) {}

    std::pmr::vector<Joint>& joints() { return joints_; }
    const std::pmr::vector<Joint>& joints() const { return joints_; }
    const std::pmr::vector<Bone>& bones() const { return bones_; }

    bool is_there(uint32_t joint) const { return joints_[joint].heir == no_number; }
    // The joint that stands for this one.
    uint32_t heir(uint32_t joint) const;
    uint32_t other(uint32_t bone, uint32_t joint) const {
        const auto& ends = bones_[bone].joints;
        return ends[0] == joint ? ends[1] : ends[0];
    }
    double length(uint32_t bone) const;
    // Whether its part ends or forks here; whether it forks.
    bool is_end(uint32_t joint) const { return own_degree(joint) != 2; }
    bool is_junction(uint32_t joint) const { return own_degree(joint) > 2; }
    // The bone between two joints, no_number: there is none. Linear in the first one's bones.
    uint32_t bone_between(uint32_t a, uint32_t b) const;

    uint32_t add_joint(const Vec3& at, double radius, uint32_t part);
    uint32_t add_bone(uint32_t a, uint32_t b, uint32_t part);
    // A new joint on a bone, which ends there from now on; a new bone goes on. Returns the joint.
    uint32_t split(uint32_t bone, const Vec3& at, double radius);
    // Makes both ends of a bone one: `kept`. Linear in the bones of the other one.
    void contract(uint32_t bone, uint32_t kept);
    // A bone of joint `from` becomes one of joint `to`.
    void hang_on(uint32_t bone, uint32_t from, uint32_t to);
    // Removes a joint of degree 1, with its bone.
    void cut_off(uint32_t joint);

    // Adds `other`, whose joints come after those of `graph`.
    static Task<void> append(Pace& pace, BoneGraph& graph, const BoneGraph& other);

    // What comes after an end of the joint's list that is there; begin with first_end.
    uint32_t first_end(uint32_t joint) const { return skip(joints_[joint].first); }
    uint32_t next_end(uint32_t end) const { return skip(ends_[end]); }
    // The same with those that are gone, which may be many; begin with the joint's first.
    uint32_t next_listed(uint32_t end) const { return ends_[end]; }
    static uint32_t bone_of(uint32_t end) { return end / 2; }

    // From a joint along a bone over joints of two bones to the first one that is none: that joint, the last bone, the
    // length, and the part of all bones on the way, no_number if they are of several.
    struct Walk {
        uint32_t joint, bone, part;
        double length;
    };
    Walk begin_walk(uint32_t joint, uint32_t bone) const;
    // One bone further; false at the end.
    bool go_on(Walk& walk) const;

private:
    uint32_t skip(uint32_t end) const {
        while (end != no_number && bones_[end / 2].gone) end = ends_[end];
        return end;
    }
    void link(uint32_t joint, uint32_t end);
    uint32_t own_degree(uint32_t joint) const {
        const Joint& j = joints_[joint];
        return j.own_degree == no_number ? j.degree : j.own_degree;
    }

    std::pmr::vector<Joint> joints_;
    std::pmr::vector<Bone> bones_;
    std::pmr::vector<uint32_t> ends_;  // two a bone: the next end at the same joint
};

struct OrderedBones {
    BoneTree tree;
    Buffer<uint32_t> number;  // in the tree, by joint of the graph; no_joint: it is gone
};

// A tree for each root, which is a joint that is there. Takes about 0.1 us a joint.
Task<OrderedBones> order_bones(Pace& pace, const BoneGraph& graph, std::span<const uint32_t> roots);

}  // namespace flg
