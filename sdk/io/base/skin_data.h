// SPDX-License-Identifier: MIT
// What the reader of skins fills: flat arrays, as in FlgSkinView and FlgSkinAnimation.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/base/mesh_data.h"

namespace flg::io {

constexpr uint32_t most_joints = 65535;
constexpr uint32_t joints_a_vertex = 4;

struct AnimationData {
    std::string name;
    std::vector<float> times, rotations, translations;  // no translations: the roots stay
};

struct SkinData {
    std::vector<float> positions, normals, weights;
    std::vector<uint32_t> triangles, parts;
    std::vector<uint16_t> joints;
    std::vector<float> joint_positions;
    std::vector<uint32_t> joint_parents;
    std::vector<std::string> joint_names;
    std::vector<AnimationData> animations;
    std::vector<MaterialData> materials;  // by part, one for all, or empty
    std::vector<std::string> warnings;

    size_t vertex_count() const { return positions.size() / 3; }
    size_t triangle_count() const { return triangles.size() / 3; }
};

}  // namespace flg::io
