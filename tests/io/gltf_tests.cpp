// SPDX-License-Identifier: MIT
// glTF lines: round trips, nodes and layouts of other programs, and what is refused.
#include <limits>

#include "io/gltf_files.h"

namespace flg::test {
namespace {

TEST(Gltf, LinesRoundTripExactly) {
    const Folder folder;
    Curves curves;
    curves.add({0.1f, 0.2f, 0.3f, 1e-20f, -7.7f, 1e20f});
    curves.add({0, 0, 0, 1, 0, 0, 0, 1, 0}, true);
    curves.add({5, 6, 7});
    for (size_t i = 0; i < 6; ++i) {
        curves.radii.push_back(0.1f * static_cast<float>(i));
        curves.colors.insert(curves.colors.end(), {0.1f * static_cast<float>(i), 0.3f, 1, 0.5f});
    }
    ASSERT_EQ(write(folder.at("a.glb"), curves), FLG_OK) << flgIoErrorGetMessage();
    const Read again = read(folder.at("a.glb"));
    ASSERT_EQ(again.result, FLG_OK) << again.error;
    EXPECT_EQ(again.positions(), curves.positions);
    EXPECT_EQ(again.column(FLG_ATTRIBUTE_RADIUS), curves.radii);
    EXPECT_EQ(again.column(FLG_ATTRIBUTE_COLOR), curves.colors);
    EXPECT_EQ(again.offsets, curves.offsets);
    EXPECT_EQ(again.flags, curves.flags);
    EXPECT_EQ(again.format, "gltf");
}

TEST(Gltf, ColoursAreClampedOnWriting) {
    const Folder folder;
    Curves curves;
    curves.add({0, 0, 0, 1, 0, 0});
    curves.colors = {2, -1, 0.5f, 1, 0, 0, 0, 1};
    ASSERT_EQ(write(folder.at("a.glb"), curves), FLG_OK) << flgIoErrorGetMessage();
    EXPECT_EQ(read(folder.at("a.glb")).column(FLG_ATTRIBUTE_COLOR), (Floats{1, 0, 0.5f, 1, 0, 0, 0, 1}));
}

TEST(Gltf, AppliesNodesFromTheRootDown) {
    const Folder folder;
    Document document;
    // Half a turn about z, then doubled, then moved: (1, 0, 0) -> (-1, 0, 0) -> (-2, 0, 0) -> (8, 0, 0).
    document.nodes = R"("scene": 1, "scenes": [{"nodes": [2]}, {"nodes": [1]}], "nodes": [
        {"mesh": 0, "rotation": [0, 0, 1, 0]},
        {"children": [0], "matrix": [2,0,0,0, 0,2,0,0, 0,0,2,0, 10,0,0,1]},
        {"mesh": 0}],)";
    document.primitive = R"({"attributes": {"POSITION": 0, "_RADIUS": 1}, "mode": 2})";
    document.more = bytes_of(Floats{1, 1, 1, 0.25f});
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 16})";
    document.accessors = R"(, {"bufferView": 1, "componentType": 5126, "count": 4, "type": "SCALAR"})";
    const Read curves = read(folder.put("a.gltf", document.text()));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.positions(), (Floats{10, 0, 0, 8, 0, 0, 8, -2, 0, 10, -2, 0}));
    EXPECT_EQ(curves.column(FLG_ATTRIBUTE_RADIUS), (Floats{2, 2, 2, 0.5f}));
    EXPECT_EQ(curves.flags, std::vector<uint8_t>{FLG_CURVE_CLOSED});
}

TEST(Gltf, JoinsSingleLinesThatChain) {
    const Folder folder;
    Document document;
    document.primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "mode": 1})";
    document.more = bytes_of(std::vector<uint16_t>{0, 1, 1, 2, 3, 1, 0, 1, 1, 2, 2, 0});
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 24})";
    document.accessors = R"(, {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"})";
    const Read curves = read(folder.put("a.gltf", document.text()));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    EXPECT_EQ(curves.offsets, (std::vector<uint32_t>{0, 3, 5, 8}));
    EXPECT_EQ(curves.flags, (std::vector<uint8_t>{0, 0, 1}));

    // Without indices: by position.
    Document plain;
    plain.primitive = R"({"attributes": {"POSITION": 0}, "mode": 1})";
    plain.points = {0, 0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0};
    EXPECT_EQ(read(folder.put("b.gltf", plain.text())).offsets, (std::vector<uint32_t>{0, 3}));
}

