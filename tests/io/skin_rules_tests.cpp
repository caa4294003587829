// SPDX-License-Identifier: MIT
// What another reader (tinygltf) and the rules of the format find in skins that we write.
#include <algorithm>
#include <cmath>
#include <set>

#include "io/skin_files.h"
#include "io/tinygltf_model.h"

namespace flg::test {
namespace {

// The rules of glTF 2.0 that concern us, by numbers of its sections.
void expect_valid(const tinygltf::Model& model) {
    constexpr int vertices = 34962, indices = 34963;
    ASSERT_EQ(model.meshes.size(), 1u);
    ASSERT_EQ(model.skins.size(), 1u);
    const tinygltf::Skin& skin = model.skins[0];
    // 3.5: strict trees, the scene's nodes are roots.
    std::vector<int> parents(model.nodes.size(), -1);
    for (size_t i = 0; i < model.nodes.size(); ++i) {
        for (const int child : model.nodes[i].children) {
            EXPECT_EQ(parents.at(static_cast<size_t>(child)), -1);
            parents[static_cast<size_t>(child)] = static_cast<int>(i);
        }
    }
    for (const int root : model.scenes.at(0).nodes) EXPECT_EQ(parents.at(static_cast<size_t>(root)), -1);
    // 3.7.3: the skinned mesh at the top, all joints below the skeleton, a matrix each whose last row is 0 0 0 1.
    int mesh_node = -1;
    for (size_t i = 0; i < model.nodes.size(); ++i)
        if (model.nodes[i].mesh >= 0) mesh_node = static_cast<int>(i);
    ASSERT_GE(mesh_node, 0);
    EXPECT_EQ(parents[static_cast<size_t>(mesh_node)], -1);
    EXPECT_EQ(model.nodes[static_cast<size_t>(mesh_node)].skin, 0);
    for (const int joint : skin.joints) {
        int node = joint;
        while (node != skin.skeleton && node >= 0) node = parents[static_cast<size_t>(node)];
        EXPECT_EQ(node, skin.skeleton);
    }
    const tinygltf::Accessor& bind = model.accessors.at(static_cast<size_t>(skin.inverseBindMatrices));
    EXPECT_EQ(bind.type, TINYGLTF_TYPE_MAT4);
    EXPECT_GE(bind.count, skin.joints.size());
    EXPECT_EQ(model.bufferViews.at(static_cast<size_t>(bind.bufferView)).target, 0);
    const std::vector<float> matrices = values_of<float>(model, skin.inverseBindMatrices);
    for (size_t m = 0; m < matrices.size(); m += 16)
        for (size_t k = 0; k < 4; ++k) EXPECT_EQ(matrices[m + 4 * k + 3], k == 3 ? 1 : 0);
    for (const tinygltf::Primitive& primitive : model.meshes[0].primitives) {
        const auto target = [&](int accessor) {
            return model.bufferViews
                .at(static_cast<size_t>(model.accessors.at(static_cast<size_t>(accessor)).bufferView))
                .target;
        };
        EXPECT_EQ(target(primitive.indices), indices);
        for (const auto& [name, accessor] : primitive.attributes) EXPECT_EQ(target(accessor), vertices) << name;
        const size_t count = model.accessors[static_cast<size_t>(primitive.attributes.at("POSITION"))].count;
        for (const auto& [name, accessor] : primitive.attributes)
            EXPECT_EQ(model.accessors[static_cast<size_t>(accessor)].count, count) << name;
        // 3.6.2.5: bounds of positions.
        const tinygltf::Accessor& positions = model.accessors[static_cast<size_t>(primitive.attributes.at("POSITION"))];
        const std::vector<float> points = values_of<float>(model, primitive.attributes.at("POSITION"));
        for (size_t k = 0; k < 3; ++k) {
            double low = points[k], high = low;
            for (size_t i = k; i < points.size(); i += 3) {
                low = std::min(low, double{points[i]});
                high = std::max(high, double{points[i]});
            }
            EXPECT_EQ(positions.minValues.at(k), low);
            EXPECT_EQ(positions.maxValues.at(k), high);
        }
        const std::vector<float> normals = values_of<float>(model, primitive.attributes.at("NORMAL"));
        for (size_t i = 0; i < normals.size(); i += 3)
            EXPECT_NEAR(std::hypot(normals[i], normals[i + 1], normals[i + 2]), 1, 5e-4);
        // 3.7.3.3: weights sum up to 1, no joint twice, none without a weight but 0.
        const std::vector<float> weights = values_of<float>(model, primitive.attributes.at("WEIGHTS_0"));
        const std::vector<uint16_t> joints = values_of<uint16_t>(model, primitive.attributes.at("JOINTS_0"));
        for (size_t i = 0; i < weights.size(); i += 4) {
            float sum = 0;
            for (size_t k = 0; k < 4; ++k) {
                sum += weights[i + k];
                EXPECT_GE(weights[i + k], 0);
                EXPECT_LT(joints[i + k], skin.joints.size());
                EXPECT_TRUE(weights[i + k] > 0 || joints[i + k] == 0);
                for (size_t other = 0; other < k; ++other)
                    EXPECT_TRUE(weights[i + k] == 0 || weights[i + other] == 0 || joints[i + k] != joints[i + other]);
            }
            EXPECT_NEAR(sum, 1, 2e-7);
        }
        for (const uint32_t index : values_of<uint32_t>(model, primitive.indices)) EXPECT_LT(index, count);
    }
    // 3.11: bounds and rise of times, quaternions of length 1, a channel for a node's path, views without a target.
    for (const tinygltf::Animation& animation : model.animations) {
        EXPECT_FALSE(animation.channels.empty());
        std::vector<std::pair<int, std::string>> targets;
        for (const tinygltf::AnimationChannel& channel : animation.channels) {
            targets.emplace_back(channel.target_node, channel.target_path);
            const tinygltf::AnimationSampler& sampler = animation.samplers.at(static_cast<size_t>(channel.sampler));
            const tinygltf::Accessor& input = model.accessors.at(static_cast<size_t>(sampler.input));
            const tinygltf::Accessor& output = model.accessors.at(static_cast<size_t>(sampler.output));
            EXPECT_EQ(input.count, output.count);
            for (const tinygltf::Accessor* accessor : {&input, &output})
                EXPECT_EQ(model.bufferViews.at(static_cast<size_t>(accessor->bufferView)).target, 0);
            const std::vector<float> times = values_of<float>(model, sampler.input);
            EXPECT_EQ(input.minValues.at(0), times.front());
            EXPECT_EQ(input.maxValues.at(0), times.back());
            for (size_t i = 1; i < times.size(); ++i) EXPECT_LT(times[i - 1], times[i]);
            const std::vector<float> values = values_of<float>(model, sampler.output);
            if (channel.target_path != "rotation") continue;
            for (size_t i = 0; i < values.size(); i += 4) {
                const double square = double{values[i]} * values[i] + double{values[i + 1]} * values[i + 1] +
                                      double{values[i + 2]} * values[i + 2] + double{values[i + 3]} * values[i + 3];
                EXPECT_NEAR(square, 1, 2e-6);
            }
        }
        std::sort(targets.begin(), targets.end());
        EXPECT_EQ(std::adjacent_find(targets.begin(), targets.end()), targets.end());
    }
}

TEST(SkinFile, IsValidGltf) {
    const Folder folder;
    TestSkin skin = cross();
    // What our views allow and glTF does not: off by a little.
    for (float& w : skin.weights) w *= 1.00005f;
    for (float& n : skin.normals) n *= 3;
    skin.normals[0] = skin.normals[1] = skin.normals[2] = 0;
    TestAnimation sway = swaying_cross(skin);
    for (float& r : sway.rotations) r *= 1.0005f;
    ASSERT_EQ(write_skin(folder.at("a.glb"), skin, {sway, curl(skin.joint_count())}, four_materials()), FLG_OK)
        << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(folder.at("a.glb"));
    expect_valid(model);
    EXPECT_EQ(model.meshes[0].primitives.size(), 4u);
    EXPECT_EQ(model.animations.size(), 2u);
    EXPECT_EQ(model.animations[0].name, "sway \"1\"");
    EXPECT_EQ(model.nodes[static_cast<size_t>(model.skins[0].joints[0])].name, "middle");
    // The root's channels: a turn and the moves.
    EXPECT_EQ(model.animations[0].channels.size(), skin.joint_count() + 1);
    TestSkin straight = bar();
    ASSERT_EQ(write_skin(folder.at("b.glb"), straight), FLG_OK);
    expect_valid(load_model(folder.at("b.glb")));
}

}  // namespace
}  // namespace flg::test
