// SPDX-License-Identifier: MIT
// Skinned models whose poses are known: a round bar of four joints, and a cross of four arms.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "filigree/filigree_model.h"

namespace flg::test {

constexpr float bar_radius = 0.25f;

// A skin with its memory.
struct TestSkin {
    std::vector<float> positions, normals, weights, joint_positions;
    std::vector<uint32_t> triangles, parts, parents;
    std::vector<uint16_t> joints;
    std::vector<std::string> names;
    std::vector<const char*> name_pointers;

    uint32_t vertex_count() const { return static_cast<uint32_t>(positions.size() / 3); }
    uint32_t joint_count() const { return static_cast<uint32_t>(parents.size()); }

    FlgSkinView view() {
        name_pointers.clear();
        for (const std::string& name : names) name_pointers.push_back(name.c_str());
        FlgSkinView view = {};
        view.struct_size = sizeof view;
        view.vertex_count = vertex_count();
        view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        view.joint_count = joint_count();
        view.positions = positions.data();
        view.normals = normals.data();
        view.triangles = triangles.data();
        view.vertex_joints = joints.data();
        view.vertex_weights = weights.data();
        view.vertex_parts = parts.data();
        view.joint_positions = joint_positions.data();
        view.joint_parents = parents.data();
        view.joint_names = name_pointers.data();
        return view;
    }

    uint32_t add_joint(float x, float y, float z, uint32_t parent, const std::string& name) {
        joint_positions.insert(joint_positions.end(), {x, y, z});
        parents.push_back(parent);
        names.push_back(name);
        return joint_count() - 1;
    }

    // Between two joints: `share` of 0 to 1 of the second; what there is most of comes first.
    void bind(uint32_t first, uint32_t second, float share) {
        const bool swapped = share > 0.5f;
        const float most = swapped ? share : 1 - share;
        const auto name = [&](uint32_t joint, float weight) { return static_cast<uint16_t>(weight > 0 ? joint : 0); };
        joints.insert(joints.end(),
                      {name(swapped ? second : first, 1), name(swapped ? first : second, 1 - most), 0, 0});
        weights.insert(weights.end(), {most, 1 - most, 0, 0});
    }