TEST(Gltf, ReadsBytesAsColoursAndFillsUp) {
    const Folder folder;
    Document document;
    document.primitive = R"({"attributes": {"POSITION": 0, "COLOR_0": 1}, "mode": 3},
                            {"attributes": {"POSITION": 0}, "mode": 3}, {"attributes": {"POSITION": 0}})";
    document.more = std::string("\xff\x00\x33.\x00\xff\x00.\x00\x00\xff.\xff\xff\xff.", 16);
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 16, "byteStride": 4})";
    document.accessors =
        R"(, {"bufferView": 1, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC3"})";
    const Read curves = read(folder.put("a.gltf", document.text()));
    ASSERT_EQ(curves.result, FLG_OK) << curves.error;
    const Floats& colors = curves.column(FLG_ATTRIBUTE_COLOR);
    ASSERT_EQ(colors.size(), 32u);
    EXPECT_EQ(Floats(colors.begin(), colors.begin() + 4), (Floats{1, 0, 0.2f, 1}));
    EXPECT_EQ(Floats(colors.begin() + 16, colors.end()), Floats(16, 1.0f));
    EXPECT_NE(curves.warnings.find("1 primitive: of points or triangles, left out"), std::string::npos);
}

TEST(Gltf, BuffersStayBelowTheFilesFolder) {
    const Folder folder;
    Document document;
    document.uri = "data/curve%20points.bin";
    folder.put("in/data/curve points.bin", bytes_of(document.points));
    folder.put("secret.bin", bytes_of(document.points));
    EXPECT_EQ(read(folder.put("in/a.gltf", document.text())).result, FLG_OK);
    std::filesystem::create_symlink(folder.at("secret.bin"), folder.at("in/link.bin"));
    for (const std::string& uri :
         {std::string("../secret.bin"), std::string("data/../../secret.bin"), std::string("%2e%2e/secret.bin"),
          folder.at("secret.bin"), "file://" + folder.at("secret.bin"), std::string("..\\\\secret.bin"),
          std::string("link.bin"), std::string("a%00.bin")}) {
        document.uri = uri;
        expect_refused(folder.put("in/a.gltf", document.text()), FLG_ERROR_FORMAT, "buffers[0].uri", "folder");
    }
    document.uri = "missing.bin";
    expect_refused(folder.put("in/a.gltf", document.text()), FLG_ERROR_FILE, "buffers[0].uri", "can't be opened");
    document.uri = "data";
    expect_refused(folder.put("in/a.gltf", document.text()), FLG_ERROR_FILE, "buffers[0].uri", "not a regular file");
}

