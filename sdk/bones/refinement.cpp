// SPDX-License-Identifier: MIT
#include "bones/refinement.h"

#include <algorithm>

namespace flg {

RefinementKernel::RefinementKernel(BoneGraph& graph, std::span<const RefinementThresholds> thresholds, Memory* memory)
    : graph_(graph),
      thresholds_(thresholds),
      junctions_(memory),
      junction_of_(graph.joints().size(), no_number, memory),
      branches_(memory),
      queue_(std::less<RankedBone>(), std::pmr::vector<RankedBone>(memory)) {}

bool RefinementKernel::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void RefinementKernel::step() {
    const auto joint_count = static_cast<uint32_t>(graph_.joints().size());
    const auto junction_count = static_cast<uint32_t>(junctions_.size());
    switch (pass_) {
        case Pass::find:
            if (at_ == joint_count) return enter(Pass::merge);
            if (graph_.is_there(at_) && is_junction(at_)) {
                junction_of_[at_] = junction_count;
                junctions_.push_back({at_, junction_count, junction_count});
            }
            ++at_;
            return;
        case Pass::merge:
            if (at_ == junction_count) return enter(Pass::choose);
            return merge(at_++);
        case Pass::choose: {
            if (at_ == junction_count) return enter(Pass::contract);
            uint32_t& widest = junctions_[cluster(at_)].widest;
            const auto radius = [&](uint32_t junction) { return graph_.joints()[junctions_[junction].joint].radius; };
            if (radius(at_) > radius(widest)) widest = at_;
            ++at_;
            return;
        }
        case Pass::contract:
            if (at_ == branches_.size()) return enter(Pass::place);
            return contract(branches_[at_++]);
        case Pass::place: {  // joints that were contracted still know where they were
            if (at_ == junction_count) {
                branches_.clear();
                return enter(Pass::find_ends);
            }
            const Junction& all = junctions_[at_];
            BoneGraph::Joint& joint = graph_.joints()[graph_.heir(all.joint)];
            const BoneGraph::Joint& widest = graph_.joints()[junctions_[all.widest].joint];
            if (all.cluster == at_++) joint.at = widest.at, joint.radius = widest.radius, joint.part = widest.part;
            return;
        }
        case Pass::find_ends:
            if (at_ == joint_count) return enter(Pass::prune);
            return look_at_end(at_++);
        case Pass::prune:
            if (at_ == branches_.size()) return enter(Pass::collapse_queue);
            return prune(branches_[at_++]);
        case Pass::collapse_queue:
            if (at_ == graph_.bones().size()) return enter(Pass::collapse);
            return queue_bone(at_++);
        case Pass::collapse: return collapse();
        case Pass::done: return;
    }
}

uint32_t RefinementKernel::cluster(uint32_t junction) {
    while (junctions_[junction].cluster != junction)
        junction = junctions_[junction].cluster = junctions_[junctions_[junction].cluster].cluster;
    return junction;
}

// A junction with those at the other ends of its branches.
void RefinementKernel::merge(uint32_t junction) {
    const uint32_t joint = junctions_[junction].joint;
    for (uint32_t end = graph_.first_end(joint); end != no_number; end = graph_.next_end(end)) {
        const uint32_t bone = BoneGraph::bone_of(end);
        const BoneGraph::Walk walk = graph_.walk(joint, bone);
        if (walk.joint < joint || !is_junction(walk.joint) || walk.length >= of(walk.part).merge) continue;
        branches_.push_back({joint, bone});
        const uint32_t a = cluster(junction), b = cluster(junction_of_[walk.joint]);
        junctions_[std::max(a, b)].cluster = std::min(a, b);
    }
}

void RefinementKernel::contract(const Branch& branch) {
    const uint32_t kept = graph_.heir(branch.joint);
    for (uint32_t bone = branch.way; bone != no_number;) {
        const uint32_t dropped = graph_.other(bone, kept);
        uint32_t next = no_number;
        if (graph_.joints()[dropped].degree == 2) {
            const uint32_t first = graph_.first_end(dropped);
            next = BoneGraph::bone_of(BoneGraph::bone_of(first) == bone ? graph_.next_end(first) : first);
        }
        graph_.contract(bone, kept);
        bone = next;
    }
}

void RefinementKernel::look_at_end(uint32_t joint) {
    if (!graph_.is_there(joint) || graph_.joints()[joint].degree != 1) return;
    const BoneGraph::Walk walk = graph_.walk(joint, BoneGraph::bone_of(graph_.first_end(joint)));
    if (is_junction(walk.joint) && walk.length < of(walk.part).prune) branches_.push_back({joint, walk.joint});
}

void RefinementKernel::prune(const Branch& branch) {
    for (uint32_t joint = branch.joint; joint != branch.way;) {
        const uint32_t next = graph_.other(BoneGraph::bone_of(graph_.first_end(joint)), joint);
        graph_.cut_off(joint);
        joint = next;
    }
}

void RefinementKernel::queue_bone(uint32_t bone) {
    const BoneGraph::Bone& b = graph_.bones()[bone];
    if (b.gone || graph_.joints()[b.joints[0]].degree < 2 || graph_.joints()[b.joints[1]].degree < 2) return;
    const double length = graph_.length(bone);
    if (length < of(b.part).collapse) queue_.push({length, bone});
}

void RefinementKernel::collapse() {
    if (queue_.empty()) return enter(Pass::done);
    const RankedBone top = queue_.top();
    queue_.pop();
    const BoneGraph::Bone& bone = graph_.bones()[top.bone];
    if (bone.gone) return;
    if (graph_.length(top.bone) != top.length) return queue_bone(top.bone);
    const uint32_t a = bone.joints[0], b = bone.joints[1];
    bool keep_a = graph_.joints()[a].radius >= graph_.joints()[b].radius;
    if (is_junction(a) != is_junction(b)) keep_a = is_junction(a);
    const uint32_t kept = keep_a ? a : b;
    graph_.contract(top.bone, kept);
    for (uint32_t end = graph_.first_end(kept); end != no_number; end = graph_.next_end(end))
        queue_bone(BoneGraph::bone_of(end));
}

}  // namespace flg
