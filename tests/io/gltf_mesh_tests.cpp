// SPDX-License-Identifier: MIT
// Triangles of glTF files: what is read of other programs' files, and what another reader (tinygltf) finds in ours.
#include <tiny_gltf.h>

#include <algorithm>

#include <cstring>
#include <limits>

#include "io/gltf_files.h"
#include "io/mesh_files.h"

namespace flg::test {
namespace {

// Primitives of triangles over the document's four points.
Document document_of(const std::string& primitives) {
    Document document;
    document.primitive = primitives;
    return document;
}

// Adds an accessor of 16-bit indices; the first is accessor 1.
void add_indices(Document& document, const std::vector<uint16_t>& indices) {
    const std::string view =
        std::to_string(1 + static_cast<size_t>(std::count(document.views.begin(), document.views.end(), '{')));
    document.views += R"(, {"buffer": 0, "byteOffset": )" + std::to_string(48 + document.more.size()) +
                      R"(, "byteLength": )" + std::to_string(2 * indices.size()) + "}";
    document.accessors += R"(, {"bufferView": )" + view + R"(, "componentType": 5123, "type": "SCALAR", "count": )" +
                          std::to_string(indices.size()) + "}";
    document.more += bytes_of(indices);
}

TEST(GltfMesh, ReadsTrianglesStripsAndFans) {
    const Folder folder;
    Document document = document_of(R"({"attributes": {"POSITION": 0}, "indices": 1},
        {"attributes": {"POSITION": 0}, "indices": 2, "mode": 5}, {"attributes": {"POSITION": 0}, "mode": 6},
        {"attributes": {"POSITION": 0}, "mode": 3}, {"attributes": {"POSITION": 0}, "mode": 4})");
    add_indices(document, {0, 1, 2, 0, 2, 3});
    add_indices(document, {0, 1, 3, 2, 2, 1, 0});
    ReadMesh mesh = read_mesh(folder.put("a.gltf", document.text()));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    // All primitives share the same vertices.
    EXPECT_EQ(mesh.positions(), document.points);
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 0, 2, 3, 0, 1, 3, 3, 1, 2, 2, 1, 0, 0, 1, 2, 0, 2, 3, 0, 1, 2}));
    EXPECT_EQ(mesh.info.polygon_count, 8u);
    EXPECT_EQ(mesh.regions, Indices{});
    EXPECT_EQ(mesh.format, "gltf");
    EXPECT_EQ(mesh.warnings,
              "1 primitive: of points or lines, left out: only triangles are read (first: primitive 3)\n"
              "1 primitive: of triangles that are not complete, the rest left out (first: primitive 4)\n");
}

TEST(GltfMesh, NodesPlaceMeshesAndMirrorsTurnTriangles) {
    const Folder folder;
    Document document = document_of(R"({"attributes": {"POSITION": 0}, "indices": 1})");
    add_indices(document, {0, 1, 2});
    document.nodes = R"("scenes": [{"nodes": [2]}], "nodes": [{"mesh": 0, "translation": [0, 0, 5]},
        {"mesh": 0, "scale": [-1, 2, 1]}, {"children": [0, 1], "translation": [10, 0, 0]}],)";
    ReadMesh mesh = read_mesh(folder.put("a.gltf", document.text()));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.positions(), (Floats{10, 0, 5, 11, 0, 5, 11, 1, 5, 10, 1, 5, 10, 0, 0, 9, 0, 0, 9, 2, 0, 10, 2, 0}));
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 4, 6, 5}));
    EXPECT_NEAR(mesh.area_xy(), 0.5 + 1, 1e-6);
    // Without nodes: as they are.
    document.nodes.clear();
    EXPECT_EQ(read_mesh(folder.put("b.gltf", document.text())).positions(), document.points);
}

