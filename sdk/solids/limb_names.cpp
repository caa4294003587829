// SPDX-License-Identifier: MIT
#include "solids/limb_names.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "rigs/limb_roles.h"

namespace flg {

namespace {

constexpr size_t most_joints = 128;  // that one slice has time for
constexpr uint32_t nothing = FLG_NO_INDEX;
constexpr double height_counts = 0.3;  // of a head against its thickness

using Roles = std::pmr::vector<FlgRigJoint>;

struct Joints {
    explicit Joints(const BoneTree& tree, Memory* memory) : at(memory), radii(memory), parents(memory) {
        for (const BoneJoint& joint : tree.joints) {
            at.push_back(joint.at);
            radii.push_back(joint.radius);
            parents.push_back(joint.parent == no_joint ? nothing : joint.parent);
        }
    }
    std::pmr::vector<Vec3> at;
    std::pmr::vector<double> radii;
    std::pmr::vector<uint32_t> parents;
};

uint32_t count_legs(const Roles& roles) {
    return static_cast<uint32_t>(std::count_if(roles.begin(), roles.end(), [](const FlgRigJoint& role) {
        return role.limb == FLG_LIMB_LEG && role.index == 0;
    }));
}

// How much of a head what is called so is, wherever it looks.
double headness(const Joints& joints, const Roles& roles, const Vec3& up) {
    double bulk = 0, height = 0, count = 0;
    for (uint32_t j = 0; j < roles.size(); ++j) {
        if (roles[j].limb != FLG_LIMB_HEAD && roles[j].limb != FLG_LIMB_NECK) continue;
        bulk += std::pow(joints.radii[j], 3);
        height += up.dot(joints.at[j] - joints.at[0]);
        count += 1;
    }
    return count > 0 ? std::cbrt(bulk) + height_counts * height / count : 0;
}

// How far the feet, or the head of what has none or stands on four and more, are in front.
double looks_forward(const Joints& joints, const Roles& roles, const Vec3& forward) {
    double head = 0, feet = 0;
    for (uint32_t j = 0; j < roles.size(); ++j) {
        if (roles[j].limb == FLG_LIMB_HEAD) head = forward.dot(joints.at[j] - joints.at[0]);
        const bool is_foot = roles[j].limb == FLG_LIMB_LEG && roles[j].next == nothing && roles[j].index > 0;
        if (is_foot) feet += forward.dot(joints.at[j] - joints.at[joints.parents[j]]);
    }
    return count_legs(roles) == 2 ? feet : head;
}

// Whether the model looks to the other side: its head, as it would be found there, is more of one.
bool looks_back(const Joints& joints, const Roles& roles, const RigFrame& frame, const Roles& turned,
                const RigFrame& turned_frame) {
    if (count_legs(roles) > 2) {
        const double own = headness(joints, roles, frame.up), other = headness(joints, turned, frame.up);
        if (own != other) return other > own;
    }
    return looks_forward(joints, roles, frame.forward) < looks_forward(joints, turned, turned_frame.forward);
}

void append_number(std::pmr::string& text, uint32_t number) {
    std::array<char, 16> digits{};
    text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

std::pmr::string limb_name(const FlgRigJoint& role, uint32_t other, Memory* memory) {
    static constexpr const char* names[] = {"body", "neck", "head", "arm", "leg", "tail", "limb"};
    std::pmr::string name(names[role.limb], memory);
    if (role.limb == FLG_LIMB_LEG && role.pair > 0) append_number(name, role.pair + 1);
    if (role.limb == FLG_LIMB_OTHER) append_number(name, other);
    return name;
}

}  // namespace

NamedLimbs name_limbs(BoneTree& tree, const Vec3& up, const Vec3& left, bool is_found, Memory* memory) {
    NamedLimbs out(memory);
    Roles roles(tree.joints.size(), memory);
    const bool has_roles = tree.joints.size() <= most_joints;
    if (has_roles) {
        const Joints joints(tree, memory);
        const RigSkeleton skeleton{joints.at, joints.radii, joints.parents};
        RigFrame frame = find_limbs(skeleton, up, left, roles, memory);
        if (is_found && left.norm() > 0) {
            Roles turned(roles.size(), memory);
            const RigFrame other = find_limbs(skeleton, up, -left, turned, memory);
            if (looks_back(joints, roles, frame, turned, other)) {
                roles = std::move(turned);
                frame = other;
            }
        }
        out.left = frame.left;
    }
    std::pmr::vector<std::pmr::string> part_names(memory);
    std::pmr::vector<uint32_t> others(tree.joints.size(), 0, memory), count(memory);
    uint32_t other = 0;
    for (uint32_t j = 0; j < tree.joints.size(); ++j) {
        BoneJoint& joint = tree.joints[j];
        const FlgRigJoint& role = roles[j];
        if (role.limb == FLG_LIMB_OTHER) {
            const bool goes_on =
                joint.parent != no_joint && roles[joint.parent].limb == FLG_LIMB_OTHER && roles[joint.parent].next == j;
            // What is on the other side has the same number.
            uint32_t twin = nothing;
            for (uint32_t k = 0; k < j && !goes_on && role.side != 0; ++k) {
                const Vec3 across = out.left.dot(joint.at - tree.joints[k].at) * out.left;
                const bool is_image = roles[k].limb == FLG_LIMB_OTHER && roles[k].side == -role.side &&
                                      (tree.joints[k].at + across - joint.at).norm() < 1e-3 * joint.radius;
                if (is_image) twin = k;
            }
            others[j] = goes_on ? others[joint.parent] : twin != nothing ? others[twin] : other++;
        }
        std::pmr::string part = limb_name(role, others[j], memory);
        const char* const side = role.side > 0 ? ".L" : role.side < 0 ? ".R" : "";
        std::pmr::string whole(part, memory);
        whole += side;
        auto number =
            static_cast<uint32_t>(std::find(part_names.begin(), part_names.end(), whole) - part_names.begin());
        if (number == part_names.size()) {
            part_names.push_back(whole);
            count.push_back(0);
        }
        joint.part = number;
        std::pmr::string& name = out.names.emplace_back(part);
        name += '_';
        append_number(name, count[number]++);
        name += side;
    }
    return out;
}

}  // namespace flg