    // A round tube from `from` along the unit direction d, `rings` rings (the last at `length`) of `sides` vertices,
    // closed by a fan at both ends. chain[k] is the joint at k metres: it moves the metre from there, and blends with
    // the one before over half a metre on either side.
    void add_tube(const std::array<float, 3>& d, float length, uint32_t rings, uint32_t sides, uint32_t part,
                  const std::vector<uint32_t>& chain) {
        const std::array<float, 3> u = {d[1], d[2], d[0]};  // across an axis of the frame is another one
        const std::array<float, 3> v = {d[1] * u[2] - d[2] * u[1], d[2] * u[0] - d[0] * u[2],
                                        d[0] * u[1] - d[1] * u[0]};
        const auto add = [&](float along, float radius, const std::array<float, 3>& normal, float angle) {
            for (size_t i = 0; i < 3; ++i) {
                const float out = std::cos(angle) * u[i] + std::sin(angle) * v[i];
                positions.push_back(along * d[i] + radius * out);
                normals.push_back(radius > 0 ? out : normal[i]);
            }
            parts.push_back(part);
            const float last = static_cast<float>(chain.size() - 1);
            const float at = std::min(std::max(along - 0.5f, 0.0f), last);
            const uint32_t first = std::min(static_cast<uint32_t>(at), static_cast<uint32_t>(chain.size() - 1));
            const uint32_t second = std::min(first + 1, static_cast<uint32_t>(chain.size() - 1));
            bind(chain[first], chain[second], first == second ? 0 : at - static_cast<float>(first));
            return vertex_count() - 1;
        };
        const uint32_t start = vertex_count();
        const float step = 2 * 3.14159265f / static_cast<float>(sides);
        for (uint32_t ring = 0; ring < rings; ++ring) {
            const float along = length * static_cast<float>(ring) / static_cast<float>(rings - 1);
            for (uint32_t side = 0; side < sides; ++side) add(along, bar_radius, d, step * static_cast<float>(side));
        }
        const uint32_t low = add(0, 0, {-d[0], -d[1], -d[2]}, 0), high = add(length, 0, d, 0);
        for (uint32_t ring = 0; ring + 1 < rings; ++ring) {
            for (uint32_t side = 0; side < sides; ++side) {
                const uint32_t a = start + ring * sides + side, b = start + ring * sides + (side + 1) % sides;
                triangles.insert(triangles.end(), {a, b, b + sides, a, b + sides, a + sides});
            }
        }
        const uint32_t end = start + (rings - 1) * sides;
        for (uint32_t side = 0; side < sides; ++side) {
            const uint32_t next = (side + 1) % sides;
            triangles.insert(triangles.end(), {low, start + next, start + side, high, end + side, end + next});
        }
    }
};

// Four metres along x, joints at 0, 1, 2, 3 m.
inline TestSkin bar(uint32_t rings = 33, uint32_t sides = 16) {
    TestSkin skin;
    std::vector<uint32_t> chain;
    for (uint32_t j = 0; j < 4; ++j) {
        chain.push_back(
            skin.add_joint(static_cast<float>(j), 0, 0, j == 0 ? FLG_NO_INDEX : j - 1, "bar " + std::to_string(j)));
    }
    skin.add_tube({1, 0, 0}, 4, rings, sides, 0, chain);
    return skin;
}

// A root in the middle, arms of two metres along x, y, -x and -y of two joints each, each arm a part.
inline TestSkin cross(uint32_t rings = 17, uint32_t sides = 12) {
    TestSkin skin;
    const uint32_t root = skin.add_joint(0, 0, 0, FLG_NO_INDEX, "middle");
    uint32_t part = 0;
    for (const std::array<float, 3>& d : {std::array<float, 3>{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}) {
        const std::string name = "arm " + std::to_string(part);
        const uint32_t near = skin.add_joint(d[0], d[1], d[2], root, name + " near");
        const uint32_t far = skin.add_joint(2 * d[0], 2 * d[1], 2 * d[2], near, name + " far");
        skin.add_tube(d, 3, rings, sides, part++, {root, near, far});
    }
    return skin;
}

struct Quat {
    float x = 0, y = 0, z = 0, w = 1;
};

inline Quat about(std::array<float, 3> unit_axis, float angle) {
    const float s = std::sin(0.5f * angle);
    return {s * unit_axis[0], s * unit_axis[1], s * unit_axis[2], std::cos(0.5f * angle)};
}

// Rotations of a skin's joints, none turned.
inline std::vector<float> no_turns(uint32_t joint_count) {
    std::vector<float> rotations(4 * size_t{joint_count}, 0);
    for (size_t j = 0; j < joint_count; ++j) rotations[4 * j + 3] = 1;
    return rotations;
}

inline void turn(std::vector<float>& rotations, uint32_t joint, const Quat& q) {
    const float values[] = {q.x, q.y, q.z, q.w};
    for (size_t k = 0; k < 4; ++k) rotations[4 * size_t{joint} + k] = values[k];
}

// Keys of a skin's animation, with their memory.
struct TestAnimation {
    std::string name;
    std::vector<float> times, rotations, translations;

    FlgSkinAnimation view() const {
        FlgSkinAnimation view = {};
        view.struct_size = sizeof view;
        view.key_count = static_cast<uint32_t>(times.size());
        view.name = name.c_str();
        view.times = times.data();
        view.rotations = rotations.data();
        view.translations = translations.empty() ? nullptr : translations.data();
        return view;
    }
    void add_key(float time, const std::vector<float>& all_rotations) {
        times.push_back(time);
        rotations.insert(rotations.end(), all_rotations.begin(), all_rotations.end());
    }
};

// The bar curls up in two seconds: each joint but the root turns by up to `angle` about z.
inline TestAnimation curl(uint32_t joint_count, float angle = 0.9f) {
    TestAnimation animation{"curl", {}, {}, {}};
    for (int key = 0; key < 3; ++key) {
        std::vector<float> rotations = no_turns(joint_count);
        for (uint32_t j = 1; j < joint_count; ++j)
            turn(rotations, j, about({0, 0, 1}, 0.5f * angle * static_cast<float>(key)));
        animation.add_key(static_cast<float>(key), rotations);
    }
    return animation;
}

}  // namespace flg::test