TEST(GltfMesh, MaterialsAreRegionsAndColoursAreFilledUp) {
    const Folder folder;
    Document document = document_of(R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 5},
        {"attributes": {"POSITION": 0, "COLOR_0": 2}, "indices": 1},
        {"attributes": {"POSITION": 0}, "indices": 1, "material": 5})");
    add_indices(document, {0, 1, 2});
    document.more.resize(8);
    document.more += std::string("\xff\x00\x33.\x00\xff\x00.\x00\x00\xff.\xff\xff\xff.", 16);
    document.views += R"(, {"buffer": 0, "byteOffset": 56, "byteLength": 16, "byteStride": 4})";
    document.accessors +=
        R"(, {"bufferView": 2, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC3"})";
    ReadMesh mesh = read_mesh(folder.put("a.gltf", document.text()));
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    EXPECT_EQ(mesh.regions, (Indices{0, 1, 0}));
    EXPECT_EQ(mesh.triangles, (Indices{0, 1, 2, 4, 5, 6, 8, 9, 10}));
    ASSERT_EQ(mesh.colors().size(), 48u);
    const Floats middle(mesh.colors().begin() + 16, mesh.colors().begin() + 20);
    EXPECT_EQ(middle, (Floats{1, 0, 0.2f, 1}));
    EXPECT_EQ(Floats(mesh.colors().begin(), mesh.colors().begin() + 16), Floats(16, 1.0f));
    EXPECT_EQ(Floats(mesh.colors().begin() + 32, mesh.colors().end()), Floats(16, 1.0f));
}

TEST(GltfMesh, RefusesWithThePlace) {
    const Folder folder;
    const auto refuse = [&](const Document& document, const char* place, const char* reason) {
        expect_mesh_refused(folder.put("a.gltf", document.text()), FLG_ERROR_FORMAT, place, reason);
    };
    refuse(document_of(R"({"attributes": {"POSITION": 0}, "mode": 3})"), "meshes", "the file shows no triangles");
    refuse(document_of(R"({"attributes": {"POSITION": 0}, "mode": 7})"), "meshes[0].primitives[0].mode", "is 7");
    refuse(document_of(R"({"attributes": {"NORMAL": 0}})"), "meshes[0].primitives[0].attributes", "has no POSITION");
    refuse(document_of(R"({})"), "meshes[0].primitives[0].attributes", "has no POSITION");
    refuse(document_of(R"({"attributes": {"POSITION": 0}, "indices": 1})"), "meshes[0].primitives[0].indices",
           "accessors 1 of 1");
    refuse(document_of(R"({"attributes": {"POSITION": 0}, "indices": 0})"), "accessors[0]", "no unsigned integers");
    refuse(document_of(R"({"attributes": {"POSITION": 0}, "material": -1})"), "meshes[0].primitives[0].material",
           "whole number");
    refuse(document_of("3"), "meshes[0].primitives[0]", "no object");
    Document document = document_of(R"({"attributes": {"POSITION": 0}, "indices": 1})");
    add_indices(document, {0, 1, 4});
    refuse(document, "accessors[1]", "index 4 at 2, but there are 4 vertices");
    document = document_of(R"({"attributes": {"POSITION": 0}})");
    document.points[4] = std::numeric_limits<float>::quiet_NaN();
    refuse(document, "accessors[0]", "vertex 1 gives nan");
    document.points[4] = 1e30f;
    document.nodes = R"("nodes": [{"mesh": 0, "scale": [1, 10, 1]}],)";
    refuse(document, "accessors[0]", "vertex 1 gives 1e+31");
}

TEST(GltfMesh, SmallFilesCannotAskForMemoryWithoutEnd) {
    const Folder folder;
    // 134 million one-byte indices of a strip of four vertices: 16 bytes of triangles for each byte.
    constexpr uint64_t indices = (uint64_t{1} << 27) + 1;
    Document document = document_of(R"({"attributes": {"POSITION": 0}, "indices": 1, "mode": 5})");
    document.uri = "big.bin";
    document.length = 48 + indices;
    std::filesystem::resize_file(folder.put("big.bin", bytes_of(document.points)), document.length);
    document.accessors =
        R"(, {"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": )" + std::to_string(indices) + "}";
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": )" + std::to_string(indices) + "}";
    expect_mesh_refused(folder.put("a.gltf", document.text()), FLG_ERROR_LIMIT, "meshes[0].primitives[0]", "2 GiB");
}

