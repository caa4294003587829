// SPDX-License-Identifier: MIT
// Skins of glTF files: what comes back of what was written, and what is not written.
#include <cmath>
#include <functional>

#include "io/skin_files.h"

namespace flg::test {
namespace {

// Of two animations, up to the sign of quaternions.
void expect_same(const TestAnimation& a, const TestAnimation& b) {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.times, b.times);
    ASSERT_EQ(a.rotations.size(), b.rotations.size());
    for (size_t i = 0; i < a.rotations.size(); i += 4) {
        double dot = 0;
        for (size_t k = 0; k < 4; ++k) dot += double{a.rotations[i + k]} * b.rotations[i + k];
        EXPECT_NEAR(std::abs(dot), 1, 1e-6) << i / 4;
    }
    ASSERT_EQ(a.translations.size(), b.translations.size());
    for (size_t i = 0; i < a.translations.size(); ++i) EXPECT_NEAR(a.translations[i], b.translations[i], 1e-6);
}

TEST(SkinFile, RoundTripKeepsEveryBitOfTheRest) {
    const Folder folder;
    TestSkin skin = bar();
    skin.joint_positions[4] = 0.1f;  // what a difference of floats can't hold
    skin.joint_positions[7] = -1e-7f;
    ASSERT_EQ(write_skin(folder.at("a.glb"), skin, {curl(4), TestAnimation{"still", {0.5f}, no_turns(4), {}}}), FLG_OK)
        << flgIoErrorGetMessage();
    EXPECT_EQ(folder.entries(), 1u);
    const ReadSkin read = read_skin(folder.at("a.glb"));
    ASSERT_EQ(read.result, FLG_OK) << read.error;
    EXPECT_EQ(read.warnings, "");
    EXPECT_EQ(read.skin.positions, skin.positions);
    EXPECT_EQ(read.skin.normals, skin.normals);
    EXPECT_EQ(read.skin.triangles, skin.triangles);
    EXPECT_EQ(read.skin.joints, skin.joints);
    EXPECT_EQ(read.skin.weights, skin.weights);
    EXPECT_EQ(read.skin.parts, skin.parts);
    EXPECT_EQ(read.skin.joint_positions, skin.joint_positions);
    EXPECT_EQ(read.skin.parents, skin.parents);
    EXPECT_EQ(read.skin.names, skin.names);
    EXPECT_TRUE(read.materials.empty());
    EXPECT_EQ(read.info.part_count, 1u);
    EXPECT_EQ(read.info.box_max[0], 4);
    ASSERT_EQ(read.animations.size(), 2u);
    expect_same(read.animations[0], curl(4));
    expect_same(read.animations[1], TestAnimation{"still", {0.5f}, no_turns(4), {}});
    // The same again: the same bytes.
    TestSkin again = read.skin;
    ASSERT_EQ(write_skin(folder.at("b.glb"), again), FLG_OK);
    ASSERT_EQ(write_skin(folder.at("c.glb"), skin), FLG_OK);
    EXPECT_EQ(slurp(folder.at("b.glb")), slurp(folder.at("c.glb")));
}

TEST(SkinFile, BranchesPartsMaterialsAndMovedRootsComeBack) {
    const Folder folder;
    TestSkin skin = cross();
    const TestAnimation sway = swaying_cross(skin);
    ASSERT_EQ(write_skin(folder.at("a.glb"), skin, {sway}, four_materials()), FLG_OK) << flgIoErrorGetMessage();
    const ReadSkin read = read_skin(folder.at("a.glb"));
    ASSERT_EQ(read.result, FLG_OK) << read.error;
    EXPECT_EQ(read.skin.positions, skin.positions);
    EXPECT_EQ(read.skin.parts, skin.parts);
    EXPECT_EQ(read.skin.triangles, skin.triangles);  // part by part as they were
    EXPECT_EQ(read.info.part_count, 4u);
    ASSERT_EQ(read.materials.size(), 4u);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(read.materials[i].color[i % 3], 0.75f);
        EXPECT_EQ(read.materials[i].roughness, four_materials()[i].roughness);
    }
    ASSERT_EQ(read.animations.size(), 1u);
    expect_same(read.animations[0], sway);
    // Two roots, and one material for all.
    skin.parents[3] = FLG_NO_INDEX;
    ASSERT_EQ(write_skin(folder.at("b.glb"), skin, {sway}, {four_materials()[1]}), FLG_OK) << flgIoErrorGetMessage();
    const ReadSkin two = read_skin(folder.at("b.glb"));
    ASSERT_EQ(two.result, FLG_OK) << two.error;
    EXPECT_EQ(two.skin.parents, skin.parents);
    EXPECT_EQ(two.materials.size(), 1u);
    expect_same(two.animations[0], sway);
}

// ---- Writing

