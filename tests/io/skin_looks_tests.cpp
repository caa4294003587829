// SPDX-License-Identifier: MIT
// Skins with a texture, with parts by triangle, with levels of detail, as files have them.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "io/skin_files.h"
#include "io/tinygltf_model.h"

namespace flg::test {
namespace {

struct Written {
    explicit Written(TestSkin& of_skin) : skin(of_skin), view(skin.view()) {
        EXPECT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
        uvs.resize(size_t{6} * view.triangle_count);
        for (size_t c = 0; c < uvs.size() / 2; ++c) {
            uvs[2 * c] = skin.positions[3 * skin.triangles[c]] * 0.125f;
            uvs[2 * c + 1] = skin.positions[3 * skin.triangles[c] + 1] * 0.125f;
        }
        view.corner_uvs = uvs.data();
        desc.skin = &view;
        desc.texture = red_pixel;
        desc.texture_size = sizeof red_pixel;
    }
    FlgResult write() const { return flgSkinFileWrite(path.c_str(), &desc); }
    tinygltf::Model model() const {
        EXPECT_EQ(write(), FLG_OK) << flgIoErrorGetMessage();
        return load_model(path);
    }
    std::string refusal() const {
        EXPECT_EQ(write(), FLG_ERROR_INVALID_ARGUMENT);
        const std::string message = flgIoErrorGetMessage();
        return message.substr(message.find("desc."));
    }

