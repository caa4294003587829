// SPDX-License-Identifier: MIT
// Morph targets of skins, and what animates them, as files have them.
#include <gtest/gtest.h>

#include <cmath>

#include "io/skin_files.h"
#include "io/tinygltf_model.h"

namespace flg::test {
namespace {

// A bar that bulges at one vertex, and one that moves as a whole and is turned by a quarter about x.
struct Morphed {
    explicit Morphed(TestSkin& of_skin) : skin(of_skin), view(skin.view()), few(skin.positions.size()) {
        EXPECT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
        few[3] = 0.5f;
        few[5] = -0.25f;
        for (size_t v = 0; v < skin.vertex_count(); ++v) {
            const float *p = &skin.positions[3 * v], *n = &skin.normals[3 * v];
            all.insert(all.end(), {1, -p[2] - p[1], p[1] - p[2]});
            turned.insert(turned.end(), {0, -n[2] - n[1], n[1] - n[2]});
        }
        targets[0].name = "bulge";
        targets[0].moves = few.data();
        targets[1].moves = all.data();
        animation.name = "shapes";
        animation.key_count = 3;
        animation.times = times;
        animation.weights = weights;
        desc.skin = &view;
        desc.morphs = targets;
        desc.morph_count = 2;
        desc.morph_animations = &animation;
        desc.morph_animation_count = 1;
    }
    FlgResult write() const { return flgSkinFileWrite(path.c_str(), &desc); }
    std::string refusal() const {
        EXPECT_EQ(write(), FLG_ERROR_INVALID_ARGUMENT);
        const std::string message = flgIoErrorGetMessage();
        return message.substr(message.find("desc."));
    }

