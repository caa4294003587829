// SPDX-License-Identifier: MIT
// Texture coordinates, textures and materials of meshes, as files have them; what is left out is named.
#include <gtest/gtest.h>

#include <cmath>

#include "io/skin_files.h"

namespace flg::test {
namespace {

const std::string png(reinterpret_cast<const char*>(red_pixel), sizeof red_pixel);

struct Mesh {
    explicit Mesh(const std::string& path) {
        view.struct_size = sizeof view;
        result = flgMeshFileRead(path.c_str(), nullptr, &file);
        if (result != FLG_OK) {
            warnings = flgIoErrorGetMessage();
            return;
        }
        EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
        EXPECT_EQ(flgMeshFileGetInfo(file, &info), FLG_OK);
        for (uint32_t i = 0; i < info.warning_count; ++i) warnings += std::string(info.warnings[i]) + "\n";
    }
    ~Mesh() { flgMeshFileRelease(file); }
    std::vector<float> uvs() const {
        if (!info.corner_uvs) return {};
        return {info.corner_uvs, info.corner_uvs + size_t{6} * view.triangle_count};
    }
    FlgMeshMaterial material(uint32_t index) const {
        FlgMeshMaterial out = flgMeshMaterialDefaults();
        EXPECT_EQ(flgMeshFileGetMaterial(file, index, &out), FLG_OK) << flgIoErrorGetMessage();
        return out;
    }
    FlgTexture texture(uint32_t index) const {
        FlgTexture out = flgTextureDefaults();
        EXPECT_EQ(flgMeshFileGetTexture(file, index, &out), FLG_OK) << flgIoErrorGetMessage();
        return out;
    }
    FlgResult result;
    FlgMeshFile file = nullptr;
    FlgMeshView view = {};
    FlgMeshFileInfo info = flgMeshFileInfoDefaults();
    std::string warnings;
};

constexpr const char* square =
    "mtllib look of it.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nvt 0 0\nvt 1 0\nvt 1 0.75\nvt 0 0.75\n"
    "usemtl painted wall\nf 1/1 2/2 3/3 4/4\nusemtl bare\nf 2 5 3\n";
constexpr const char* look =
    "newmtl painted wall\nKd 0.5 0.25 1\nPr 0.3\nmap_Kd -clamp on pictures\\red.png\nnewmtl bare\nKd 0 1 0\nPm 1\n";

TEST(MeshLooks, ObjHasTextureCoordinatesAndMaterials) {
    const Folder folder;
    folder.put("pictures/red.png", png);
    folder.put("look of it.mtl", look);
    const Mesh mesh(folder.put("square.obj", square));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.warnings;
    EXPECT_EQ(mesh.warnings, "");
    ASSERT_EQ(mesh.view.vertex_count, 5u) << "corners, not vertices, have texture coordinates";
    EXPECT_EQ(mesh.uvs(), std::vector<float>({0, 1, 1, 1, 1, 0.25f, 0, 1, 1, 0.25f, 0, 0.25f, 0, 0, 0, 0, 0, 0}));
    ASSERT_EQ(mesh.info.material_count, 2u);
    EXPECT_STREQ(mesh.material(0).name, "painted wall");
    EXPECT_EQ(mesh.material(0).color[1], 0.25f);
    EXPECT_EQ(mesh.material(0).roughness, 0.3f);
    EXPECT_EQ(mesh.material(0).texture, 0u);
    EXPECT_EQ(mesh.material(1).metallic, 1);
    EXPECT_EQ(mesh.material(1).texture, FLG_NO_INDEX);
    ASSERT_EQ(mesh.info.texture_count, 1u);
    const FlgTexture texture = mesh.texture(0);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(texture.picture), texture.picture_size), png);
    EXPECT_EQ(texture.wrap_u, FLG_TEXTURE_WRAP_REPEAT);
    FlgTexture none = flgTextureDefaults();
    EXPECT_EQ(flgMeshFileGetTexture(mesh.file, 1, &none), FLG_ERROR_INVALID_ARGUMENT);
}

const std::string ply_square_of_faces =
    "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\n"
    "property int texnumber\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n"
    "4 0 1 2 3 8 0 0 1 0 1 0.75 0 0.75 1\n3 0 2 3 6 0.5 0.5 0.25 0 1 1 0\n";

