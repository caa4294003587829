// SPDX-License-Identifier: MIT
// What the reader of skins fills: flat arrays, as in FlgSkinView and FlgSkinAnimation.
#pragma once

#include <cstdint>

#include "io/base/memory.h"
#include "io/base/mesh_data.h"

namespace flg::io {

constexpr uint32_t max_joints = 65535;
constexpr uint32_t joints_a_vertex = 4;

struct AnimationData {
    String name;
    Vector<float> times, rotations, translations;  // no translations: the roots stay
};

struct MorphTargetData {
    String name;
    Vector<float> moves, normal_moves;
};

struct MorphAnimationData {
    String name;
    Vector<float> times, weights;
    uint32_t animation = FLG_NO_INDEX;  // of the skin's
};

struct SkinData {
    Vector<float> positions, normals, weights;
    Vector<uint32_t> triangles, parts;
    Vector<uint32_t> triangle_parts;  // none: as vertices have it
    Vector<uint16_t> joints;
    Vector<float> joint_positions;
    Vector<uint32_t> joint_parents;
    Vector<String> joint_names;
    Vector<AnimationData> animations;
    Vector<MaterialData> materials;  // by part, one for all, or empty
    Vector<TextureData> textures;
    Vector<float> corner_uvs;  // 6 a triangle, or empty
    Vector<float> colors;      // 4 a vertex, or empty
    Vector<MorphTargetData> morphs;
    Vector<MorphAnimationData> morph_animations;
    Vector<String> warnings;

    size_t vertex_count() const { return positions.size() / 3; }
    size_t triangle_count() const { return triangles.size() / 3; }
};

}  // namespace flg::io