TEST(Gltf, RefusesWithThePlace) {
    const Folder folder;
    const auto refuse = [&](const Document& document, const char* place, const char* reason) {
        expect_refused(folder.put("a.gltf", document.text()), FLG_ERROR_FORMAT, place, reason);
    };
    const auto accessor = [](const char* text) {
        Document document;
        document.positions = text;
        return document;
    };
    refuse(accessor(R"({"bufferView": 0, "componentType": 5126, "count": 5, "type": "VEC3"})"), "accessors[0].count",
           "is 5, but its bufferView holds 4");
    refuse(accessor(R"({"bufferView": 0, "componentType": 5126, "count": 18446744073709551615, "type": "VEC3"})"),
           "accessors[0].count", "holds 4");
    refuse(accessor(R"({"bufferView": 0, "componentType": 5126, "count": 4, "byteOffset": 4, "type": "VEC3"})"),
           "accessors[0].count", "holds 3");
    refuse(accessor(R"({"bufferView": 0, "componentType": 5126, "count": -4, "type": "VEC3"})"), "accessors[0].count",
           "whole number");
    refuse(accessor(R"({"bufferView": 7, "componentType": 5126, "count": 4, "type": "VEC3"})"),
           "accessors[0].bufferView", "bufferViews 7 of 1");
    refuse(accessor(R"({"bufferView": 0, "componentType": 5124, "count": 4, "type": "VEC3"})"),
           "accessors[0].componentType", "5124");
    refuse(accessor(R"({"bufferView": 0, "componentType": 5125, "count": 4, "type": "VEC3"})"), "accessors[0]",
           "not three floats");
    refuse(accessor(R"({"componentType": 5126, "count": 0, "type": "VEC3"})"), "accessors[0].count", "is 0");
    refuse(accessor(R"({"componentType": 5126, "count": 2147483649, "type": "VEC3"})"), "accessors[0].count",
           "from 1 to 2147483648");
    refuse(accessor("17"), "accessors[0]", "no object");
    Document document;
    document.length = 1000;
    refuse(document, "buffers[0].byteLength", "is 1000, but 48 bytes");
    document = {};
    document.primitive = R"({"attributes": {"POSITION": 3}, "mode": 3})";
    refuse(document, "meshes[0].primitives[0].attributes.POSITION", "accessors 3 of 1");
    document.primitive = R"({"attributes": {}, "mode": 3})";
    refuse(document, "meshes[0].primitives[0].attributes", "no POSITION");
    document.primitive = R"({"attributes": {"POSITION": 0}, "mode": 4})";
    refuse(document, "meshes", "no lines");
    document.primitive = R"({"attributes": {"POSITION": 0}, "mode": 9})";
    refuse(document, "meshes[0].primitives[0].mode", "is 9");
    document = {};
    document.nodes = R"("scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "children": [0]}],)";
    refuse(document, "nodes[0]", "shown twice");
    document.nodes = R"("scenes": [{"nodes": [4]}], "nodes": [{"mesh": 0}],)";
    refuse(document, "nodes[4]", "nodes 4 of 1");
    document.nodes = R"("nodes": [{"mesh": 0, "scale": [1, "x", 1]}],)";
    refuse(document, "nodes[0].scale", "3 numbers");
    document = {};
    document.points[4] = std::numeric_limits<float>::quiet_NaN();
    refuse(document, "accessors[0]", "vertex 1 gives nan");
    document = {};
    document.primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "mode": 3})";
    document.more = bytes_of(std::vector<uint32_t>{0, 4});
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 8})";
    document.accessors = R"(, {"bufferView": 1, "componentType": 5125, "count": 2, "type": "SCALAR"})";
    refuse(document, "accessors[1]", "index 4 at 1, but there are 4 vertices");
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 9})";
    refuse(document, "bufferViews[1]", "9 bytes from 48, but its buffer has 56");
    document.uri = "data:text/plain;base64,????";
    refuse(document, "buffers[0].uri", "no base64: '?'");
}

TEST(Gltf, RefusesSparseValuesWithThePlace) {
    const Folder folder;
    // Indices of 8 bits from byte 48: 1 3 3 9; values from byte 0.
    const auto refuse = [&](const std::string& sparse, const char* place, const char* reason) {
        Document document;
        document.more = std::string("\1\3\3\x9", 4);
        document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": 4},
                             {"buffer": 0, "byteLength": 48, "byteStride": 12})";
        document.positions = R"({"componentType": 5126, "count": 4, "type": "VEC3", "sparse": )" + sparse + "}";
        expect_refused(folder.put("a.gltf", document.text()), FLG_ERROR_FORMAT, place, reason);
    };
    const auto parts = [](const char* count, const char* indices, const char* values) {
        return std::string(R"({"count": )") + count + R"(, "indices": )" + indices + R"(, "values": )" + values + "}";
    };
    const char* good = R"({"bufferView": 1, "componentType": 5121})";
    const char* values = R"({"bufferView": 0})";
    refuse("3", "accessors[0].sparse", "no object");
    refuse("{}", "accessors[0].sparse", "has no count");
    refuse(R"({"count": 1})", "accessors[0].sparse", "no object indices");
    refuse(R"({"count": 1, "indices": 7})", "accessors[0].sparse", "no object indices");
    refuse(R"({"count": 1, "indices": {"bufferView": 1, "componentType": 5121}})", "accessors[0].sparse",
           "no object values");
    refuse(parts("0", good, values), "accessors[0].sparse.count", "is 0");
    refuse(parts("5", good, values), "accessors[0].sparse.count", "holds 4 values");
    refuse(parts("3", good, R"({"bufferView": 0, "byteOffset": 24})"), "accessors[0].sparse.count", "holds 2 values");
    refuse(parts("3", good, values), "accessors[0].sparse.indices", "index 3 at 2: must rise");
    refuse(parts("1", R"({"bufferView": 1, "byteOffset": 3, "componentType": 5121})", values),
           "accessors[0].sparse.indices", "index 9 at 0: must rise, and be below 4");
    refuse(parts("1", R"({"bufferView": 1, "componentType": 5120})", values), "accessors[0].sparse.indices",
           "no unsigned integers");
    refuse(parts("1", R"({"bufferView": 1})", values), "accessors[0].sparse.indices", "has no componentType");
    refuse(parts("1", R"({"bufferView": 9, "componentType": 5121})", values), "accessors[0].sparse.indices.bufferView",
           "bufferViews 9 of 3");
    refuse(parts("1", good, R"({"bufferView": 2})"), "bufferViews[2].byteStride", "sparse");
}

