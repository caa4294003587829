// SPDX-License-Identifier: MIT
// Assets whose triangles were cut: what nobody asked to change is there again, and what was cut has the mix that its
// place asks for. Read by another reader of glTF (tinygltf), which keeps what it doesn't know.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "io/gltf_files.h"
#include "io/skin_files.h"
#include "io/tinygltf_model.h"

namespace flg::test {
namespace {

using Json = nlohmann::json;

// A document under construction: accessors in one buffer.
struct Asset {
    std::string bytes;
    Json json = {{"asset", {{"version", "2.0"}, {"generator", "a test"}}}, {"scene", 0}};

    template <class T>
    size_t add(const std::vector<T>& values, int components, int type, bool normalized = false) {
        const char* const names[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", values.size() * sizeof(T)}});
        bytes += bytes_of(values);
        bytes.resize((bytes.size() + 3) / 4 * 4);
        json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                     {"componentType", type},
                                     {"count", values.size() / static_cast<size_t>(components)},
                                     {"type", names[components]}});
        if (normalized) json["accessors"].back()["normalized"] = true;
        return json["accessors"].size() - 1;
    }
    size_t add(const Floats& values, int components) { return add(values, components, 5126); }
    std::string text() const {
        Json whole = json;
        whole["buffers"] = {
            {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
        return whole.dump();
    }
};

// Two triangles of a square with a seam along the diagonal, across which hard edges, texture and sign of the tangents
// differ; skinned, with a shape; and beside it a triangle of another mesh.
Asset square() {
    Asset a;
    const std::vector<uint16_t> indices = {0, 1, 2, 3, 4, 5};
    a.json["meshes"] = {
        {{"name", "square"},
         {"weights", {0.5}},
         {"primitives",
          {{{"attributes",
             {{"POSITION", a.add(Floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0}, 3)},
              {"NORMAL", a.add(Floats{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0.6f, 0.8f, 0, 0.6f, 0.8f, 0, 0.6f, 0.8f}, 3)},
              {"TANGENT", a.add(Floats{1, 0, 0, 1, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1, 1, 0, 0, -1, 1, 0, 0, -1}, 4)},
              {"TEXCOORD_0", a.add(Floats{0, 0, 0.25f, 0, 0.5f, 0.5f, 0.75f, 0, 1, 0.25f, 0.5f, 1}, 2)},
              {"COLOR_0", a.add(std::vector<uint8_t>{0, 0, 0, 255, 255, 0,   0, 255, 255, 255, 0,   255,
                                                     0, 0, 0, 255, 255, 255, 0, 255, 0,   0,   255, 255},
                                4, 5121, true)},
              {"JOINTS_0",
               a.add(std::vector<uint8_t>{0, 0, 0, 0, 0, 1, 0, 0, 1, 2, 3, 0, 0, 0, 0, 0, 1, 2, 3, 0, 2, 0, 0, 0}, 4,
                     5121)},
              {"WEIGHTS_0", a.add(Floats{1, 0, 0, 0, 0.5f, 0.5f,  0,     0, 0.5f, 0.25f, 0.25f, 0,
                                         1, 0, 0, 0, 0.5f, 0.25f, 0.25f, 0, 1,    0,     0,     0},
                                  4)},
              {"_PART", a.add(Floats{0, 1, 2, 0, 2, 3}, 1)}}},
            {"targets", {{{"POSITION", a.add(Floats{0, 0, 1, 0, 0, 0, 0, 0, 2, 0, 0, 1, 0, 0, 2, 0, 0, 0}, 3)}}}},
            {"indices", a.add(indices, 1, 5123)},
            {"material", 0},
            {"extras", {{"kept", true}}}}}}},
        {{"primitives", {{{"attributes", {{"POSITION", a.add(Floats{5, 0, 0, 6, 0, 0, 5, 1, 0}, 3)}}}}}}}};
    a.json["materials"] = {{{"name", "own"}, {"emissiveFactor", {0, 0.25, 1}}}};
    a.json["nodes"] = {{{"mesh", 0}, {"skin", 0}, {"name", "shown"}},
                       {{"mesh", 1}},
                       {{"translation", {0, 1, 0}}},
                       {{"name", "b"}},
                       {{"name", "c"}},
                       {{"name", "d"}}};
    a.json["scenes"] = {{{"nodes", {0, 1, 2, 3, 4, 5}}, {"extras", "of a scene"}}};
    Floats inverse;
    for (int j = 0; j < 4; ++j) inverse.insert(inverse.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    a.json["skins"] = {{{"joints", {2, 3, 4, 5}}, {"inverseBindMatrices", a.add(inverse, 4)}}};
    a.json["accessors"].back()["type"] = "MAT4";
    a.json["accessors"].back()["count"] = 4;
    a.json["animations"] = {
        {{"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "scale"}}}}}},
         {"samplers", {{{"input", a.add(Floats{0, 1}, 1)}, {"output", a.add(Floats{1, 1, 1, 2, 2, 2}, 3)}}}}}};
    a.json["accessors"][a.json["accessors"].size() - 2]["min"] = {0};
    a.json["accessors"][a.json["accessors"].size() - 2]["max"] = {1};
    a.json["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.01}}}}};
    a.json["extras"] = {{"a", {1, -2.5, "\u00e9"}}, {"b", nullptr}};
    return a;
}

// A file's mesh, welded by place, and where it lies on itself.
struct Surface {
    Floats positions;
    std::vector<uint32_t> triangles, labels, sources, roots;
    std::vector<FlgSourceWeights> weights;

    explicit Surface(const std::string& path) {
        FlgMeshFile file = nullptr;
        EXPECT_EQ(flgMeshFileRead(path.c_str(), nullptr, &file), FLG_OK) << flgIoErrorGetMessage();
        FlgMeshView view = sized<FlgMeshView>();
        EXPECT_EQ(flgMeshFileGetView(file, &view), FLG_OK);
        std::map<std::array<float, 3>, uint32_t> root_at;
        std::map<uint32_t, uint32_t> vertex_of;
        const float* p = view.columns[0].data;
        for (uint32_t c = 0; c < 3 * view.triangle_count; ++c) {
            const uint32_t v = view.triangles[c];
            const uint32_t root = root_at.try_emplace({p[3 * v], p[3 * v + 1], p[3 * v + 2]}, v).first->second;
            const auto [found, is_new] = vertex_of.try_emplace(root, static_cast<uint32_t>(weights.size()));
            if (is_new) {
                weights.push_back({{root, FLG_NO_INDEX, FLG_NO_INDEX}, {0, 0}});
                positions.insert(positions.end(), p + 3 * root, p + 3 * root + 3);
            }
            roots.push_back(root);
            triangles.push_back(found->second);
        }
        for (uint32_t t = 0; t < view.triangle_count; ++t) sources.push_back(t);
        labels.assign(view.triangle_count, 99);
        flgMeshFileRelease(file);
    }

    // Each of these triangles into four.
    void split(const std::set<uint32_t>& which) {
        std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
        const auto middle = [&](uint32_t a, uint32_t b) {
            const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<uint32_t>(weights.size()));
            if (is_new) {
                for (size_t k = 0; k < 3; ++k) positions.push_back((positions[3 * a + k] + positions[3 * b + k]) / 2);
                const uint32_t u = weights[a].vertices[0], v = weights[b].vertices[0];
                weights.push_back({{std::min(u, v), std::max(u, v), FLG_NO_INDEX}, {0.5f, 0}});
            }
            return found->second;
        };
        for (const uint32_t t : which) {
            const uint32_t a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
            const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            triangles[3 * t + 1] = ab;
            triangles[3 * t + 2] = ca;
            triangles.insert(triangles.end(), {ab, b, bc, bc, c, ca, ab, bc, ca});
            for (int i = 0; i < 3; ++i) {
                sources.push_back(sources[t]);
                labels.push_back(labels[t]);
            }
        }
    }

    FlgResult write(const std::string& asset, const std::string& path, uint32_t material_count = 0) {
        const FlgColumn column = {FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0};
        FlgMeshView mesh = sized<FlgMeshView>();
        mesh.vertex_count = static_cast<uint32_t>(weights.size());
        mesh.triangle_count = static_cast<uint32_t>(sources.size());
        mesh.columns = &column;
        mesh.column_count = 1;
        mesh.triangles = triangles.data();
        mesh.regions = labels.data();
        FlgSurfaceProvenanceView lies = sized<FlgSurfaceProvenanceView>();
        lies.vertex_count = mesh.vertex_count;
        lies.triangle_count = mesh.triangle_count;
        lies.input_triangle_count = static_cast<uint32_t>(roots.size() / 3);
        lies.triangles = sources.data();
        lies.input_vertices = roots.data();
        lies.weights = weights.data();
        std::vector<FlgMeshMaterial> materials(material_count, flgMeshMaterialDefaults());
        FlgMeshFileWriteDesc desc = flgMeshFileWriteDefaults();
        desc.materials = materials.data();
        desc.material_count = material_count;
        desc.asset = asset.c_str();
        desc.provenance = &lies;
        return flgMeshFileWrite(path.c_str(), &mesh, &desc);
    }
};

Json json_of(const std::string& glb) {
    uint32_t size = 0;
    std::memcpy(&size, glb.data() + 12, sizeof size);
    return Json::parse(glb.substr(20, size));
}

const tinygltf::Primitive& primitive_of(const tinygltf::Model& model, size_t mesh = 0, size_t primitive = 0) {
    return model.meshes.at(mesh).primitives.at(primitive);
}

std::vector<std::vector<float>> rows(const Floats& values, size_t width) {
    std::vector<std::vector<float>> rows;
    for (size_t i = 0; i < values.size(); i += width) rows.emplace_back(&values[i], &values[i] + width);
    return rows;
}

TEST(Asset, WhatNobodyChangedIsThereAgain) {
    const Folder folder;
    Asset asset = square();
    // Unknown to this library: it may refer to anything.
    asset.json["extensionsUsed"] = {"ACME_secret"};
    asset.json["extensions"] = {{"ACME_secret", {{"number", 1e-30}, {"accessor", 3}}}};
    const std::string path = folder.put("a.gltf", asset.text()), out = folder.at("out.glb");
    ASSERT_EQ(Surface(path).write(path, out), FLG_OK) << flgIoErrorGetMessage();
    const std::string glb = slurp(out);
    Json json = json_of(glb), expected = asset.json;
    EXPECT_EQ(json["buffers"], Json::parse(R"([{"byteLength": )" + std::to_string(asset.bytes.size()) + "}]"));
    json.erase("buffers");
    EXPECT_EQ(json, expected);
    EXPECT_EQ(glb.substr(glb.size() - asset.bytes.size()), asset.bytes);
}

TEST(Asset, PicturesOfOtherFilesBecomePartOfIt) {
    const Folder folder;
    Asset asset = square();
    asset.json["images"] = {{{"uri", "skin.png"}, {"name", "fur"}, {"extras", 7}}};
    asset.json["textures"] = {{{"source", 0}}};
    const std::string picture(reinterpret_cast<const char*>(red_pixel), sizeof red_pixel);
    folder.put("skin.png", picture);
    const std::string path = folder.put("a.gltf", asset.text()), out = folder.at("out.glb");
    ASSERT_EQ(Surface(path).write(path, out), FLG_OK) << flgIoErrorGetMessage();
    const std::string glb = slurp(out);
    const Json image = json_of(glb)["images"][0];
    EXPECT_EQ(image["mimeType"], "image/png");
    EXPECT_EQ(image["name"], "fur");
    EXPECT_EQ(image["extras"], 7);
    const Json view = json_of(glb)["bufferViews"][image["bufferView"].get<size_t>()];
    const size_t begin = glb.size() - json_of(glb)["buffers"][0]["byteLength"].get<size_t>();
    EXPECT_EQ(glb.substr(begin + view["byteOffset"].get<size_t>(), view["byteLength"]), picture);
    folder.put("skin.png", "no picture");
    EXPECT_EQ(Surface(path).write(path, out), FLG_ERROR_FORMAT);
    EXPECT_NE(std::string(flgIoErrorGetMessage()).find("images[0].uri"), std::string::npos) << flgIoErrorGetMessage();
    EXPECT_TRUE(slurp(out) == glb) << "what is there stays";
}

TEST(Asset, WhatIsCutHasTheMixOfItsPlace) {
    const Folder folder;
    Asset asset = square();
    const std::string path = folder.put("a.gltf", asset.text()), out = folder.at("out.glb");
    Surface surface(path);
    surface.split({0, 1});
    ASSERT_EQ(surface.write(path, out), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(out);
    ASSERT_EQ(model.meshes[0].primitives.size(), 1u);
    const tinygltf::Primitive& primitive = primitive_of(model);
    EXPECT_EQ(primitive.material, 0);
    EXPECT_TRUE(primitive.extras.Get("kept").Get<bool>());
    const auto floats = [&](const char* name) { return values_of<float>(model, primitive.attributes.at(name)); };
    // Six that were, three middles of each side of the seam.
    const Floats uvs = floats("TEXCOORD_0"), positions = floats("POSITION"), normals = floats("NORMAL");
    ASSERT_EQ(uvs.size(), 2u * 12);
    const Floats before = {0, 0, 0.25f, 0, 0.5f, 0.5f, 0.75f, 0, 1, 0.25f, 0.5f, 1};
    EXPECT_EQ(Floats(uvs.begin(), uvs.begin() + 12), before);
    const std::set<std::vector<float>> middles = {{0.125f, 0},      {0.375f, 0.25f}, {0.25f, 0.25f},
                                                  {0.875f, 0.125f}, {0.75f, 0.625f}, {0.625f, 0.5f}};
    const auto new_uvs = rows(Floats(uvs.begin() + 12, uvs.end()), 2);
    EXPECT_EQ(std::set<std::vector<float>>(new_uvs.begin(), new_uvs.end()), middles);
    const Floats tangents = floats("TANGENT"), colors = floats("COLOR_0"), weights = floats("WEIGHTS_0"),
                 parts = floats("_PART");
    const auto joints = values_of<uint8_t>(model, primitive.attributes.at("JOINTS_0"));
    const Floats moves = [&] {
        const tinygltf::Accessor& accessor = model.accessors[static_cast<size_t>(primitive.targets[0].at("POSITION"))];
        if (!accessor.sparse.isSparse) return values_of<float>(model, primitive.targets[0].at("POSITION"));
        ADD_FAILURE() << "half of them move";
        return Floats{};
    }();
    for (size_t v = 6; v < 12; ++v) {
        SCOPED_TRACE(v);
        const float x = positions[3 * v], y = positions[3 * v + 1];
        const bool lower = uvs[2 * v] < 0.5f && uvs[2 * v + 1] < 0.5f && uvs[2 * v] < 0.5f && normals[3 * v + 2] == 1;
        EXPECT_EQ(normals[3 * v + 1], lower ? 0 : 0.6f);
        EXPECT_EQ(tangents[4 * v + 3], lower ? 1 : -1);
        EXPECT_NEAR(std::hypot(tangents[4 * v], tangents[4 * v + 1], tangents[4 * v + 2]), 1, 1e-6);
        EXPECT_NEAR(weights[4 * v] + weights[4 * v + 1] + weights[4 * v + 2] + weights[4 * v + 3], 1, 1e-6);
        EXPECT_EQ(parts[v], std::floor(parts[v]));
        if (x == 0.5f && y == 0.5f) {
            // Between joint 0, and joints 1 to 3.
            std::map<uint8_t, float> influences;
            for (size_t k = 0; k < 4; ++k) influences[joints[4 * v + k]] += weights[4 * v + k];
            EXPECT_EQ(influences, (std::map<uint8_t, float>{{0, 0.5f}, {1, 0.25f}, {2, 0.125f}, {3, 0.125f}}));
            EXPECT_EQ(moves[3 * v + 2], 1.5f);
            EXPECT_EQ(rows(colors, 4)[v], (std::vector<float>{0.5f, 0.5f, 0, 1}));
        }
    }
    // Triangles keep their side.
    const auto indices = values_of<uint16_t>(model, primitive.indices);
    ASSERT_EQ(indices.size(), 3u * 8);
    double area = 0;
    for (size_t i = 0; i < indices.size(); i += 3) {
        const auto at = [&](size_t k) { return &positions[3 * size_t{indices[i + k]}]; };
        const double twice =
            (at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) - (at(2)[0] - at(0)[0]) * (at(1)[1] - at(0)[1]);
        EXPECT_GT(twice, 0);
        area += twice / 2;
    }
    EXPECT_NEAR(area, 1, 1e-6);
    // What only triangles of before used is gone, and nothing else has moved.
    const Json json = json_of(slurp(out));
    EXPECT_EQ(json["accessors"].size(), asset.json["accessors"].size());
    for (const char* const list : {"nodes", "scenes", "skins", "animations", "cameras", "materials", "extras"})
        EXPECT_EQ(json[list], asset.json[list]) << list;
    EXPECT_EQ(json["meshes"][1], asset.json["meshes"][1]);
    EXPECT_EQ(values_of<float>(model, model.animations[0].samplers[0].output), (Floats{1, 1, 1, 2, 2, 2}));
    EXPECT_EQ(values_of<float>(model, primitive_of(model, 1).attributes.at("POSITION")),
              (Floats{5, 0, 0, 6, 0, 0, 5, 1, 0}));
}

// Posed by any matrices, a middle is the middle of the posed ends: as finer meshes are.
TEST(Asset, PosesLikeTheFinerMesh) {
    const Folder folder;
    const std::string path = folder.put("a.gltf", square().text()), out = folder.at("out.glb");
    Surface surface(path);
    surface.split({0, 1});
    ASSERT_EQ(surface.write(path, out), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(out);
    const tinygltf::Primitive& primitive = primitive_of(model);
    const auto weights = values_of<float>(model, primitive.attributes.at("WEIGHTS_0"));
    const auto joints = values_of<uint8_t>(model, primitive.attributes.at("JOINTS_0"));
    const auto uvs = rows(values_of<float>(model, primitive.attributes.at("TEXCOORD_0")), 2);
    // Joints move by numbers of their own; linear blending is linear in the weights where all ends move alike.
    const double shift[] = {0.5, -1.25, 3, 10};
    const auto moved = [&](size_t v) {
        double sum = 0;
        for (size_t k = 0; k < 4; ++k) sum += double{weights[4 * v + k]} * shift[joints[4 * v + k]];
        return sum;
    };
    size_t pairs = 0;
    for (size_t v = 6; v < uvs.size(); ++v) {
        for (size_t a = 0; a < 6; ++a) {
            for (size_t b = a + 1; b < 6; ++b) {
                if (a / 3 != b / 3 || uvs[v][0] != (uvs[a][0] + uvs[b][0]) / 2 ||
                    uvs[v][1] != (uvs[a][1] + uvs[b][1]) / 2)
                    continue;
                ++pairs;
                EXPECT_NEAR(moved(v), (moved(a) + moved(b)) / 2, 1e-6);
            }
        }
    }
    EXPECT_EQ(pairs, 6u);
}

TEST(Asset, RegionsWithAMaterialBecomePrimitives) {
    const Folder folder;
    Asset asset = square();
    const std::string path = folder.put("a.gltf", asset.text()), out = folder.at("out.glb");
    Surface surface(path);
    surface.labels[1] = 1;
    ASSERT_EQ(surface.write(path, out, 2), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(out);
    ASSERT_EQ(model.meshes[0].primitives.size(), 2u);
    std::set<int> materials;
    for (const tinygltf::Primitive& primitive : model.meshes[0].primitives) {
        materials.insert(primitive.material);
        EXPECT_EQ(values_of<uint16_t>(model, primitive.indices).size(), 3u);
        // Vertices are shared; their colours would tint the new material.
        auto attributes = primitive.attributes;
        EXPECT_EQ(attributes.erase("COLOR_0"), primitive.material == 0 ? 1u : 0u);
        auto first = primitive_of(model).attributes;
        first.erase("COLOR_0");
        EXPECT_EQ(attributes, first);
    }
    EXPECT_EQ(materials, (std::set<int>{0, 1}));
    EXPECT_EQ(model.materials.size(), 2u) << "the one that no region has is left out";
    EXPECT_EQ(json_of(slurp(out))["materials"][0], asset.json["materials"][0]);
}

TEST(Asset, AMeshOfTwoNodesIsDividedWhereTheyDiffer) {
    const Folder folder;
    Asset asset = square();
    asset.json["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {3, 0, 0}}, {"name", "other"}}};
    asset.json["scenes"] = {{{"nodes", {0, 1}}}};
    asset.json.erase("skins");
    asset.json.erase("animations");
    const std::string path = folder.put("a.gltf", asset.text()), out = folder.at("out.glb");
    Surface surface(path);
    surface.split({3});
    ASSERT_EQ(surface.write(path, out), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(out);
    ASSERT_EQ(model.meshes.size(), 3u);
    EXPECT_EQ(model.nodes[0].mesh, 0);
    EXPECT_EQ(model.nodes[1].mesh, 2);
    EXPECT_EQ(model.nodes[1].name, "other");
    EXPECT_EQ(json_of(slurp(out))["meshes"][0], asset.json["meshes"][0]);
    const Floats positions = values_of<float>(model, primitive_of(model, 2).attributes.at("POSITION"));
    EXPECT_EQ(positions.size(), 3u * 9);
    EXPECT_LE(*std::max_element(positions.begin(), positions.end()), 1) << "in the mesh's coordinates";
}

TEST(Asset, UnderAMirrorTrianglesKeepTheirSideAndMovedVerticesTheirPlace) {
    const Folder folder;
    Asset asset = square();
    asset.json["nodes"] = {{{"mesh", 0}, {"scale", {-2, 2, 2}}, {"translation", {0, 0, 7}}}};
    asset.json["scenes"] = {{{"nodes", {0}}}};
    asset.json.erase("skins");
    asset.json.erase("animations");
    const std::string path = folder.put("a.gltf", asset.text()), out = folder.at("out.glb");
    Surface surface(path);
    surface.split({0, 1});
    // The middle of the diagonal rises by 1, half of that in the mesh's coordinates.
    for (size_t v = 0; v < surface.weights.size(); ++v) {
        if (surface.positions[3 * v] == -1 && surface.positions[3 * v + 1] == 1) surface.positions[3 * v + 2] += 1;
    }
    ASSERT_EQ(surface.write(path, out), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(out);
    const tinygltf::Primitive& primitive = primitive_of(model);
    const Floats positions = values_of<float>(model, primitive.attributes.at("POSITION"));
    const Floats normals = values_of<float>(model, primitive.attributes.at("NORMAL"));
    const auto indices = values_of<uint16_t>(model, primitive.indices);
    size_t risen = 0;
    for (size_t v = 0; v < positions.size() / 3; ++v) {
        if (positions[3 * v] != 0.5f || positions[3 * v + 1] != 0.5f) {
            EXPECT_EQ(positions[3 * v + 2], 0) << v;
            continue;
        }
        ++risen;
        EXPECT_NEAR(positions[3 * v + 2], 0.5f, 1e-6);
        EXPECT_NEAR(std::hypot(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]), 1, 1e-6);
        // On either side of the hard edge the normal is that of the slope there, not the flat one's.
        EXPECT_GT(std::abs(normals[3 * v]) + std::abs(normals[3 * v + 1]), 0.3);
        EXPECT_GT(normals[3 * v + 2], 0.3);
    }
    EXPECT_EQ(risen, 2u);
    for (size_t i = 0; i < indices.size(); i += 3) {
        const auto at = [&](size_t k) { return &positions[3 * size_t{indices[i + k]}]; };
        EXPECT_GT((at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) - (at(2)[0] - at(0)[0]) * (at(1)[1] - at(0)[1]), 0);
    }
}

TEST(Asset, TrianglesThatTheSurfaceLostAreWrittenAsTheyWere) {
    const Folder folder;
    const std::string path = folder.put("a.gltf", square().text()), out = folder.at("out.glb");
    Surface surface(path);
    surface.split({0});
    // As if the second were a duplicate.
    const auto drop = [](std::vector<uint32_t>& list, size_t first, size_t count) {
        list.erase(list.begin() + static_cast<ptrdiff_t>(first), list.begin() + static_cast<ptrdiff_t>(first + count));
    };
    drop(surface.triangles, 3, 3);
    drop(surface.sources, 1, 1);
    drop(surface.labels, 1, 1);
    ASSERT_EQ(surface.write(path, out), FLG_OK) << flgIoErrorGetMessage();
    const tinygltf::Model model = load_model(out);
    EXPECT_EQ(values_of<uint16_t>(model, primitive_of(model).indices).size(), 3u * 5);
    EXPECT_EQ(values_of<float>(model, primitive_of(model).attributes.at("TEXCOORD_0")).size(), 2u * 9);
}

TEST(Asset, WhatDoesNotFitIsRefused) {
    const Folder folder;
    const std::string path = folder.put("a.gltf", square().text()), out = folder.at("out.glb");
    const auto expect_refused = [&](Surface surface, const std::string& asset, const std::string& to, FlgResult result,
                                    const char* words) {
        EXPECT_EQ(surface.write(asset, to), result);
        EXPECT_NE(std::string(flgIoErrorGetMessage()).find(words), std::string::npos) << flgIoErrorGetMessage();
        EXPECT_EQ(slurp(to), "");
    };
    const Surface sound(path);
    expect_refused(sound, folder.at("none.glb"), out, FLG_ERROR_FILE, "none.glb");
    expect_refused(sound, path, folder.at("out.ply"), FLG_ERROR_INVALID_ARGUMENT, "desc.asset");
    Surface other = sound;
    other.roots.resize(6);
    other.triangles.resize(6);
    other.sources.resize(2);
    other.labels.resize(2);
    expect_refused(other, path, out, FLG_ERROR_INVALID_ARGUMENT, "desc.provenance.input_triangle_count: is 2, but");
    other = sound;
    other.sources[0] = 3;
    expect_refused(other, path, out, FLG_ERROR_INVALID_ARGUMENT, "desc.provenance.triangles[0]: is 3");
    other = sound;
    other.weights[0].vertices[0] = 8;
    expect_refused(other, path, out, FLG_ERROR_INVALID_ARGUMENT, "desc.provenance.weights[0]");
    other = sound;
    other.weights[0].vertices[0] = FLG_NO_INDEX;
    expect_refused(other, path, out, FLG_ERROR_INVALID_ARGUMENT, "names no vertex");
    // What is wrong in the asset is named there.
    const auto expect_bad_asset = [&](const Asset& asset, const char* words) {
        const std::string bad = folder.put("bad.gltf", asset.text());
        Surface cut(bad);
        cut.split({0});
        expect_refused(cut, bad, out, FLG_ERROR_FORMAT, words);
    };
    Asset asset = square();
    asset.json["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
    expect_bad_asset(asset, "has one alone of JOINTS_0 and WEIGHTS_0");
    asset = square();
    Json& attributes = asset.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = attributes["WEIGHTS_0"];
    expect_bad_asset(asset, "joints that are no whole numbers");
}

}  // namespace
}  // namespace flg::test