    const Folder folder;
    const std::string path = folder.at("skin.glb");
    TestSkin& skin;
    FlgSkinView view;
    std::vector<float> uvs;
    FlgSkinFileWriteDesc desc = {};
};

TEST(SkinLooks, ATextureIsWrittenWithItsCoordinates) {
    TestSkin skin = bar();
    const Written written(skin);
    const tinygltf::Model model = written.model();
    ASSERT_EQ(model.images.size(), 1u);
    EXPECT_EQ(model.images[0].mimeType, "image/png");
    EXPECT_EQ(model.images[0].image.at(0), 200);
    ASSERT_EQ(model.materials.size(), 1u);
    EXPECT_EQ(model.materials[0].pbrMetallicRoughness.baseColorTexture.index, 0);
    const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
    const auto positions = values_of<float>(model, primitive.attributes.at("POSITION"));
    const auto uvs = values_of<float>(model, primitive.attributes.at("TEXCOORD_0"));
    ASSERT_EQ(positions.size() / 3, skin.vertex_count()) << "no corner differs, so no vertex is there twice";
    for (size_t v = 0; v < uvs.size() / 2; ++v) {
        EXPECT_EQ(uvs[2 * v], positions[3 * v] * 0.125f);
        EXPECT_EQ(uvs[2 * v + 1], positions[3 * v + 1] * 0.125f);
    }
}

TEST(SkinLooks, CornersThatDifferSplitTheirVertex) {
    TestSkin skin = bar();
    Written written(skin);
    // One triangle lies elsewhere in the picture.
    for (size_t i = 0; i < 6; ++i) written.uvs[i] += 0.5f;
    const tinygltf::Model model = written.model();
    const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
    const auto positions = values_of<float>(model, primitive.attributes.at("POSITION"));
    const auto uvs = values_of<float>(model, primitive.attributes.at("TEXCOORD_0"));
    const auto indices = values_of<uint32_t>(model, primitive.indices);
    EXPECT_EQ(positions.size() / 3, skin.vertex_count() + 3);
    EXPECT_EQ(uvs.size() / 2, positions.size() / 3);
    ASSERT_EQ(indices.size(), skin.triangles.size());
    for (size_t c = 0; c < indices.size(); ++c) {
        for (size_t k = 0; k < 3; ++k)
            EXPECT_EQ(positions[3 * indices[c] + k], skin.positions[3 * skin.triangles[c] + k]);
        for (size_t k = 0; k < 2; ++k) EXPECT_EQ(uvs[2 * indices[c] + k], written.uvs[2 * c + k]);
    }
    const ReadSkin read = read_skin(written.path);
    EXPECT_EQ(read.result, FLG_OK) << read.error;
    EXPECT_EQ(read.skin.triangles.size(), skin.triangles.size());
}

TEST(SkinLooks, TrianglesHavePartsOfTheirOwn) {
    TestSkin skin = cross();
    Written written(skin);
    std::vector<FlgMeshMaterial> materials(4, flgMeshMaterialDefaults());
    for (size_t i = 0; i < 4; ++i) materials[i].color[0] = 0.25f * static_cast<float>(i);
    std::vector<uint32_t> parts(written.view.triangle_count);
    for (size_t t = 0; t < parts.size(); ++t) parts[t] = t % 4;
    written.view.triangle_parts = parts.data();
    written.desc.materials = materials.data();
    written.desc.material_count = 4;
    ASSERT_EQ(written.write(), FLG_OK) << flgIoErrorGetMessage();
    FlgSkinFile file = nullptr;
    ASSERT_EQ(flgSkinFileRead(written.path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
    FlgSkinView view = {};
    view.struct_size = sizeof view;
    ASSERT_EQ(flgSkinFileGetView(file, &view), FLG_OK);
    ASSERT_NE(view.triangle_parts, nullptr);
    // Grouped by part, in their order.
    std::vector<uint32_t> sorted = parts;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), view.triangle_parts));
    flgSkinFileRelease(file);
}

TEST(SkinLooks, LevelsAreMeshesOfTheSameSkin) {
    TestSkin skin = bar(), coarse = bar();
    coarse.triangles.resize(30);
    Written written(skin), level(coarse);
    written.desc.levels = &level.view;
    written.desc.level_count = 1;
    const tinygltf::Model model = written.model();
    ASSERT_EQ(model.meshes.size(), 2u);
    EXPECT_EQ(model.extensionsUsed, std::vector<std::string>{"MSFT_lod"});
    EXPECT_TRUE(model.extensionsRequired.empty());
    const tinygltf::Node& finest = model.nodes[0];
    EXPECT_EQ(finest.name, "model_LOD0");
    const tinygltf::Value& ids = finest.extensions.at("MSFT_lod").Get("ids");
    ASSERT_EQ(ids.ArrayLen(), 1u);
    const auto id = static_cast<size_t>(ids.Get(0).GetNumberAsInt());
    EXPECT_EQ(model.nodes[id].name, "model_LOD1");
    EXPECT_EQ(model.nodes[id].skin, finest.skin);
    EXPECT_EQ(model.accessors[static_cast<size_t>(model.meshes[1].primitives[0].indices)].count, 30u);
    const std::vector<int>& shown = model.scenes[0].nodes;
    EXPECT_EQ(std::count(shown.begin(), shown.end(), static_cast<int>(id)), 0)
        << "who knows no levels shows the finest";
    const ReadSkin read = read_skin(written.path);
    EXPECT_EQ(read.skin.triangles.size(), skin.triangles.size());
    EXPECT_EQ(read.warnings, "");
}

TEST(SkinLooks, Refusals) {
    TestSkin skin = bar(), other = cross();
    Written written(skin), level(other);
    const FlgSkinView sound = written.view;
    written.view.corner_uvs = nullptr;
    EXPECT_EQ(written.refusal(), "desc.texture: needs the corner_uvs of all meshes");
    written.uvs[3] = NAN;
    written.view = sound;
    EXPECT_EQ(written.refusal().rfind("desc.skin.corner_uvs[3]: is nan", 0), 0u);
    written.uvs[3] = 0;
    const uint8_t gif[] = {'G', 'I', 'F', '8', '9', 'a'};
    written.desc.texture = gif;
    written.desc.texture_size = sizeof gif;
    EXPECT_EQ(written.refusal(), "desc.texture: is neither a PNG nor a JPEG file");
    written.desc.texture = nullptr;
    EXPECT_EQ(written.refusal(), "desc.texture: is null, but has a size");
    written.desc.texture_size = 0;
    written.desc.level_count = 17;
    EXPECT_EQ(written.refusal(), "desc.level_count: is 17, must be at most 16");
    written.desc.level_count = 1;
    EXPECT_EQ(written.refusal(), "desc.levels: is null");
    level.view.joint_count -= 1;
    written.desc.levels = &level.view;
    if (level.view.joint_count != written.view.joint_count) {
        EXPECT_EQ(written.refusal().rfind("desc.levels[0].joint_count: is ", 0), 0u);
    }
    const std::vector<uint32_t> parts(written.view.triangle_count, 1u << 24);
    written.desc.level_count = 0;
    written.view.triangle_parts = parts.data();
    EXPECT_EQ(written.refusal().rfind("desc.skin.triangle_parts[0]: is 16777216", 0), 0u);
}

}  // namespace
}  // namespace flg::test
