// SPDX-License-Identifier: MIT
// Random damage, always the same: readers may refuse or read, but what they hand out is sound. The sanitizer presets
// make of this a search for reads out of bounds.
#include <cmath>
#include <random>

#include "io/mesh_files.h"
#include "io/skin_files.h"
#include "io/tilt_files.h"

namespace flg::test {
namespace {

void expect_sound(const Read& curves) {
    if (curves.result != FLG_OK) {
        EXPECT_TRUE(curves.result == FLG_ERROR_FORMAT || curves.result == FLG_ERROR_LIMIT ||
                    curves.result == FLG_ERROR_FILE)
            << curves.error;
        return;
    }
    for (const auto& [attribute, column] : curves.columns) {
        for (float value : column) ASSERT_TRUE(std::isfinite(value)) << attribute;
    }
    for (float value : curves.positions()) ASSERT_LE(std::abs(value), 1e30f);
    for (size_t c = 0; c < curves.flags.size(); ++c) ASSERT_LT(curves.offsets[c], curves.offsets[c + 1]);
}

void expect_sound(const ReadMesh& mesh) {
    if (mesh.result != FLG_OK) {
        EXPECT_TRUE(mesh.result == FLG_ERROR_FORMAT || mesh.result == FLG_ERROR_LIMIT || mesh.result == FLG_ERROR_FILE)
            << mesh.error;
        return;
    }
    for (const auto& [attribute, column] : mesh.columns) {
        for (float value : column) ASSERT_LE(std::abs(value), 1e30f) << attribute;
    }
    ASSERT_FALSE(mesh.triangles.empty());
    for (uint32_t vertex : mesh.triangles) ASSERT_LT(vertex, mesh.info.vertex_count);
}

void read_curves(const std::string& path) {
    expect_sound(read(path));
}

void read_meshes(const std::string& path) {
    expect_sound(read_mesh(path));
}

void read_skins(const std::string& path) {
    ReadSkin read = read_skin(path);
    if (read.result != FLG_OK) {
        EXPECT_TRUE(read.result == FLG_ERROR_FORMAT || read.result == FLG_ERROR_LIMIT || read.result == FLG_ERROR_FILE)
            << read.error;
        return;
    }
    // What is read can be written: the writer checks all that a view promises, but for the order of weights.
    const TestSkin& skin = read.skin;
    if (!read.has_skin) return;
    for (size_t i = 0; i < skin.weights.size(); ++i) ASSERT_LE(skin.weights[i], skin.weights[i / 4 * 4]);
    for (const TestAnimation& animation : read.animations) ASSERT_FALSE(animation.times.empty());
    const std::string copy = std::filesystem::path(path).replace_extension(".copy.glb").string();
    EXPECT_EQ(write_skin(copy, read.skin, read.animations), FLG_OK) << flgIoErrorGetMessage();
}

void damage(const std::string& path, const std::string& whole, int rounds, void (*read_one)(const std::string&)) {
    std::mt19937 random(1);
    const std::string root = std::filesystem::path(path).extension() == ".sketch"
                                 ? std::filesystem::path(path).parent_path().string()
                                 : path;
    for (int i = 0; i < rounds; ++i) {
        std::string bytes = whole;
        for (uint32_t flips = 1 + random() % 4; flips > 0; --flips) {
            bytes[random() % bytes.size()] = static_cast<char>(random() % 2 ? random() : 1u << random() % 8);
        }
        std::filesystem::remove(path);
        std::ofstream(path, std::ios::binary) << bytes;
        read_one(root);
    }
}

TEST(Fuzz, Tilt) {
    const Folder folder;
    const std::string sketch = tilt_sketch({sample_stroke(), sample_stroke()});
    damage(folder.at("a.tilt"), tilt_file(sketch), 800, read_curves);
    damage(folder.at("b.tilt"), tilt_file(sketch, true), 800, read_curves);
    folder.put("c.tilt/metadata.json", tilt_metadata);
    damage(folder.at("c.tilt/data.sketch"), sketch, 1200, read_curves);
}

Curves sample_curves() {
    Curves curves;
    curves.add({0, 0, 0, 1, 2, 3, 4, 5, 6.5f});
    curves.add({0, 1, 0, 1, 0, 0, 0, 0, -1}, true);
    curves.add({7, 8, 9});
    curves.radii.assign(7, 0.25f);
    curves.colors.assign(28, 0.5f);
    return curves;
}

TEST(Fuzz, TextAndGltf) {
    const Folder folder;
    Curves curves = sample_curves();
    for (const char* name : {"a.xyz", "a.obj", "a.glb"}) {
        ASSERT_EQ(write(folder.at(name), curves), FLG_OK);
        damage(folder.at(name), slurp(folder.at(name)), 600, read_curves);
    }
    FlgCurveFileWriteDesc all;
    flgCurveFileWriteDescInit(&all, sizeof all);
    all.all_columns = 1;
    curves.normals.assign(21, 0.5f);
    for (const char* name : {"b.xyz", "b.glb"}) {
        ASSERT_EQ(write(folder.at(name), curves, &all), FLG_OK);
        damage(folder.at(name), slurp(folder.at(name)), 600, read_curves);
    }
}

TEST(Fuzz, Svg) {
    const Folder folder;
    damage(folder.at("a.svg"),
           "<?xml version='1.0'?><svg><!-- x --><g transform='translate(1,2) rotate(30 1 1) scale(2)'>"
           "<path d='M1 2l3-4.5.5H6v7C1 2 3 4 5 6s1 2 3 4Q1 2 3 4t1 2A5 4 30 1 0 9 9a5 4 30 01 1 1z'/>"
           "<circle cx='1' cy='2px' r='3'/><rect x='1' width='4' height='5' rx='1'/>"
           "<polygon points='0,0 1,0 1,1'/></g><ellipse rx='3' ry='2'/></svg>",
           3000, read_curves);
}

MeshInput sample_mesh() {
    MeshInput mesh;
    mesh.colors.assign(16, 0.5f);
    mesh.normals.assign(12, 0.5f);
    mesh.user.assign(8, 0.25f);
    mesh.regions = {0, 1, 1, 2};
    mesh.split_regions = true;
    return mesh;
}

TEST(Fuzz, Meshes) {
    const Folder folder;
    MeshInput mesh = sample_mesh();
    for (const char* name : {"a.ply", "a.obj", "a.off", "a.glb"}) {
        ASSERT_EQ(write_mesh(folder.at(name), mesh), FLG_OK) << flgIoErrorGetMessage();
        damage(folder.at(name), slurp(folder.at(name)), 800, read_meshes);
    }
    damage(folder.at("b.ply"),
           "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 2\nproperty list uchar int vertex_indices\nproperty int region\n"
           "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
           "0 0 0\n2 0 0\n0.5 0.5 0\n0 2 0\n1 1 1\n4 0 1 2 3 7\n3 0 1 4 8\n7 0 1 2 -1 3 2 1\n",
           1200, read_meshes);
}

TEST(Fuzz, Skins) {
    const Folder folder;
    TestSkin skin = cross(3, 3);
    TestAnimation animation = curl(skin.joint_count());
    animation.translations.assign(9, 0.5f);
    ASSERT_EQ(write_skin(folder.at("a.glb"), skin, {animation}), FLG_OK) << flgIoErrorGetMessage();
    const std::string whole = slurp(folder.at("a.glb"));
    damage(folder.at("a.glb"), whole, 2000, read_skins);
    for (size_t size = 0; size < whole.size(); size += 7)
        ASSERT_EQ(read_skin(folder.put("cut.glb", std::string_view(whole).substr(0, size))).result, FLG_ERROR_FORMAT);
}

TEST(Fuzz, TruncatedGlbIsRefused) {
    const Folder folder;
    Curves curves = sample_curves();
    ASSERT_EQ(write(folder.at("a.glb"), curves), FLG_OK);
    const std::string whole = slurp(folder.at("a.glb"));
    for (size_t size = 0; size < whole.size(); ++size) {
        ASSERT_EQ(read(folder.put("cut.glb", std::string_view(whole).substr(0, size))).result, FLG_ERROR_FORMAT)
            << size;
    }
    MeshInput mesh = sample_mesh();
    ASSERT_EQ(write_mesh(folder.at("a.glb"), mesh), FLG_OK);
    const std::string triangles = slurp(folder.at("a.glb"));
    for (size_t size = 0; size < triangles.size(); ++size) {
        ASSERT_EQ(read_mesh(folder.put("cut.glb", std::string_view(triangles).substr(0, size))).result,
                  FLG_ERROR_FORMAT)
            << size;
    }
}

}  // namespace
}  // namespace flg::test