class SkinRefusals : public ::testing::Test {
protected:
    std::string refusal(const std::function<void(FlgSkinView&, FlgSkinAnimation&, FlgSkinFileWriteDesc&)>& change,
                        const char* name = "a.glb") {
        FlgSkinView view = skin_.view();
        FlgSkinAnimation animation = animation_.view();
        FlgSkinFileWriteDesc desc = {};
        EXPECT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
        desc.skin = &view;
        desc.animations = &animation;
        desc.animation_count = 1;
        change(view, animation, desc);
        const std::string path = folder_.at(name);
        const FlgResult result = flgSkinFileWrite(path.c_str(), &desc);
        EXPECT_TRUE(result == FLG_ERROR_INVALID_ARGUMENT || result == FLG_ERROR_FORMAT) << result;
        EXPECT_EQ(folder_.entries(), 0u);
        const std::string error = flgIoErrorGetMessage();
        EXPECT_EQ(error.rfind(path + ":", 0), 0u) << error;
        return error.substr(std::min(error.size(), path.size() + 1));
    }
    std::string refusal() {
        return refusal([](auto&, auto&, auto&) {});
    }
    const Folder folder_;
    TestSkin skin_ = bar();
    TestAnimation animation_ = curl(4);
};

TEST_F(SkinRefusals, Arguments) {
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.struct_size = 4; }).rfind(" desc.skin: struct_size is 4", 0), 0u);
    EXPECT_EQ(refusal([](auto&, auto& a, auto&) { a.struct_size = 4; }).rfind(" desc.animations[0]: struct_size", 0),
              0u);
    EXPECT_EQ(refusal([](auto&, auto&, auto& d) { d.struct_size = 4; }).rfind(" desc: struct_size is 4", 0), 0u);
    EXPECT_EQ(refusal([](auto&, auto&, auto& d) { d.skin = nullptr; }), "desc.skin: is null");
    EXPECT_EQ(refusal([](auto&, auto&, auto& d) { d.animations = nullptr; }), "desc.animations: is null");
    EXPECT_EQ(refusal([](auto&, auto&, auto& d) { d.material_count = 1; }), "desc.materials: is null");
    EXPECT_EQ(refusal([](auto&, auto&, auto& d) { d.name = "\xff"; }), "desc.name: must be UTF-8 of at most 255 bytes");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.vertex_count = 0; }),
              "desc.skin.vertex_count: is 0, must be at least 1");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.triangle_count = 0; }),
              "desc.skin.triangle_count: is 0: there is nothing to write");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.joint_count = 0; }),
              "desc.skin.joint_count: is 0, must be 1 to 65535");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.positions = nullptr; }), "desc.skin.positions: is null");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.normals = nullptr; }), "desc.skin.normals: is null");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.vertex_joints = nullptr; }), "desc.skin.vertex_joints: is null");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.vertex_weights = nullptr; }), "desc.skin.vertex_weights: is null");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.triangles = nullptr; }), "desc.skin.triangles: is null");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.joint_positions = nullptr; }),
              "desc.skin.joint_positions: is null");
    EXPECT_EQ(refusal([](auto& v, auto&, auto&) { v.joint_parents = nullptr; }), "desc.skin.joint_parents: is null");
    EXPECT_NE(refusal([](auto&, auto&, auto&) {}, "a.ply").find("'.ply' is not .glb"), std::string::npos);
    EXPECT_EQ(flgSkinFileWrite(nullptr, nullptr), FLG_ERROR_INVALID_ARGUMENT);
}

TEST_F(SkinRefusals, Values) {
    const TestSkin sound = skin_;
    const auto changed = [&](const std::function<void(TestSkin&)>& change) {
        skin_ = sound;
        change(skin_);
        return refusal();
    };
    EXPECT_EQ(changed([](TestSkin& s) { s.joints[5] = 4; }),
              "desc.skin.vertex_joints[5]: is 4, but there are 4 joints");
    EXPECT_EQ(changed([](TestSkin& s) {
                  s.joints[4] = s.joints[5] = 1;
                  s.weights[4] = s.weights[5] = 0.5f;
              }),
              "desc.skin.vertex_joints[5]: is 1, which vertex 1 has already");
    EXPECT_EQ(changed([](TestSkin& s) { s.weights[4] = NAN; }), "desc.skin.vertex_weights[4]: is nan, must be 0 to 1");
    EXPECT_EQ(changed([](TestSkin& s) { s.weights[4] = 0.5f; }),
              "desc.skin.vertex_weights[4]: and the next three sum up to 0.5, must be 1");
    EXPECT_EQ(changed([](TestSkin& s) { s.triangles[3] = s.vertex_count(); }).rfind("desc.skin.triangles[3]: is ", 0),
              0u);
    EXPECT_EQ(changed([](TestSkin& s) { s.positions[2] = INFINITY; }).rfind("desc.skin.positions[2]: is inf", 0), 0u);
    EXPECT_EQ(changed([](TestSkin& s) { s.normals[2] = NAN; }).rfind("desc.skin.normals[2]: is nan", 0), 0u);
    EXPECT_EQ(changed([](TestSkin& s) { s.joint_positions[2] = NAN; }).rfind("desc.skin.joint_positions[2]: is nan", 0),
              0u);
    EXPECT_EQ(changed([](TestSkin& s) { s.parents[1] = 1; }),
              "desc.skin.joint_parents[1]: is 1, must be lower than the joint, or FLG_NO_INDEX");
    EXPECT_EQ(changed([](TestSkin& s) { s.names[1].back() = '\xfe'; }),
              "desc.skin.joint_names[1]: must be UTF-8 of at most 255 bytes");
    EXPECT_EQ(changed([](TestSkin& s) { s.parts[0] = 1u << 24; }).rfind("desc.skin.vertex_parts[0]: is 16777216", 0),
              0u);
}

