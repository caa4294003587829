// SPDX-License-Identifier: MIT
#include "bones/bone_graph.h"

#include "runtime/each.h"

namespace flg {

uint32_t BoneGraph::heir(uint32_t joint) const {
    while (joints_[joint].heir != no_number) joint = joints_[joint].heir;
    return joint;
}

double BoneGraph::length(uint32_t bone) const {
    return (joints_[bones_[bone].joints[0]].at - joints_[bones_[bone].joints[1]].at).norm();
}

uint32_t BoneGraph::bone_between(uint32_t a, uint32_t b) const {
    uint32_t end = first_end(a);
    while (end != no_number && other(bone_of(end), a) != b) end = next_end(end);
    return end == no_number ? no_number : bone_of(end);
}

uint32_t BoneGraph::add_joint(const Vec3& at, double radius, uint32_t part) {
    Joint joint;
    joint.at = at, joint.radius = radius, joint.part = part;
    joints_.push_back(joint);
    return static_cast<uint32_t>(joints_.size()) - 1;
}

void BoneGraph::link(uint32_t joint, uint32_t end) {
    Joint& j = joints_[joint];
    ends_[end] = no_number;
    (j.first == no_number ? j.first : ends_[j.last]) = end;
    j.last = end;
    ++j.degree;
}

uint32_t BoneGraph::add_bone(uint32_t a, uint32_t b, uint32_t part) {
    const auto bone = static_cast<uint32_t>(bones_.size());
    bones_.push_back({{a, b}, part, false});
    ends_.resize(ends_.size() + 2);
    link(a, 2 * bone);
    link(b, 2 * bone + 1);
    return bone;
}

uint32_t BoneGraph::split(uint32_t bone, const Vec3& at, double radius) {
    const Bone old = bones_[bone];
    bones_[bone].gone = true;
    for (const uint32_t joint : old.joints) --joints_[joint].degree;
    const uint32_t part = old.part == no_number ? joints_[old.joints[0]].part : old.part;
    const uint32_t joint = add_joint(at, radius, part);
    joints_[joint].own_degree = 2;
    add_bone(old.joints[0], joint, old.part);
    add_bone(joint, old.joints[1], old.part);
    return joint;
}

void BoneGraph::contract(uint32_t bone, uint32_t kept) {
    const uint32_t dropped = other(bone, kept);
    Joint &k = joints_[kept], &d = joints_[dropped];
    bones_[bone].gone = true;
    for (uint32_t end = first_end(dropped); end != no_number; end = next_end(end))
        bones_[end / 2].joints[end % 2] = kept;
    ends_[k.last] = d.first;
    k.last = d.last;
    k.degree += d.degree - 2;
    d.heir = kept;
}

void BoneGraph::hang_on(uint32_t bone, uint32_t from, uint32_t to) {
    const uint32_t rest = other(bone, from), part = bones_[bone].part;
    bones_[bone].gone = true;
    --joints_[from].degree;
    --joints_[rest].degree;
    add_bone(to, rest, part);
}

Task<void> BoneGraph::append(Pace& pace, BoneGraph& graph, const BoneGraph& other) {
    const auto joints = static_cast<uint32_t>(graph.joints_.size()), bones = static_cast<uint32_t>(graph.bones_.size());
    const auto moved = [](uint32_t number, uint32_t by) { return number == no_number ? no_number : number + by; };
    graph.joints_.resize(joints + other.joints_.size());
    graph.bones_.resize(bones + other.bones_.size());
    graph.ends_.resize(graph.ends_.size() + other.ends_.size());
    co_await each(pace, other.joints_.size(), Cost::tens_of_ns, [&](uint32_t j) {
        Joint& joint = graph.joints_[joints + j] = other.joints_[j];
        joint.heir = moved(joint.heir, joints);
        joint.first = moved(joint.first, 2 * bones);
        joint.last = moved(joint.last, 2 * bones);
    });
    co_await each(pace, other.bones_.size(), Cost::tens_of_ns, [&](uint32_t b) {
        const Bone& bone = other.bones_[b];
        graph.bones_[bones + b] = {{bone.joints[0] + joints, bone.joints[1] + joints}, bone.part, bone.gone};
        for (const uint32_t end : {2 * b, 2 * b + 1}) graph.ends_[2 * bones + end] = moved(other.ends_[end], 2 * bones);
    });
}

void BoneGraph::cut_off(uint32_t joint) {
    const uint32_t bone = bone_of(first_end(joint)), rest = other(bone, joint);
    bones_[bone].gone = true;
    --joints_[rest].degree;
    joints_[joint].heir = rest;
}

BoneGraph::Walk BoneGraph::begin_walk(uint32_t joint, uint32_t bone) const {
    return {other(bone, joint), bone, bones_[bone].part, length(bone)};
}

bool BoneGraph::go_on(Walk& walk) const {
    if (joints_[walk.joint].degree != 2) return false;
    const uint32_t first = first_end(walk.joint);
    walk.bone = bone_of(bone_of(first) == walk.bone ? next_end(first) : first);
    walk.joint = other(walk.bone, walk.joint);
    walk.length += length(walk.bone);
    if (bones_[walk.bone].part != walk.part) walk.part = no_number;
    return true;
}

namespace {

// A joint on the way from the root, and the end of its bones that is looked at next.
struct Step {
    uint32_t joint, end;
};

}  // namespace

Task<OrderedBones> order_bones(Pace& pace, const BoneGraph& graph, std::span<const uint32_t> roots) {
    const auto& joints = graph.joints();
    OrderedBones out{BoneTree(pace.memory()), Buffer<uint32_t>(joints.size(), pace.memory())};
    uint32_t count = 0;
    co_await each(pace, joints.size(), Cost::some_ns, [&](uint32_t j) {
        out.number[j] = no_joint;
        count += graph.is_there(j);
    });
    out.tree.joints.reserve(count);
    std::pmr::vector<Step> way(pace.memory());
    const auto visit = [&](uint32_t joint, uint32_t parent) {
        const BoneGraph::Joint& from = joints[joint];
        out.number[joint] = static_cast<uint32_t>(out.tree.joints.size());
        out.tree.joints.push_back({from.at, from.radius, parent, from.part});
        way.push_back({joint, graph.first_end(joint)});
    };
    size_t root = 0;
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (way.empty()) {
            if (root == roots.size()) return false;
            visit(roots[root++], no_joint);
            return true;
        }
        const Step step = way.back();
        if (step.end == no_number) {
            way.pop_back();
            return true;
        }
        way.back().end = graph.next_end(step.end);
        const uint32_t child = graph.other(BoneGraph::bone_of(step.end), step.joint);
        if (out.number[child] == no_joint) visit(child, out.number[step.joint]);
        return true;
    });
    co_return out;
}

}  // namespace flg
