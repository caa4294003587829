// SPDX-License-Identifier: MIT
#include "skeletons/rig.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <numbers>

namespace flg::studio {
namespace {

constexpr glm::quat kNoTurn(1.0f, 0.0f, 0.0f, 0.0f);

// The shortest turn of one direction into another.
glm::quat turn_between(const glm::vec3& from, const glm::vec3& to) {
    const float lengths = glm::length(from) * glm::length(to);
    if (!(lengths > 0.0f)) return kNoTurn;
    const glm::vec3 axis = glm::cross(from, to) / lengths;
    const float cosine = glm::dot(from, to) / lengths;
    if (cosine < -0.9999f) return kNoTurn;  // either way round: left to the other joints
    return glm::normalize(glm::quat(1.0f + cosine, axis.x, axis.y, axis.z));
}

glm::quat parent_turn(const Rig& rig, const PosedJoints& joints, uint32_t joint) {
    const uint32_t parent = rig.parents[joint];
    return parent == FLG_NO_INDEX ? kNoTurn : joints.turned[parent];
}

}  // namespace

size_t Rig::bone_count() const {
    return count() - static_cast<size_t>(std::count(parents.begin(), parents.end(), FLG_NO_INDEX));
}

Rig rig_of(const FlgModelView& model, std::span<const uint32_t> sources) {
    Rig rig;
    rig.size = model.size;
    rig.child_counts.assign(model.joint_count, 0);
    for (uint32_t j = 0; j < model.joint_count; ++j) {
        rig.rest.push_back(glm::make_vec3(model.joint_positions + 3 * size_t{j}));
        rig.radii.push_back(model.joint_radii[j]);
        rig.parents.push_back(model.joint_parents[j]);
        rig.parts.push_back(sources[model.part_sources[model.joint_parts[j]]]);
        rig.names.emplace_back(model.joint_names[j]);
        rig.keys.emplace_back(model.joint_keys[j]);
        rig.places.push_back(glm::make_vec3(model.joint_places + 3 * size_t{j}));
        rig.pinned.push_back(model.joint_pinned[j] != 0);
        rig.is_image.push_back(model.part_mirrored[model.joint_parts[j]] != 0);
        if (rig.parents[j] != FLG_NO_INDEX) ++rig.child_counts[rig.parents[j]];
    }
    return rig;
}

std::vector<glm::quat> turns_of(const Rig& rig, const Pose& pose) {
    std::vector<glm::quat> turns(rig.count(), kNoTurn);
    for (size_t j = 0; j < rig.count(); ++j) {
        const auto found = pose.turns.find(rig.keys[j]);
        if (found != pose.turns.end()) turns[j] = found->second;
    }
    return turns;
}

void set_turns(Pose& pose, const Rig& rig, std::span<const glm::quat> turns) {
    for (size_t j = 0; j < rig.count(); ++j) {
        if (std::abs(turns[j].w) > 0.9999999f)
            pose.turns.erase(rig.keys[j]);
        else
            pose.turns[rig.keys[j]] = turns[j];
    }
}

PosedJoints posed(const Rig& rig, std::span<const glm::quat> turns, const glm::vec3& shift) {
    PosedJoints joints;
    for (size_t j = 0; j < rig.count(); ++j) {
        const uint32_t parent = rig.parents[j];
        if (parent == FLG_NO_INDEX) {
            joints.at.push_back(rig.rest[j] + shift);
            joints.turned.push_back(turns[j]);
        } else {
            joints.at.push_back(joints.at[parent] + joints.turned[parent] * (rig.rest[j] - rig.rest[parent]));
            joints.turned.push_back(glm::normalize(joints.turned[parent] * turns[j]));
        }
    }
    return joints;
}

std::vector<uint32_t> chain_of(const Rig& rig, uint32_t joint) {
    std::vector<uint32_t> chain;
    for (uint32_t at = rig.parents[joint]; at != FLG_NO_INDEX; at = rig.parents[at]) {
        if (!chain.empty() && rig.child_counts[at] > 1) break;
        chain.push_back(at);
    }
    return chain;
}

void pull(const Rig& rig, Pose& pose, uint32_t joint, const glm::vec3& to) {
    constexpr int kRounds = 40;
    constexpr float kShare = 0.6f;  // of the way to where a joint alone would go, so that all of the chain bends
    std::vector<glm::quat> turns = turns_of(rig, pose);
    const PosedJoints before = posed(rig, turns, pose.shift);
    const std::vector<uint32_t> chain = chain_of(rig, joint);
    if (chain.empty()) {
        pose.shift += to - before.at[joint];
        return;
    }
    std::vector<glm::vec3> at;  // of the joint, then of the chain
    std::vector<glm::quat> turned;
    at.push_back(before.at[joint]);
    for (const uint32_t link : chain) {
        at.push_back(before.at[link]);
        turned.push_back(before.turned[link]);
    }
    for (int round = 0; round < kRounds && glm::distance(at[0], to) > 1e-4f * rig.size; ++round) {
        for (size_t k = 0; k < chain.size(); ++k) {
            const glm::quat whole = turn_between(at[0] - at[k + 1], to - at[k + 1]);
            const glm::quat turn = chain.size() == 1 ? whole : glm::slerp(kNoTurn, whole, kShare);
            for (size_t below = 0; below <= k; ++below) {
                at[below] = at[k + 1] + turn * (at[below] - at[k + 1]);
                turned[below] = glm::normalize(turn * turned[below]);
            }
        }
    }
    for (size_t k = 0; k < chain.size(); ++k) {
        const glm::quat above = k + 1 < chain.size() ? turned[k + 1] : parent_turn(rig, before, chain[k]);
        turns[chain[k]] = glm::normalize(glm::inverse(above) * turned[k]);
    }
    set_turns(pose, rig, turns);
}

void twist(const Rig& rig, Pose& pose, uint32_t joint, float angle_rad) {
    std::vector<glm::quat> turns = turns_of(rig, pose);
    const PosedJoints joints = posed(rig, turns, pose.shift);
    const uint32_t parent = rig.parents[joint];
    const uint32_t turning = parent == FLG_NO_INDEX ? joint : parent;
    glm::vec3 axis(0.0f, 1.0f, 0.0f);
    if (parent != FLG_NO_INDEX) axis = joints.at[joint] - joints.at[parent];
    if (!(glm::length(axis) > 0.0f)) return;
    const glm::quat turn = glm::angleAxis(angle_rad, glm::normalize(axis));
    turns[turning] = glm::normalize(glm::inverse(parent_turn(rig, joints, turning)) * turn * joints.turned[turning]);
    set_turns(pose, rig, turns);
}

}  // namespace flg::studio
