// SPDX-License-Identifier: MIT
#include "bones/refinement.h"

#include <algorithm>
#include <queue>
#include <vector>

#include "runtime/each.h"

namespace flg {
namespace {

constexpr uint32_t contraction_work = 8;  // by a look at a bone
constexpr double as_wide = 1 - 1e-6;      // by the radius
constexpr uint32_t least_hub = 5;         // limbs

using Hold = BoneGraph::Hold;

// By part, the last ones the model's.
using Thresholds = std::span<const RefinementThresholds>;

const RefinementThresholds& of(Thresholds thresholds, uint32_t part) {
    return part == no_number ? thresholds.back() : thresholds[part];
}

bool is_junction(const BoneGraph& graph, uint32_t joint) {
    return graph.joints()[joint].degree >= 3;
}

bool is_pinned(const BoneGraph& graph, uint32_t joint) {
    return graph.joints()[joint].hold == Hold::pinned;
}

// A branch that becomes nothing.
struct Branch {
    uint32_t joint;  // one of its ends
    uint32_t way;    // its first bone; where it is pruned its other end
    // Where it joins junctions: the other one, and whether they are merged for its length.
    uint32_t other = no_number;
    bool is_short = true;
};

struct Junction {
    uint32_t joint;
    uint32_t cluster;  // another one that it becomes one with, itself: none
    uint32_t widest;   // of the cluster's, at the one that stands for it
    // The same: branches that leave it and are not pruned, how many junctions are as wide as that, and their middle.
    uint32_t limbs = 0, equals = 0;
    Vec3 middle = Vec3::Zero();
};

struct Junctions {
    Junctions(size_t joints, Memory* memory) : all(memory), number_of(joints, memory), branches(memory) {}

    uint32_t cluster(uint32_t junction) {
        while (all[junction].cluster != junction) junction = all[junction].cluster = all[all[junction].cluster].cluster;
        return junction;
    }
    void unite(uint32_t first, uint32_t second) {
        const uint32_t a = cluster(first), b = cluster(second);
        all[std::max(a, b)].cluster = std::min(a, b);
    }