    const Folder folder;
    const std::string path = folder.at("skin.glb");
    TestSkin& skin;
    FlgSkinView view;
    std::vector<float> few, all, turned;
    FlgMorphTarget targets[2] = {flgMorphTargetDefaults(), flgMorphTargetDefaults()};
    float times[3] = {0, 0.5f, 2}, weights[6] = {0, 0, 1, -0.5f, 0, 2};
    FlgMorphAnimation animation = flgMorphAnimationDefaults();
    FlgSkinFileWriteDesc desc = {};
};

struct ReadFile {
    explicit ReadFile(const std::string& path) {
        EXPECT_EQ(flgSkinFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
        EXPECT_EQ(flgSkinFileGetInfo(file, &info), FLG_OK);
    }
    ~ReadFile() { flgSkinFileRelease(file); }
    FlgMorphTarget target(uint32_t index) const {
        FlgMorphTarget out = flgMorphTargetDefaults();
        EXPECT_EQ(flgSkinFileGetMorphTarget(file, index, &out), FLG_OK) << flgIoErrorGetMessage();
        return out;
    }
    FlgMorphAnimation animation(uint32_t index) const {
        FlgMorphAnimation out = flgMorphAnimationDefaults();
        EXPECT_EQ(flgSkinFileGetMorphAnimation(file, index, &out), FLG_OK) << flgIoErrorGetMessage();
        return out;
    }
    FlgSkinFile file = nullptr;
    FlgSkinFileInfo info = flgSkinFileInfoDefaults();
};

TEST(SkinMorphs, AreReadAsWritten) {
    TestSkin skin = bar();
    const Morphed morphed(skin);
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    const ReadFile read(morphed.path);
    EXPECT_EQ(read.info.warning_count, 0u) << read.info.warnings[0];
    EXPECT_EQ(read.info.animation_count, 0u);
    ASSERT_EQ(read.info.morph_count, 2u);
    EXPECT_STREQ(read.target(0).name, "bulge");
    EXPECT_STREQ(read.target(1).name, "target 1");
    for (size_t i = 0; i < skin.positions.size(); ++i) {
        EXPECT_EQ(read.target(0).moves[i], morphed.few[i]) << i;
        EXPECT_EQ(read.target(1).moves[i], morphed.all[i]) << i;
    }
    ASSERT_EQ(read.info.morph_animation_count, 1u);
    const FlgMorphAnimation animation = read.animation(0);
    EXPECT_STREQ(animation.name, "shapes");
    EXPECT_EQ(animation.animation, FLG_NO_INDEX);
    ASSERT_EQ(animation.key_count, 3u);
    EXPECT_TRUE(std::equal(animation.times, animation.times + 3, morphed.times));
    EXPECT_TRUE(std::equal(animation.weights, animation.weights + 6, morphed.weights));
}

TEST(SkinMorphs, NormalsTurnWithTheirTriangles) {
    TestSkin skin = bar();
    const Morphed morphed(skin);
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    const ReadFile read(morphed.path);
    for (size_t i = 0; i < morphed.turned.size(); ++i)
        EXPECT_NEAR(read.target(1).normal_moves[i], morphed.turned[i], 1e-5) << i;
    // What is far from the bulge keeps its normal to the bit.
    size_t still = 0;
    for (size_t v = 0; v < skin.vertex_count(); ++v) still += read.target(0).normal_moves[3 * v + 1] == 0;
    EXPECT_GT(still, skin.vertex_count() / 2);
}

TEST(SkinMorphs, FewThatMoveAreSparse) {
    TestSkin skin = bar();
    const Morphed morphed(skin);
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(morphed.path);
    const tinygltf::Primitive& primitive = model.meshes.at(0).primitives.at(0);
    ASSERT_EQ(primitive.targets.size(), 2u);
    const auto& bulge = model.accessors.at(static_cast<size_t>(primitive.targets[0].at("POSITION")));
    EXPECT_TRUE(bulge.sparse.isSparse);
    EXPECT_EQ(bulge.sparse.count, 1);
    EXPECT_EQ(bulge.maxValues.at(0), 0.5);
    EXPECT_EQ(bulge.minValues.at(2), -0.25);
    EXPECT_FALSE(model.accessors.at(static_cast<size_t>(primitive.targets[1].at("POSITION"))).sparse.isSparse);
    EXPECT_EQ(model.meshes[0].weights, std::vector<double>({0, 0}));
    ASSERT_EQ(model.animations.size(), 1u);
    EXPECT_EQ(model.animations[0].channels.at(0).target_path, "weights");
    EXPECT_EQ(model.animations[0].channels.at(0).target_node, 0);
}

TEST(SkinMorphs, JointsAndShapesMayMoveTogether) {
    TestSkin skin = bar();
    Morphed morphed(skin);
    const TestAnimation curled = curl(skin.joint_count());
    const FlgSkinAnimation joints = curled.view();
    morphed.desc.animations = &joints;
    morphed.desc.animation_count = 1;
    morphed.animation.animation = 0;
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    EXPECT_EQ(load_model(morphed.path).animations.size(), 1u);
    const ReadFile read(morphed.path);
    EXPECT_EQ(read.info.animation_count, 1u);
    ASSERT_EQ(read.info.morph_animation_count, 1u);
    EXPECT_EQ(read.animation(0).animation, 0u);
}

TEST(SkinMorphs, VerticesThatAreThereTwiceMoveTogether) {
    TestSkin skin = bar();
    Morphed morphed(skin);
    std::vector<float> uvs(6 * size_t{morphed.view.triangle_count});
    for (size_t i = 0; i < 6; ++i) uvs[i] = 0.5f;
    morphed.view.corner_uvs = uvs.data();
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    const ReadSkin read = read_skin(morphed.path);
    ASSERT_EQ(read.skin.vertex_count(), skin.vertex_count() + 3);
    const ReadFile file(morphed.path);
    for (size_t v = 0; v < read.skin.vertex_count(); ++v) {
        const float* p = &read.skin.positions[3 * v];
        EXPECT_EQ(file.target(1).moves[3 * v + 1], -p[2] - p[1]) << v;
    }
}

// Levels of detail have the same shapes, by the same weights.
TEST(SkinMorphs, LevelsOfDetailHaveThem) {
    TestSkin skin = bar(), coarse = bar(9, 6);
    Morphed morphed(skin);
    const FlgSkinView level = coarse.view();
    std::vector<float> up(coarse.positions.size()), aside(coarse.positions.size());
    for (size_t v = 0; v < coarse.vertex_count(); ++v) {
        up[3 * v + 1] = 1;
        aside[3 * v + 2] = static_cast<float>(v);
    }
    FlgMorphTarget of_level[2] = {flgMorphTargetDefaults(), flgMorphTargetDefaults()};
    of_level[0].moves = up.data();
    of_level[1].moves = aside.data();
    morphed.desc.levels = &level;
    morphed.desc.level_count = 1;
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    EXPECT_TRUE(load_model(morphed.path).meshes.at(1).primitives.at(0).targets.empty());
    morphed.desc.level_morphs = of_level;
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(morphed.path);
    const tinygltf::Mesh& mesh = model.meshes.at(1);
    ASSERT_EQ(mesh.primitives.at(0).targets.size(), 2u);
    EXPECT_EQ(mesh.extras, model.meshes[0].extras);
    const auto& moves = model.accessors.at(static_cast<size_t>(mesh.primitives[0].targets[1].at("POSITION")));
    EXPECT_EQ(moves.count, coarse.vertex_count());
    EXPECT_EQ(moves.maxValues.at(2), static_cast<double>(coarse.vertex_count() - 1));
    ASSERT_EQ(model.animations.size(), 1u);
    const auto& channels = model.animations[0].channels;
    ASSERT_EQ(channels.size(), 2u);
    EXPECT_EQ(channels[0].sampler, channels[1].sampler);
    EXPECT_EQ(model.nodes.at(static_cast<size_t>(channels[1].target_node)).mesh, 1);
    // Of the finest nothing changed.
    const ReadFile read(morphed.path);
    EXPECT_EQ(read.info.warning_count, 0u) << read.info.warnings[0];
    EXPECT_EQ(read.target(0).moves[3], 0.5f);
    EXPECT_EQ(read.info.morph_animation_count, 1u);
    aside[5] = NAN;
    EXPECT_EQ(morphed.refusal(), "desc.level_morphs[1].moves[5]: is nan, must be finite and at most 1e30 in size");
}

TEST(SkinMorphs, RefusalsNamePlaceAndValue) {
    TestSkin skin = bar();
    {
        Morphed morphed(skin);
        morphed.few[4] = NAN;
        EXPECT_EQ(morphed.refusal(), "desc.morphs[0].moves[4]: is nan, must be finite and at most 1e30 in size");
    }
    {
        Morphed morphed(skin);
        morphed.times[2] = 0.5f;
        EXPECT_EQ(morphed.refusal(), "desc.morph_animations[0].times[2]: is 0.5 after 0.5; times rise from 0 or later");
    }
    {
        Morphed morphed(skin);
        morphed.weights[3] = INFINITY;
        EXPECT_EQ(morphed.refusal(),
                  "desc.morph_animations[0].weights[3]: is inf, must be finite and at most 1e30 in size");
    }
    {
        Morphed morphed(skin);
        morphed.animation.animation = 0;
        EXPECT_EQ(morphed.refusal(), "desc.morph_animations[0].animation: is 0, but there are 0 animations");
    }
    {
        Morphed morphed(skin);
        morphed.animation.key_count = 0;
        EXPECT_EQ(morphed.refusal(), "desc.morph_animations[0].key_count: is 0, must be at least 1");
    }
    {
        Morphed morphed(skin);
        morphed.desc.morph_count = 0;
        EXPECT_EQ(morphed.refusal(), "desc.morph_animation_count: is 1, but there are no morphs");
    }
}

// A file of ours, changed.
TEST(SkinMorphs, BrokenFilesAreRefusedAndOddOnesNamed) {
    TestSkin skin = bar();
    const Morphed morphed(skin);
    ASSERT_EQ(morphed.write(), FLG_OK) << flgIoErrorGetMessage();
    const auto changed = [&](const std::string& from, const std::string& to) {
        Glb glb(slurp(morphed.path));
        return read_skin(morphed.folder.put("odd.glb", glb.replace(from, to).bytes()));
    };
    EXPECT_NE(changed("\"path\":\"weights\"", "\"path\":\"strange\"").warnings.find("moves no joint"),
              std::string::npos);
    const ReadSkin no_targets = changed("\"sparse\":{\"count\":1,", "\"sparse\":{\"count\":9000,");
    EXPECT_EQ(no_targets.result, FLG_ERROR_FORMAT);
    const ReadSkin stepping = changed("{\"input\":", "{\"interpolation\":\"STEP\",\"input\":");
    EXPECT_NE(stepping.warnings.find("not LINEAR"), std::string::npos) << stepping.warnings;
}

}  // namespace
}  // namespace flg::test