// Of vertices by any of their names, before or behind the faces.
TEST(MeshLooks, PlyHasTextureCoordinatesOfVertices) {
    const Folder folder;
    for (const auto& [u, v] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")}) {
        const std::string vertices = "element vertex 3\nproperty float " + std::string(u) +
                                     "\nproperty float x\nproperty float y\nproperty float z\nproperty double " + v +
                                     "\n",
                          faces = "element face 1\nproperty list uchar int vertex_indices\n",
                          points = "0 0 0 0 0\n1 1 0 0 0.25\n0.5 1 1 0 1\n", corners = "3 0 2 1\n";
        for (const bool faces_first : {false, true}) {
            const Mesh mesh(folder.put("a.ply", "ply\nformat ascii 1.0\n" + (faces_first ? faces : vertices) +
                                                    (faces_first ? vertices : faces) + "end_header\n" +
                                                    (faces_first ? corners + points : points + corners)));
            ASSERT_EQ(mesh.result, FLG_OK) << mesh.warnings;
            EXPECT_EQ(mesh.warnings, "");
            EXPECT_EQ(mesh.uvs(), std::vector<float>({0, 1, 0.5f, 0, 1, 0.75f})) << u;
        }
    }
    // Half of a pair is none.
    const Mesh half(folder.put("a.ply",
                               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                               "property float z\nproperty float u\nelement face 1\n"
                               "property list uchar int vertex_indices\nend_header\n"
                               "0 0 0 1\n1 0 0 1\n1 1 0 1\n3 0 1 2\n"));
    ASSERT_EQ(half.result, FLG_OK) << half.warnings;
    EXPECT_EQ(half.info.corner_uvs, nullptr);
}

TEST(MeshLooks, PlyHasTextureCoordinatesOfCornersAndTextures) {
    const Folder folder;
    folder.put("red one.png", png);
    const Mesh mesh(
        folder.put("a.ply", "ply\nformat ascii 1.0\ncomment TextureFile red one.png\n" + ply_square_of_faces));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.warnings;
    EXPECT_EQ(mesh.warnings, "");
    ASSERT_EQ(mesh.view.vertex_count, 4u) << "corners, not vertices, have texture coordinates";
    EXPECT_EQ(mesh.uvs(),
              std::vector<float>({0, 1, 1, 1, 1, 0.25f, 0, 1, 1, 0.25f, 0, 0.25f, 0.5f, 0.5f, 0.25f, 1, 1, 0}));
    ASSERT_EQ(mesh.info.texture_count, 1u);
    const FlgTexture texture = mesh.texture(0);
    EXPECT_EQ(std::string(reinterpret_cast<const char*>(texture.picture), texture.picture_size), png);
    // The first face has number 1, which is none of the textures.
    ASSERT_EQ(mesh.info.material_count, 2u);
    EXPECT_EQ(std::vector<uint32_t>(mesh.view.regions, mesh.view.regions + 3), std::vector<uint32_t>({1, 1, 0}));
    EXPECT_EQ(mesh.material(0).texture, 0u);
    EXPECT_EQ(mesh.material(1).texture, FLG_NO_INDEX);
}

TEST(MeshLooks, WhatAPlyLacksIsNamed) {
    const Folder folder;
    const Mesh alone(folder.put("a.ply", "ply\nformat ascii 1.0\ncomment TextureFile red.png\n" + ply_square_of_faces));
    ASSERT_EQ(alone.result, FLG_OK) << alone.warnings;
    EXPECT_EQ(alone.warnings, "the texture 'red.png' can't be read: left out\n");
    const Mesh outside(
        folder.put("b.ply", "ply\nformat ascii 1.0\ncomment TextureFile ../a.ply\n" + ply_square_of_faces));
    EXPECT_EQ(outside.warnings, "the texture '../a.ply' can't be read: left out\n");
    std::string lists = ply_square_of_faces;
    lists.replace(lists.find("6 0.5 0.5"), 3, "2 0.5 0.5 1\n#");
    lists.resize(lists.find('#'));
    const Mesh short_list(folder.put("c.ply", "ply\nformat ascii 1.0\n" + lists));
    ASSERT_EQ(short_list.result, FLG_OK) << short_list.warnings;
    EXPECT_NE(short_list.warnings.find("texcoord that has not two values a corner: left out"), std::string::npos)
        << short_list.warnings;
    EXPECT_EQ(short_list.uvs()[17], 0);
}