TEST(GltfMesh, RoundTripsEveryBit) {
    const Folder folder;
    MeshInput mesh;
    mesh.positions = {0.1f, -7.5f, 1e-42f, 1e30f, 0.3f, 0, -7.7f, 1, 0.125f, 3, 4, 5};
    mesh.colors = {0.1f, 0.2f, 0.3f, 0.4f, 1, 0, 0, 1, 0, 0, 0, 0.5f, 0, 0, 0, 0};
    mesh.regions = {9, 4, 9, 7};
    ASSERT_EQ(write_mesh(folder.at("a.glb"), mesh), FLG_OK) << flgIoErrorGetMessage();
    ReadMesh again = read_mesh(folder.at("a.glb"));
    ASSERT_EQ(again.result, FLG_OK) << again.error;
    EXPECT_EQ(again.positions(), mesh.positions);
    EXPECT_EQ(again.colors(), mesh.colors);
    EXPECT_EQ(again.triangles, mesh.triangles);
    EXPECT_EQ(again.regions, Indices{});
    // With regions: by region, in their order, vertices still shared.
    mesh.split_regions = true;
    ASSERT_EQ(write_mesh(folder.at("b.glb"), mesh), FLG_OK) << flgIoErrorGetMessage();
    ReadMesh split = read_mesh(folder.at("b.glb"));
    EXPECT_EQ(split.positions(), mesh.positions);
    EXPECT_EQ(split.triangles, (Indices{0, 1, 3, 1, 2, 3, 0, 2, 1, 0, 3, 2}));
    EXPECT_EQ(split.regions, (Indices{0, 1, 2, 2}));
}

FlgMeshMaterial gold() {
    FlgMeshMaterial material = flgMeshMaterialDefaults();
    material.name = "g\"\xc3\xb6\\ld";
    for (size_t k = 0; k < 3; ++k) material.color[k] = 0.1f + 0.3f * static_cast<float>(k);
    material.metallic = 1;
    material.roughness = 0.3f;
    material.border_color[1] = 0.7f;
    material.border_width_px = 1.3f;
    return material;
}

// A tetrahedron whose faces have the materials 2, 0, 2, 3 of four.
MeshInput painted() {
    MeshInput mesh;
    mesh.regions = {2, 0, 2, 3};
    mesh.materials.resize(4, flgMeshMaterialDefaults());
    mesh.materials[2] = gold();
    mesh.split_regions = true;
    return mesh;
}

TEST(GltfMesh, MaterialsRoundTripWithoutThoseThatNoRegionHas) {
    const Folder folder;
    MeshInput mesh = painted();
    ASSERT_EQ(write_mesh(folder.at("a.glb"), mesh), FLG_OK) << flgIoErrorGetMessage();
    ReadMesh again = read_mesh(folder.at("a.glb"));
    ASSERT_EQ(again.result, FLG_OK) << again.error;
    EXPECT_EQ(again.positions(), mesh.positions) << "vertices are shared";
    EXPECT_EQ(again.regions, (Indices{0, 1, 1, 2}));
    EXPECT_EQ(again.material_names, (std::vector<std::string>{"region 0", gold().name, "region 3"}));
    const FlgMeshMaterial &read = again.materials[1], written = gold();
    EXPECT_TRUE(std::equal(read.color, read.color + 3, written.color));
    EXPECT_EQ(read.metallic, written.metallic);
    EXPECT_EQ(read.roughness, written.roughness);
    EXPECT_TRUE(std::equal(read.border_color, read.border_color + 3, written.border_color));
    EXPECT_EQ(read.border_width_px, written.border_width_px);
    EXPECT_EQ(again.materials[2].border_width_px, 0.0f);
    // Of one region there are no labels, but there is its material.
    mesh.regions.assign(4, 2);
    ASSERT_EQ(write_mesh(folder.at("b.glb"), mesh), FLG_OK) << flgIoErrorGetMessage();
    again = read_mesh(folder.at("b.glb"));
    EXPECT_EQ(again.regions, Indices{});
    EXPECT_EQ(again.material_names, std::vector<std::string>{gold().name});
    // Without a table materials have no colour, and are not handed out.
    mesh.materials.clear();
    mesh.regions = {2, 0, 2, 3};
    ASSERT_EQ(write_mesh(folder.at("c.glb"), mesh), FLG_OK) << flgIoErrorGetMessage();
    EXPECT_TRUE(read_mesh(folder.at("c.glb")).materials.empty());
}

