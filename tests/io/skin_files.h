// SPDX-License-Identifier: MIT
// Skins written and read, and .glb files taken apart to be changed and broken.
#pragma once

#include <cstring>

#include "io/files.h"
#include "skins/test_skins.h"

namespace flg::test {

// A PNG file of one red pixel.
inline constexpr uint8_t red_pixel[] = {
    0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44, 0x52, 0x00, 0x00,
    0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x02, 0x00, 0x00, 0x00, 0x90, 0x77, 0x53, 0xde, 0x00, 0x00, 0x00,
    0x0c, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x38, 0x21, 0xa7, 0x01, 0x00, 0x02, 0xc0, 0x01, 0x0f, 0xe4,
    0xbd, 0x52, 0x15, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};

inline FlgResult write_skin(const std::string& path, TestSkin& skin, const std::vector<TestAnimation>& animations = {},
                            const std::vector<FlgMeshMaterial>& materials = {}) {
    const FlgSkinView view = skin.view();
    std::vector<FlgSkinAnimation> views;
    for (const TestAnimation& animation : animations) views.push_back(animation.view());
    FlgSkinFileWriteDesc desc = {};
    EXPECT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    desc.skin = &view;
    desc.animations = views.data();
    desc.animation_count = static_cast<uint32_t>(views.size());
    desc.materials = materials.data();
    desc.material_count = static_cast<uint32_t>(materials.size());
    return flgSkinFileWrite(path.c_str(), &desc);
}

// A skin read, with its arrays copied out.
struct ReadSkin {
    FlgResult result = FLG_OK;
    std::string error, warnings;
    bool has_skin = false;
    TestSkin skin;
    std::vector<TestAnimation> animations;
    std::vector<FlgMeshMaterial> materials;
    FlgSkinFileInfo info = {};
};

inline ReadSkin read_skin(const std::string& path) {
    ReadSkin read;
    FlgSkinFile file = nullptr;
    read.result = flgSkinFileRead(path.c_str(), nullptr, &file);
    read.has_skin = file != nullptr;
    if (read.result != FLG_OK) {
        EXPECT_EQ(file, nullptr);
        read.error = flgIoErrorGetMessage();
        EXPECT_EQ(read.error.rfind(path, 0), 0u) << read.error;
    }
    if (!file) return read;
    FlgSkinView view = {};
    view.struct_size = sizeof view;
    EXPECT_EQ(flgSkinFileGetView(file, &view), FLG_OK);
    TestSkin& skin = read.skin;
    const size_t vertices = view.vertex_count, joints = view.joint_count;
    skin.positions.assign(view.positions, view.positions + 3 * vertices);
    skin.normals.assign(view.normals, view.normals + 3 * vertices);
    skin.joints.assign(view.vertex_joints, view.vertex_joints + 4 * vertices);
    skin.weights.assign(view.vertex_weights, view.vertex_weights + 4 * vertices);
    skin.parts.assign(view.vertex_parts, view.vertex_parts + vertices);
    skin.triangles.assign(view.triangles, view.triangles + 3 * size_t{view.triangle_count});
    skin.joint_positions.assign(view.joint_positions, view.joint_positions + 3 * joints);
    skin.parents.assign(view.joint_parents, view.joint_parents + joints);
    for (size_t j = 0; j < joints; ++j) skin.names.emplace_back(view.joint_names[j]);
    read.info.struct_size = sizeof read.info;
    EXPECT_EQ(flgSkinFileGetInfo(file, &read.info), FLG_OK);
    for (uint32_t i = 0; i < read.info.animation_count; ++i) {
        FlgSkinAnimation a{};
        a.struct_size = sizeof a;
        EXPECT_EQ(flgSkinFileGetAnimation(file, i, &a), FLG_OK);
        TestAnimation& to = read.animations.emplace_back();
        to.name = a.name;
        to.times.assign(a.times, a.times + a.key_count);
        to.rotations.assign(a.rotations, a.rotations + 4 * joints * a.key_count);
        if (a.translations) to.translations.assign(a.translations, a.translations + 3 * size_t{a.key_count});
    }
    for (uint32_t i = 0; i < read.info.material_count; ++i) {
        EXPECT_EQ(flgSkinFileGetMaterial(file, i, &read.materials.emplace_back(flgMeshMaterialDefaults())), FLG_OK);
        read.materials.back().name = nullptr;
    }
    for (uint32_t i = 0; i < read.info.warning_count; ++i) read.warnings += std::string(read.info.warnings[i]) + "\n";
    flgSkinFileRelease(file);
    return read;
}

// The two chunks of a .glb file.
struct Glb {
    std::string json, binary;

    explicit Glb(const std::string& bytes) {
        const uint32_t json_size = word(bytes, 12);
        json = bytes.substr(20, json_size);
        binary = bytes.substr(28 + json_size, word(bytes, 20 + json_size));
    }
    static uint32_t word(const std::string& bytes, size_t at) {
        uint32_t value;
        std::memcpy(&value, bytes.data() + at, sizeof value);
        return value;
    }
    std::string bytes() const {
        std::string padded = json, whole;
        padded.resize((padded.size() + 3) / 4 * 4, ' ');
        const auto append = [&](uint32_t value) { whole.append(reinterpret_cast<const char*>(&value), sizeof value); };
        append(0x46546c67);
        append(2);
        append(static_cast<uint32_t>(28 + padded.size() + binary.size()));
        append(static_cast<uint32_t>(padded.size()));
        append(0x4e4f534a);
        whole += padded;
        append(static_cast<uint32_t>(binary.size()));
        append(0x004e4942);
        return whole + binary;
    }
    // The first place where `from` stands.
    Glb& replace(const std::string& from, const std::string& to) {
        const size_t at = json.find(from);
        EXPECT_NE(at, std::string::npos) << from << " is not in " << json;
        if (at != std::string::npos) json.replace(at, from.size(), to);
        return *this;
    }
    template <class T>
    Glb& put(size_t at, T value) {
        std::memcpy(binary.data() + at, &value, sizeof value);
        return *this;
    }
};

inline std::vector<FlgMeshMaterial> four_materials() {
    std::vector<FlgMeshMaterial> materials(4, flgMeshMaterialDefaults());
    for (size_t i = 0; i < 4; ++i) {
        std::fill_n(materials[i].color, 3, 0.0f);
        materials[i].color[i % 3] = 0.75f;
        materials[i].roughness = 0.25f * static_cast<float>(i);
    }
    return materials;
}

inline TestAnimation swaying_cross(const TestSkin& skin) {
    TestAnimation animation = curl(skin.joint_count());
    animation.name = "sway \"1\"";
    animation.translations = {0, 0, 0, 0.5f, 1, -2, 0, 0.25f, 0};
    return animation;
}

}  // namespace flg::test