TEST(MeshLooks, TextureCoordinatesOfVerticesAreWrittenAndReadBack) {
    const Folder folder;
    const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    const std::vector<float> uvs = {0, 1, 0.5f, 1, 0.5f, 0.25f, 0, 0.25f};
    const std::vector<uint32_t> triangles = {0, 1, 2, 0, 2, 3};
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_UV, 2, uvs.data(), 0, 0}};
    FlgMeshView view{};
    view.struct_size = sizeof view;
    view.vertex_count = 4;
    view.triangle_count = 2;
    view.triangles = triangles.data();
    view.columns = columns;
    view.column_count = 2;
    for (const char* name : {"uvs.glb", "uvs.obj", "uvs.ply"}) {
        SCOPED_TRACE(name);
        const std::string path = folder.at(name);
        ASSERT_EQ(flgMeshFileWrite(path.c_str(), &view, nullptr), FLG_OK) << flgIoErrorGetMessage();
        const Mesh read(path);
        const std::vector<float> back = read.uvs();
        ASSERT_EQ(back.size(), 12u) << read.warnings;
        for (size_t c = 0; c < 6; ++c)
            for (size_t k = 0; k < 2; ++k) EXPECT_EQ(back[2 * c + k], uvs[2 * read.view.triangles[c] + k]);
    }
}

TEST(MeshLooks, WhatAnObjLacksIsNamed) {
    const Folder folder;
    const Mesh alone(folder.put("square.obj", square));
    ASSERT_EQ(alone.result, FLG_OK);
    EXPECT_NE(alone.warnings.find("the materials of 'look of it.mtl' can't be read"), std::string::npos);
    EXPECT_EQ(alone.info.material_count, 0u);
    EXPECT_EQ(alone.uvs().size(), 18u);
    folder.put("look of it.mtl", look);
    const Mesh bare((folder.at("square.obj")));
    EXPECT_NE(bare.warnings.find("red.png' can't be read"), std::string::npos) << bare.warnings;
    EXPECT_EQ(bare.info.material_count, 2u);
    EXPECT_EQ(bare.info.texture_count, 0u);
    folder.put("look of it.mtl", "newmtl bare\nmap_Kd ../outside.png\n");
    EXPECT_NE(Mesh(folder.at("square.obj")).warnings.find("outside.png' can't be read"), std::string::npos);
    const Mesh missing(folder.put("uv.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/9 3/x\n"));
    ASSERT_EQ(missing.result, FLG_OK);
    EXPECT_NE(missing.warnings.find("texture coordinates that are not there"), std::string::npos);
    EXPECT_EQ(missing.uvs(), std::vector<float>({0, 1, 0, 0, 0, 0}));
}

// Triangles of concave faces take their corners' texture coordinates along.
TEST(MeshLooks, ConcaveFacesKeepTheirTextureCoordinates) {
    const Folder folder;
    const Mesh mesh(folder.put("arrow.obj",
                               "v 0 0 0\nv 1 0.5 0\nv 0 1 0\nv 0.4 0.5 0\nvt 0 0\nvt 1 0.5\nvt 0 1\nvt 0.4 0.5\n"
                               "f 4/4 1/1 2/2 3/3\nf 1/1 2/2 3/3 4/4\n"));
    ASSERT_EQ(mesh.result, FLG_OK);
    const std::vector<float> uvs = mesh.uvs();
    for (size_t c = 0; c < uvs.size() / 2; ++c) {
        const float* p = mesh.view.columns[0].data + size_t{3} * mesh.view.triangles[c];
        EXPECT_EQ(uvs[2 * c], p[0]);
        EXPECT_NEAR(uvs[2 * c + 1], 1 - p[1], 1e-6f);
    }
}