TEST(Gltf, RefusesRequiredExtensionsThatKeepVerticesElsewhere) {
    const Folder folder;
    Document document;
    const std::string nodes = document.nodes;
    document.nodes = R"("extensionsRequired": ["KHR_mesh_quantization", "KHR_materials_unlit"],)" + nodes;
    EXPECT_EQ(read(folder.put("a.gltf", document.text())).result, FLG_OK);
    document.nodes = R"("extensionsRequired": ["KHR_mesh_quantization", "KHR_draco_mesh_compression"],)" + nodes;
    expect_refused(folder.put("a.gltf", document.text()), FLG_ERROR_FORMAT, "extensionsRequired[1]",
                   "KHR_draco_mesh_compression");
    document.nodes = R"("extensionsRequired": 1,)" + nodes;
    expect_refused(folder.put("a.gltf", document.text()), FLG_ERROR_FORMAT, "extensionsRequired", "no array");
}

TEST(Gltf, RefusesWhatIsNoGltf) {
    const Folder folder;
    expect_refused(folder.put("a.gltf", "{\"asset\": "), FLG_ERROR_FORMAT, "@11", "no JSON");
    expect_refused(folder.put("a.gltf", "[]"), FLG_ERROR_FORMAT, "asset.version", "missing");
    expect_refused(folder.put("a.gltf", R"({"asset": {"version": "1.0"}})"), FLG_ERROR_FORMAT, "asset.version", "1.0");
    expect_refused(folder.put("a.glb", ""), FLG_ERROR_FORMAT, "@1", "no JSON");
    expect_refused(folder.put("a.gltf", std::string(100000, '[')), FLG_ERROR_LIMIT, "", "deeper than 128");
}

TEST(Gltf, SmallFilesCannotAskForMemoryWithoutEnd) {
    const Folder folder;
    // 67 million one-byte indices of four vertices: 32 bytes of curves for each byte.
    constexpr uint64_t indices = (uint64_t{1} << 26) + 1;
    Document document;
    document.uri = "big.bin";
    document.length = 48 + indices;
    std::filesystem::resize_file(folder.put("big.bin", bytes_of(document.points)), document.length);
    document.primitive = R"({"attributes": {"POSITION": 0}, "indices": 1, "mode": 3})";
    document.accessors =
        R"(, {"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": )" + std::to_string(indices) + "}";
    document.views = R"(, {"buffer": 0, "byteOffset": 48, "byteLength": )" + std::to_string(indices) + "}";
    expect_refused(folder.put("a.gltf", document.text()), FLG_ERROR_LIMIT, "meshes[0].primitives[0]", "2 GiB");

    // Zeros without a bufferView take no bytes at all.
    for (const char* more : {"", R"(, "indices": 1)"}) {
        document = {};
        document.primitive = std::string(R"({"attributes": {"POSITION": 0}, "mode": 3)") + more + "}";
        document.accessors = R"(, {"componentType": 5125, "type": "SCALAR", "count": 2147483648})";
        if (!*more) document.positions = R"({"componentType": 5126, "type": "VEC3", "count": 2147483648})";
        expect_refused(folder.put("a.gltf", document.text()), FLG_ERROR_LIMIT, "meshes[0].primitives[0]", "2 GiB");
    }
}

}  // namespace
}  // namespace flg::test