TEST(GltfMesh, MaterialsOfOtherProgramsHaveTheFormatsDefaults) {
    const Folder folder;
    const auto material_of = [&](const std::string& materials) {
        Document document = document_of(R"({"attributes": {"POSITION": 0}, "indices": 1, "material": 0})");
        add_indices(document, {0, 1, 2});
        document.nodes = "\"materials\": [" + materials + "],";
        return read_mesh(folder.put("a.gltf", document.text()));
    };
    EXPECT_TRUE(material_of(R"({"pbrMetallicRoughness": {"metallicFactor": 0}})").materials.empty());
    ReadMesh mesh = material_of(R"({"extras": 7, "pbrMetallicRoughness": {"baseColorFactor": [0.25, 2, -1, 1]}})");
    ASSERT_EQ(mesh.materials.size(), 1u) << mesh.error;
    EXPECT_EQ(mesh.material_names[0], "");
    EXPECT_EQ(Floats(mesh.materials[0].color, mesh.materials[0].color + 3), (Floats{0.25f, 1, 0}));
    EXPECT_EQ(mesh.materials[0].metallic, 1.0f);
    EXPECT_EQ(mesh.materials[0].roughness, 1.0f);
    EXPECT_EQ(mesh.materials[0].border_width_px, 0.0f);
    const auto refuse = [&](const std::string& material, const std::string& place, const std::string& reason) {
        const ReadMesh refused = material_of(material);
        EXPECT_EQ(refused.result, FLG_ERROR_FORMAT);
        EXPECT_NE(refused.error.find(":" + place + ": "), std::string::npos) << refused.error;
        EXPECT_NE(refused.error.find(reason), std::string::npos) << refused.error;
    };
    refuse("3", "materials[0]", "no object");
    refuse(R"({"pbrMetallicRoughness": 1})", "materials[0].pbrMetallicRoughness", "no object");
    refuse(R"({"pbrMetallicRoughness": {"baseColorFactor": [1, 1]}})",
           "materials[0].pbrMetallicRoughness.baseColorFactor", "has 2 numbers");
    refuse(R"({"pbrMetallicRoughness": {"baseColorFactor": ["1", 1, 1, 1]}})",
           "materials[0].pbrMetallicRoughness.baseColorFactor", "no number");
    refuse(R"({"pbrMetallicRoughness": {"roughnessFactor": []}})", "materials[0].pbrMetallicRoughness.roughnessFactor",
           "no number");
    refuse(R"({"extras": {"border_width_px": null}})", "materials[0].extras.border_width_px", "no number");
}

TEST(GltfMesh, MaterialsThatCantBeWrittenAreRefused) {
    const Folder folder;
    const auto refuse = [&](MeshInput mesh, const std::string& sentence) {
        EXPECT_EQ(write_mesh(folder.at("a.glb"), mesh), FLG_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(flgIoErrorGetMessage()).find(sentence), std::string::npos) << flgIoErrorGetMessage();
    };
    const auto refuse_material = [&](auto change, const std::string& sentence) {
        MeshInput mesh = painted();
        change(mesh.materials[3]);
        refuse(mesh, "desc.materials[3]." + sentence);
    };
    const std::string long_name(256, 'x');
    const float nan = std::numeric_limits<float>::quiet_NaN();
    refuse_material([](FlgMeshMaterial& m) { m.color[2] = 1.5f; }, "color: is 1.5, must be from 0 to 1");
    refuse_material([](FlgMeshMaterial& m) { m.metallic = -1; }, "metallic: is -1, must be from 0 to 1");
    refuse_material([&](FlgMeshMaterial& m) { m.roughness = nan; }, "roughness: is nan, must be from 0 to 1");
    refuse_material([](FlgMeshMaterial& m) { m.border_color[0] = 2; }, "border_color: is 2, must be from 0 to 1");
    refuse_material([](FlgMeshMaterial& m) { m.border_width_px = 65; }, "border_width_px: is 65, must be from 0 to 64");
    refuse_material([](FlgMeshMaterial& m) { m.name = "\xff"; }, "name: must be UTF-8");
    refuse_material([&](FlgMeshMaterial& m) { m.name = long_name.c_str(); }, "name: must be UTF-8");
    MeshInput mesh = painted();
    mesh.regions[1] = 4;
    refuse(mesh, "view.regions[1]: is 4, but there are 4 materials");
    const FlgMeshView view = mesh.view();
    FlgMeshFileWriteDesc desc = mesh.desc();
    desc.materials = nullptr;
    EXPECT_EQ(flgMeshFileWrite(folder.at("a.glb").c_str(), &view, &desc), FLG_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("desc.materials"), std::string::npos) << flgIoErrorGetMessage();
}