// A skin's file is a mesh's too: the same looks, read by both readers.
TEST(MeshLooks, GltfHasTexturesOfMaterials) {
    const Folder folder;
    const std::string path = folder.at("skin.glb");
    TestSkin skin = bar();
    FlgSkinView view = skin.view();
    std::vector<float> uvs;
    for (uint32_t c = 0; c < 3 * view.triangle_count; ++c)
        for (size_t k = 0; k < 2; ++k) uvs.push_back(skin.positions[3 * view.triangles[c] + k] * 0.125f);
    std::vector<float> colors;
    for (size_t v = 0; v < skin.vertex_count(); ++v) colors.insert(colors.end(), {0.25f, 0.5f, 0.75f, 1});
    view.corner_uvs = uvs.data();
    FlgTexture textures[2] = {flgTextureDefaults(), flgTextureDefaults()};
    for (FlgTexture& texture : textures) {
        texture.picture = red_pixel;
        texture.picture_size = sizeof red_pixel;
    }
    textures[1].wrap_u = FLG_TEXTURE_WRAP_CLAMP;
    textures[1].wrap_v = FLG_TEXTURE_WRAP_MIRROR;
    textures[1].nearest = 1;
    textures[1].name = "second";
    FlgMeshMaterial material = flgMeshMaterialDefaults();
    material.texture = 1;
    material.two_sided = 1;
    FlgSkinFileWriteDesc desc = {};
    ASSERT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    desc.skin = &view;
    desc.textures = textures;
    desc.texture_count = 2;
    desc.materials = &material;
    desc.material_count = 1;
    desc.vertex_colors = colors.data();
    ASSERT_EQ(flgSkinFileWrite(path.c_str(), &desc), FLG_OK) << flgIoErrorGetMessage();

    const Mesh mesh(path);
    EXPECT_EQ(mesh.warnings, "");
    EXPECT_EQ(mesh.uvs(), uvs);
    ASSERT_EQ(mesh.info.texture_count, 1u) << "the other is not used";
    EXPECT_EQ(mesh.material(0).texture, 0u);
    EXPECT_EQ(mesh.material(0).two_sided, 1u);
    EXPECT_EQ(mesh.texture(0).wrap_u, FLG_TEXTURE_WRAP_CLAMP);
    EXPECT_EQ(mesh.texture(0).wrap_v, FLG_TEXTURE_WRAP_MIRROR);
    EXPECT_EQ(mesh.texture(0).nearest, 1u);
    EXPECT_STREQ(mesh.texture(0).name, "second");
    EXPECT_EQ(mesh.view.column_count, 3u) << "positions, colours, normals";

    FlgSkinFile file = nullptr;
    ASSERT_EQ(flgSkinFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
    FlgSkinView read = {};
    read.struct_size = sizeof read;
    FlgSkinFileInfo info = flgSkinFileInfoDefaults();
    ASSERT_EQ(flgSkinFileGetView(file, &read), FLG_OK);
    ASSERT_EQ(flgSkinFileGetInfo(file, &info), FLG_OK);
    ASSERT_NE(read.corner_uvs, nullptr);
    EXPECT_TRUE(std::equal(uvs.begin(), uvs.end(), read.corner_uvs));
    ASSERT_NE(info.vertex_colors, nullptr);
    EXPECT_TRUE(std::equal(colors.begin(), colors.end(), info.vertex_colors));
    ASSERT_EQ(info.texture_count, 1u);
    FlgTexture shown = flgTextureDefaults();
    ASSERT_EQ(flgSkinFileGetTexture(file, 0, &shown), FLG_OK);
    EXPECT_EQ(shown.picture_size, sizeof red_pixel);
    flgSkinFileRelease(file);

    // Refusals.
    const auto refusal = [&] {
        EXPECT_EQ(flgSkinFileWrite(path.c_str(), &desc), FLG_ERROR_INVALID_ARGUMENT);
        const std::string message = flgIoErrorGetMessage();
        return message.substr(message.find("desc."));
    };
    material.texture = 2;
    EXPECT_EQ(refusal(), "desc.materials[0].texture: is 2, but there are 2 textures");
    material.texture = 0;
    textures[0].picture_size = 2;
    EXPECT_EQ(refusal(), "desc.textures[0].picture: is neither a PNG nor a JPEG file");
    textures[0].picture_size = sizeof red_pixel;
    textures[1].wrap_v = static_cast<FlgTextureWrap>(7);
    EXPECT_EQ(refusal(), "desc.textures[1]: wraps by 7, which is none of FLG_TEXTURE_WRAP_");
    textures[1].wrap_v = FLG_TEXTURE_WRAP_REPEAT;
    colors[5] = NAN;
    EXPECT_EQ(refusal(), "desc.vertex_colors[5]: is nan, must be finite and at most 1e30 in size");
    colors[5] = 0;
    view.corner_uvs = nullptr;
    EXPECT_EQ(refusal(), "desc.textures[0].picture: needs the corner_uvs of all meshes");
}

// glTF passes over colour spaces and shapes of pixels, and its validator warns of them.
TEST(MeshLooks, PicturesAreWrittenWithoutWhatGltfPassesOver) {
    const Folder folder;
    TestSkin skin = bar();
    FlgSkinView view = skin.view();
    const std::vector<float> uvs(size_t{6} * view.triangle_count, 0.5f);
    view.corner_uvs = uvs.data();
    FlgSkinFileWriteDesc desc = {};
    ASSERT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    desc.skin = &view;
    const std::string path = folder.at("skin.glb");
    const auto written = [&](const std::string& file) {
        desc.texture = reinterpret_cast<const uint8_t*>(file.data());
        desc.texture_size = file.size();
        EXPECT_EQ(flgSkinFileWrite(path.c_str(), &desc), FLG_OK) << flgIoErrorGetMessage();
        const FlgTexture texture = Mesh(path).texture(0);
        return texture.picture_size;
    };
    constexpr size_t header = 33;  // signature and first chunk
    const std::string gamma("\0\0\0\4gAMA\0\0\xb1\x8f\x0b\xfc\x61\x05", 16);
    const std::string with_gamma = png.substr(0, header) + gamma + png.substr(header);
    EXPECT_EQ(written(png), png.size());
    EXPECT_EQ(written(with_gamma), png.size());
    // Cut off: as it is.
    EXPECT_EQ(written(with_gamma.substr(0, 60)), 60u);
}

TEST(MeshLooks, WhatGltfLacksIsNamed) {
    const Folder folder;
    TestSkin skin = bar();
    FlgSkinView view = skin.view();
    const std::vector<float> uvs(size_t{6} * view.triangle_count, 0.5f);
    view.corner_uvs = uvs.data();
    FlgSkinFileWriteDesc desc = {};
    ASSERT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    desc.skin = &view;
    desc.texture = red_pixel;
    desc.texture_size = sizeof red_pixel;
    const std::string path = folder.at("skin.glb");
    ASSERT_EQ(flgSkinFileWrite(path.c_str(), &desc), FLG_OK) << flgIoErrorGetMessage();
    const auto warnings = [&](const std::string& from, const std::string& to) {
        Glb glb(slurp(path));
        const Mesh mesh(folder.put("odd.glb", glb.replace(from, to).bytes()));
        return mesh.warnings;
    };
    const std::string lost = warnings("\"pbrMetallicRoughness\":{",
                                      "\"alphaMode\":\"BLEND\",\"normalTexture\":{\"index\":0},"
                                      "\"pbrMetallicRoughness\":{");
    EXPECT_NE(lost.find("with normalTexture, which is left out"), std::string::npos) << lost;
    EXPECT_NE(lost.find("with alphaMode, which is left out"), std::string::npos) << lost;
    EXPECT_NE(warnings("\"source\":0,", "").find("neither PNG nor JPEG"), std::string::npos);
    EXPECT_NE(
        warnings("\"images\":[{\"bufferView\":", "\"images\":[{\"uri\":\"gone.png\",\"was\":").find("can't be read"),
        std::string::npos);
    EXPECT_NE(warnings("\"TEXCOORD_0\"", "\"TEXCOORD_3\"").find("with attributes besides"), std::string::npos);
}

// KHR_texture_transform: scaled, turned counter-clockwise as seen, moved.
TEST(MeshLooks, TextureCoordinatesAreTransformed) {
    const Folder folder;
    TestSkin skin = bar();
    FlgSkinView view = skin.view();
    std::vector<float> uvs;
    for (uint32_t c = 0; c < 3 * view.triangle_count; ++c) uvs.insert(uvs.end(), {0.5f, 0.25f});
    view.corner_uvs = uvs.data();
    FlgSkinFileWriteDesc desc = {};
    ASSERT_EQ(flgSkinFileWriteDescInit(&desc, sizeof desc), FLG_OK);
    desc.skin = &view;
    desc.texture = red_pixel;
    desc.texture_size = sizeof red_pixel;
    const std::string path = folder.at("skin.glb");
    ASSERT_EQ(flgSkinFileWrite(path.c_str(), &desc), FLG_OK) << flgIoErrorGetMessage();
    Glb glb(slurp(path));
    glb.replace("\"baseColorTexture\":{\"index\":0}",
                "\"baseColorTexture\":{\"index\":0,\"extensions\":{\"KHR_texture_transform\":{\"offset\":[0.125,1],"
                "\"rotation\":1.5707963267948966,\"scale\":[2,4]}}}");
    const Mesh mesh(folder.put("moved.glb", glb.bytes()));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.warnings;
    // (0.5, 0.25) scaled (1, 1), turned (1, -1), moved.
    EXPECT_NEAR(mesh.uvs().at(0), 1.125f, 1e-6f);
    EXPECT_NEAR(mesh.uvs().at(1), 0, 1e-6f);
}

}  // namespace
}  // namespace flg::test