TEST_F(SkinRefusals, Animations) {
    const TestAnimation sound = animation_;
    const auto changed = [&](const std::function<void(TestAnimation&)>& change) {
        animation_ = sound;
        change(animation_);
        return refusal();
    };
    EXPECT_EQ(changed([](TestAnimation& a) { a.times.clear(); }),
              "desc.animations[0].key_count: is 0, must be at least 1");
    EXPECT_EQ(changed([](TestAnimation& a) { a.times[2] = 1; }),
              "desc.animations[0].times[2]: is 1 after 1; times rise from 0 or later");
    EXPECT_EQ(changed([](TestAnimation& a) { a.times[0] = -2; }),
              "desc.animations[0].times[0]: is -2 after -1; times rise from 0 or later");
    EXPECT_EQ(changed([](TestAnimation& a) { a.rotations[7] = 3; }),
              "desc.animations[0].rotations[4]: starts a quaternion that is 3 long, must be 1");
    EXPECT_EQ(
        changed([](TestAnimation& a) { a.rotations[7] = NAN; }).rfind("desc.animations[0].rotations[7]: is nan", 0),
        0u);
    EXPECT_EQ(changed([](TestAnimation& a) {
                  a.translations.assign(9, INFINITY);
              }).rfind("desc.animations[0].translations[0]: is inf", 0),
              0u);
    EXPECT_EQ(refusal([](auto&, auto& a, auto&) { a.rotations = nullptr; }), "desc.animations[0].rotations: is null");
    EXPECT_EQ(refusal([](auto&, auto& a, auto&) { a.times = nullptr; }), "desc.animations[0].times: is null");
}

TEST_F(SkinRefusals, Materials) {
    skin_ = cross();
    animation_ = curl(skin_.joint_count());
    std::vector<FlgMeshMaterial> materials = four_materials();
    EXPECT_EQ(refusal([&](auto&, auto&, auto& d) {
                  d.materials = materials.data();
                  d.material_count = 3;
              }).rfind("desc.skin.vertex_parts[", 0),
              0u);
    materials[2].roughness = 2;
    EXPECT_EQ(refusal([&](auto&, auto&, auto& d) {
                  d.materials = materials.data();
                  d.material_count = 4;
              }),
              "desc.materials[2].roughness: is 2, must be from 0 to 1");
}

TEST(SkinFile, HostsStructsAreChecked) {
    const Folder folder;
    TestSkin skin = bar();
    ASSERT_EQ(write_skin(folder.at("a.glb"), skin), FLG_OK);
    FlgSkinFile file = nullptr;
    ASSERT_EQ(flgSkinFileRead(folder.at("a.glb").c_str(), nullptr, &file), FLG_OK);
    FlgSkinView view = {};
    EXPECT_EQ(flgSkinFileGetView(file, &view), FLG_ERROR_INVALID_ARGUMENT);  // no struct_size
    view.struct_size = sizeof view;
    EXPECT_EQ(flgSkinFileGetView(nullptr, &view), FLG_ERROR_INVALID_ARGUMENT);
    FlgSkinFileInfo info = {};
    EXPECT_EQ(flgSkinFileGetInfo(file, &info), FLG_ERROR_INVALID_ARGUMENT);
    FlgSkinAnimation animation{};
    animation.struct_size = sizeof animation;
    EXPECT_EQ(flgSkinFileGetAnimation(nullptr, 0, &animation), FLG_ERROR_INVALID_ARGUMENT);
    info.struct_size = sizeof info;
    EXPECT_EQ(flgSkinFileGetInfo(file, &info), FLG_OK);
    EXPECT_EQ(flgSkinFileGetAnimation(file, info.animation_count, &animation), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("but there are"), std::string::npos) << flgIoErrorGetMessage();
    FlgMeshMaterial material = flgMeshMaterialDefaults();
    EXPECT_EQ(flgSkinFileGetMaterial(file, info.material_count, &material), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_EQ(flgSkinFileGetMaterial(file, 0, nullptr), FLG_ERROR_INVALID_ARGUMENT);
    flgSkinFileRelease(file);
}

}  // namespace
}  // namespace flg::test