    std::pmr::vector<Junction> all;
    Buffer<uint32_t> number_of;         // by joint
    std::pmr::vector<Branch> branches;  // between two of a cluster
};

// Whether one is within a share of the other's radius.
bool are_hub(const BoneGraph& graph, uint32_t a, uint32_t b, double share) {
    const BoneGraph::Joint &first = graph.joints()[a], &second = graph.joints()[b];
    return (first.at - second.at).norm() < share * std::max(first.radius, second.radius);
}

// Of hubs those that many limbs leave; branches that are short stay in any case.
Task<void> keep_hubs(Pace& pace, Junctions& junctions) {
    const auto whole = [&](uint32_t i) -> Junction& { return junctions.all[junctions.cluster(i)]; };
    co_await each(pace, junctions.all.size(), Cost::tens_of_ns, [&](uint32_t i) {
        if (const uint32_t cluster = junctions.cluster(i); cluster != i)
            junctions.all[cluster].limbs += junctions.all[i].limbs;
    });
    std::pmr::vector<Branch> kept(pace.memory());
    co_await each(pace, junctions.branches.size(), Cost::tens_of_ns, [&](uint32_t b) {
        const Branch& branch = junctions.branches[b];
        if (branch.is_short || whole(junctions.number_of[branch.joint]).limbs >= least_hub) kept.push_back(branch);
    });
    co_await each(pace, junctions.all.size(), Cost::some_ns, [&](uint32_t i) { junctions.all[i].cluster = i; });
    junctions.branches = std::move(kept);
    co_await each(pace, junctions.branches.size(), Cost::tens_of_ns, [&](uint32_t b) {
        const Branch& branch = junctions.branches[b];
        junctions.unite(junctions.number_of[branch.joint], junctions.number_of[branch.other]);
    });
}

// Junctions, each with those at the other ends of its branches that are near.
Task<void> find_clusters(Pace& pace, const BoneGraph& graph, Thresholds thresholds, Junctions& junctions) {
    bool has_hubs = false;
    co_await each(pace, graph.joints().size(), Cost::some_ns, [&](uint32_t j) {
        if (!graph.is_there(j) || !is_junction(graph, j) || is_pinned(graph, j)) return;
        const auto number = static_cast<uint32_t>(junctions.all.size());
        junctions.number_of[j] = number;
        junctions.all.push_back({j, number, number});
    });
    Slice slice(Cost::tens_of_ns);
    for (uint32_t i = 0; i < junctions.all.size(); ++i) {
        const uint32_t joint = junctions.all[i].joint;
        for (uint32_t end = graph.first_end(joint); end != no_number; end = graph.next_end(end)) {
            const uint32_t bone = BoneGraph::bone_of(end);
            BoneGraph::Walk walk = graph.begin_walk(joint, bone);
            bool is_held = false;
            do {
                is_held = is_held || is_pinned(graph, walk.joint);
                if (slice.is_over()) co_await pace;
            } while (graph.go_on(walk));
            const RefinementThresholds& own = of(thresholds, walk.part);
            const bool is_short = walk.length < own.merge;
            const bool joins =
                !is_held && is_junction(graph, walk.joint) && (is_short || are_hub(graph, joint, walk.joint, own.hub));
            if (!joins && (is_junction(graph, walk.joint) || walk.length >= own.prune)) ++junctions.all[i].limbs;
            if (!joins || walk.joint < joint) continue;
            junctions.branches.push_back({joint, bone, walk.joint, is_short});
            junctions.unite(i, junctions.number_of[walk.joint]);
            has_hubs = has_hubs || !is_short;
        }
    }
    if (has_hubs) co_await keep_hubs(pace, junctions);
}

Task<void> merge_junctions(Pace& pace, Thresholds thresholds, BoneGraph& graph) {
    Junctions junctions(graph.joints().size(), pace.memory());
    co_await find_clusters(pace, graph, thresholds, junctions);
    if (junctions.branches.empty()) co_return;
    const auto radius = [&](uint32_t i) { return graph.joints()[junctions.all[i].joint].radius; };
    co_await each(pace, junctions.all.size(), Cost::tens_of_ns, [&](uint32_t i) {
        uint32_t& widest = junctions.all[junctions.cluster(i)].widest;
        const auto is_middle = [&](uint32_t k) { return graph.joints()[junctions.all[k].joint].hold == Hold::middle; };
        const bool is_equal = radius(i) >= as_wide * radius(widest) && radius(widest) >= as_wide * radius(i);
        if (is_equal ? is_middle(i) && !is_middle(widest) : radius(i) > radius(widest)) widest = i;
    });
    co_await each(pace, junctions.all.size(), Cost::tens_of_ns, [&](uint32_t i) {
        Junction& whole = junctions.all[junctions.cluster(i)];
        if (radius(i) < as_wide * radius(whole.widest)) return;
        ++whole.equals;
        whole.middle += graph.joints()[junctions.all[i].joint].at;
    });
    Slice slice(Cost::tens_of_ns);
    for (const Branch& branch : junctions.branches) {
        const uint32_t kept = graph.heir(branch.joint);
        for (uint32_t bone = branch.way; bone != no_number;) {
            const uint32_t dropped = graph.other(bone, kept), degree = graph.joints()[dropped].degree;
            uint32_t next = no_number;
            if (degree == 2) {
                const uint32_t first = graph.first_end(dropped);
                next = BoneGraph::bone_of(BoneGraph::bone_of(first) == bone ? graph.next_end(first) : first);
            }
            graph.contract(bone, kept);
            bone = next;
            if (slice.is_over(degree)) co_await pace;
        }
    }
    // Joints that were contracted still know where they were.
    co_await each(pace, junctions.all.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Junction& junction = junctions.all[i];
        if (junction.cluster != i) return;
        BoneGraph::Joint& joint = graph.joints()[graph.heir(junction.joint)];
        const BoneGraph::Joint& widest = graph.joints()[junctions.all[junction.widest].joint];
        const Vec3 middle = junction.middle / junction.equals;
        // The middle of two is inside of both of their balls, or not taken.
        const bool takes_middle =
            junction.equals > 1 && widest.hold != Hold::middle && (middle - widest.at).norm() <= widest.radius;
        joint.at = takes_middle ? middle : widest.at;
        joint.radius = widest.radius, joint.part = widest.part;
        joint.label = widest.label, joint.hold = widest.hold;
    });
}

// Whether a branch, from its end to where it begins, reaches beyond a ball by no more than a share of its radius: the
// end's ball, and the joints on the way.
Task<bool> bulges_only(Pace& pace, const BoneGraph& graph, uint32_t end, Vec3 centre, double radius, double share) {
    const double most = (1 + share) * radius;
    if ((graph.joints()[end].at - centre).norm() + graph.joints()[end].radius >= most) co_return false;
    BoneGraph::Walk walk = graph.begin_walk(end, BoneGraph::bone_of(graph.first_end(end)));
    Slice slice(Cost::tens_of_ns);
    for (uint32_t at = walk.joint; graph.go_on(walk); at = walk.joint) {
        if ((graph.joints()[at].at - centre).norm() >= most) co_return false;
        if (slice.is_over()) co_await pace;
    }
    co_return true;
}

// What is short, or else what bulges. True if there was any.
Task<bool> prune(Pace& pace, Thresholds thresholds, bool bulges, BoneGraph& graph) {
    std::pmr::vector<Branch> branches(pace.memory());
    Slice slice(Cost::tens_of_ns);
    for (uint32_t joint = 0; joint < graph.joints().size(); ++joint) {
        if (slice.is_over()) co_await pace;
        if (!graph.is_there(joint) || graph.joints()[joint].degree != 1) continue;
        BoneGraph::Walk walk = graph.begin_walk(joint, BoneGraph::bone_of(graph.first_end(joint)));
        bool is_held = is_pinned(graph, joint);
        for (uint32_t at = walk.joint; graph.go_on(walk); at = walk.joint) {
            is_held = is_held || is_pinned(graph, at);
            if (slice.is_over()) co_await pace;
        }
        const RefinementThresholds& own = of(thresholds, walk.part);
        bool is_short = !bulges && walk.length < own.prune;
        if (bulges && own.bulge > 0 && walk.part != no_number) {
            const BoneGraph::Joint& begin = graph.joints()[walk.joint];
            is_short = co_await bulges_only(pace, graph, joint, begin.at, begin.radius, own.bulge);
            if (!is_short && (begin.at - own.widest_at).norm() <= own.widest)
                is_short = co_await bulges_only(pace, graph, joint, own.widest_at, own.widest, own.bulge);
        }
        if (!is_held && is_junction(graph, walk.joint) && is_short) branches.push_back({joint, walk.joint});
    }
    for (const Branch& branch : branches) {
        for (uint32_t joint = branch.joint; joint != branch.way;) {
            const uint32_t next = graph.other(BoneGraph::bone_of(graph.first_end(joint)), joint);
            graph.cut_off(joint);
            joint = next;
            if (slice.is_over()) co_await pace;
        }
    }
    co_return !branches.empty();
}

// A bone and its length. In a queue the shortest comes first; then that with the lowest number.
struct RankedBone {
    double length;
    uint32_t bone;
    bool operator<(const RankedBone& other) const {
        return length != other.length ? length > other.length : bone > other.bone;
    }
};

Task<void> collapse(Pace& pace, Thresholds thresholds, BoneGraph& graph) {
    std::priority_queue<RankedBone, std::pmr::vector<RankedBone>> queue(std::less<RankedBone>(),
                                                                        std::pmr::vector<RankedBone>(pace.memory()));
    const auto add = [&](uint32_t bone) {
        const BoneGraph::Bone& b = graph.bones()[bone];
        if (b.gone || graph.joints()[b.joints[0]].degree < 2 || graph.joints()[b.joints[1]].degree < 2) return;
        if (is_pinned(graph, b.joints[0]) && is_pinned(graph, b.joints[1])) return;
        const double length = graph.length(bone);
        if (length < of(thresholds, b.part).collapse) queue.push({length, bone});
    };
    co_await each(pace, graph.bones().size(), Cost::tens_of_ns, add);
    Slice slice(Cost::tens_of_ns);
    while (!queue.empty()) {
        if (slice.is_over(contraction_work)) co_await pace;
        const RankedBone top = queue.top();
        queue.pop();
        const BoneGraph::Bone bone = graph.bones()[top.bone];
        if (bone.gone) continue;
        if (graph.length(top.bone) != top.length) {
            add(top.bone);
            continue;
        }
        const uint32_t a = bone.joints[0], b = bone.joints[1];
        bool keep_a = graph.joints()[a].radius >= graph.joints()[b].radius;
        if (is_junction(graph, a) != is_junction(graph, b)) keep_a = is_junction(graph, a);
        const Hold hold_a = graph.joints()[a].hold, hold_b = graph.joints()[b].hold;
        if (hold_a != hold_b) keep_a = hold_a > hold_b;
        const uint32_t kept = keep_a ? a : b;
        graph.contract(top.bone, kept);
        for (uint32_t end = graph.joints()[kept].first; end != no_number; end = graph.next_listed(end)) {
            add(BoneGraph::bone_of(end));
            if (slice.is_over()) co_await pace;
        }
    }
}

}  // namespace

Task<void> refine(Pace& pace, BoneGraph& graph, std::span<const RefinementThresholds> thresholds) {
    co_await prune(pace, thresholds, false, graph);
    co_await merge_junctions(pace, thresholds, graph);
    co_await prune(pace, thresholds, false, graph);
    for (bool goes_on = true; goes_on;) goes_on = co_await prune(pace, thresholds, true, graph);
    co_await collapse(pace, thresholds, graph);
}

}  // namespace flg
