// SPDX-License-Identifier: MIT
// Skeletons made coarser (Ma, Wang, Li, Zhang 2021, sec. 3.3), each step on whole models and, with other thresholds, on
// parts. Whatever they do a tree stays one, and never loses its last joint.
//
// - Merging: junctions with less than a threshold of bone between them become one, that with the largest radius.
// - Pruning: branches from a junction to an end that are shorter than a threshold are removed, all at once.
// - Collapsing: bones shorter than a threshold whose ends both have other bones are contracted, the shortest first, to
//   the end that is a junction, else to the one with the larger radius.
//
// A threshold of a part is for branches and bones that are all of it; what goes from part to part has the model's.
#pragma once

#include <queue>
#include <span>

#include "bones/bone_graph.h"

namespace flg {

struct RefinementThresholds {
    double merge, prune, collapse;  // lengths in the model's space
};

// A bone, or what it stands for, and its length. In a queue the shortest comes first; then that with the lowest number.
struct RankedBone {
    double length;
    uint32_t bone;
    bool operator<(const RankedBone& other) const {
        return length != other.length ? length > other.length : bone > other.bone;
    }
};

using BoneQueue = std::priority_queue<RankedBone, std::pmr::vector<RankedBone>>;

class RefinementKernel {
public:
    // thresholds[p] are those of part p, the last ones the model's. All outlive the kernel.
    RefinementKernel(BoneGraph& graph, std::span<const RefinementThresholds> thresholds, Memory* memory);

    // A unit is a bone or a branch looked at, merged, cut off or contracted: well below 1 us but for branches of very
    // many bones.
    bool run(uint32_t count);

private:
    enum class Pass { find, merge, choose, contract, place, find_ends, prune, collapse_queue, collapse, done };
    struct Junction {
        uint32_t joint;
        uint32_t cluster;  // another one that it becomes one with, itself: none
        uint32_t widest;   // of the cluster's, at the one that stands for it
    };
    struct Branch {
        uint32_t joint;  // one of its ends
        uint32_t way;    // its first bone; where it is pruned its other end
    };

    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    const RefinementThresholds& of(uint32_t part) const {
        return part == no_number ? thresholds_.back() : thresholds_[part];
    }
    bool is_junction(uint32_t joint) const { return graph_.joints()[joint].degree >= 3; }
    uint32_t cluster(uint32_t junction);
    void merge(uint32_t junction);
    void contract(const Branch& branch);
    void look_at_end(uint32_t joint);
    void prune(const Branch& branch);
    void queue_bone(uint32_t bone);
    void collapse();

    BoneGraph& graph_;
    std::span<const RefinementThresholds> thresholds_;
    std::pmr::vector<Junction> junctions_;
    std::pmr::vector<uint32_t> junction_of_;  // by joint
    std::pmr::vector<Branch> branches_;       // that become nothing
    BoneQueue queue_;
    Pass pass_ = Pass::find;
    uint32_t at_ = 0;
};

}  // namespace flg