tinygltf::Model load_model(const std::string& path) {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error, warning;
    EXPECT_TRUE(loader.LoadBinaryFromFile(&model, &error, &warning, path)) << error;
    EXPECT_EQ(error + warning, "");
    return model;
}

template <class T>
std::vector<T> values_of(const tinygltf::Model& model, int index, size_t components) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(index)];
    const tinygltf::BufferView& view = model.bufferViews[static_cast<size_t>(accessor.bufferView)];
    std::vector<T> values(accessor.count * components);
    std::memcpy(values.data(), &model.buffers[0].data[view.byteOffset + accessor.byteOffset],
                values.size() * sizeof(T));
    return values;
}

TEST(GltfMesh, AnotherReaderFindsTheSame) {
    const Folder folder;
    MeshInput mesh;
    mesh.regions = {3, 3, 0, 3};
    mesh.split_regions = true;
    ASSERT_EQ(write_mesh(folder.at("a.glb"), mesh), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(folder.at("a.glb"));
    ASSERT_EQ(model.meshes.size(), 1u);
    ASSERT_EQ(model.meshes[0].primitives.size(), 2u);
    ASSERT_EQ(model.materials.size(), 2u);
    EXPECT_EQ(model.materials[0].name, "region 0");
    EXPECT_EQ(model.materials[1].name, "region 3");
    const tinygltf::Primitive& first = model.meshes[0].primitives[0];
    const tinygltf::Primitive& second = model.meshes[0].primitives[1];
    EXPECT_EQ(first.mode, TINYGLTF_MODE_TRIANGLES);
    EXPECT_EQ(values_of<uint32_t>(model, first.indices, 1), (Indices{0, 3, 2}));
    EXPECT_EQ(values_of<uint32_t>(model, second.indices, 1), (Indices{0, 2, 1, 0, 1, 3, 1, 2, 3}));
    EXPECT_EQ(values_of<float>(model, second.attributes.at("POSITION"), 3), mesh.positions);
    const tinygltf::Accessor& bounds = model.accessors[static_cast<size_t>(first.attributes.at("POSITION"))];
    EXPECT_EQ(bounds.minValues, (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(bounds.maxValues, (std::vector<double>{1, 1, 1}));
    // Outwards, by area: at the origin along the diagonal; at (1, 0, 0) two faces of area 1/2 and the slanted one.
    const Floats normals = values_of<float>(model, first.attributes.at("NORMAL"), 3);
    const float third = -1 / std::sqrt(3.0f);
    for (size_t k = 0; k < 3; ++k) EXPECT_FLOAT_EQ(normals[k], third);
    for (size_t k = 0; k < 3; ++k) EXPECT_FLOAT_EQ(normals[3 + k], k == 0 ? 1.0f : 0.0f);

    MeshInput with_materials = painted();
    ASSERT_EQ(write_mesh(folder.at("c.glb"), with_materials), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model colored = load_model(folder.at("c.glb"));
    ASSERT_EQ(colored.meshes[0].primitives.size(), 3u);
    ASSERT_EQ(colored.materials.size(), 3u);
    EXPECT_EQ(colored.materials[1].name, gold().name);
    const tinygltf::PbrMetallicRoughness& factors = colored.materials[1].pbrMetallicRoughness;
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(static_cast<float>(factors.baseColorFactor[k]), gold().color[k]);
    EXPECT_EQ(factors.baseColorFactor[3], 1.0);
    EXPECT_EQ(factors.metallicFactor, 1.0);
    EXPECT_EQ(static_cast<float>(factors.roughnessFactor), gold().roughness);
    EXPECT_EQ(colored.meshes[0].primitives[1].material, 1);

    MeshInput given;
    given.normals = {2, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0, 0, -1};
    ASSERT_EQ(write_mesh(folder.at("b.glb"), given), FLG_OK);
    const tinygltf::Model with_normals = load_model(folder.at("b.glb"));
    ASSERT_EQ(with_normals.materials.size(), 1u);
    EXPECT_EQ(values_of<float>(with_normals, with_normals.meshes[0].primitives[0].attributes.at("NORMAL"), 3),
              (Floats{1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1}));
}

}  // namespace
}  // namespace flg::test
