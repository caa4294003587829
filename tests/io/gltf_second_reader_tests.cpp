// SPDX-License-Identifier: MIT
// What tinygltf, which shares no code with our reader, finds in a document of triangles is what we read: accessors of
// every layout, buffers from everywhere that glTF knows, indices and modes.
#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "io/gltf_files.h"
#include "io/mesh_files.h"

namespace flg::test {
namespace {

using Matrix = std::array<double, 16>;  // column by column

// ---- The second reader: tinygltf parses, loads and decodes; layouts are followed here by the specification's words.

template <class T>
double number_at(const unsigned char* at, bool normalized) {
    T value;
    std::memcpy(&value, at, sizeof value);
    if (!normalized) return static_cast<double>(value);
    return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double number_at(const unsigned char* at, int component_type, bool normalized) {
    switch (component_type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: return number_at<int8_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: return number_at<uint8_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT: return number_at<int16_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: return number_at<uint16_t>(at, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT: return number_at<uint32_t>(at, normalized);
        default: return number_at<float>(at, false);
    }
}

const unsigned char* bytes_at(const tinygltf::Model& model, int view, size_t offset) {
    const tinygltf::BufferView& at = model.bufferViews.at(static_cast<size_t>(view));
    return model.buffers.at(static_cast<size_t>(at.buffer)).data.data() + at.byteOffset + offset;
}

std::vector<double> values_of(const tinygltf::Model& model, int index) {
    const tinygltf::Accessor& accessor = model.accessors.at(static_cast<size_t>(index));
    const auto components = static_cast<size_t>(tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type)));
    const auto size = [](int type) {
        return static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(type)));
    };
    std::vector<double> values(accessor.count * components);
    const auto load = [&](const unsigned char* from, size_t element) {
        for (size_t k = 0; k < components; ++k)
            values[element * components + k] =
                number_at(from + k * size(accessor.componentType), accessor.componentType, accessor.normalized);
    };
    if (accessor.bufferView >= 0) {
        const auto stride =
            static_cast<size_t>(accessor.ByteStride(model.bufferViews.at(static_cast<size_t>(accessor.bufferView))));
        const unsigned char* from = bytes_at(model, accessor.bufferView, accessor.byteOffset);
        for (size_t i = 0; i < accessor.count; ++i) load(from + i * stride, i);
    }
    const auto& sparse = accessor.sparse;
    for (size_t i = 0; sparse.isSparse && i < static_cast<size_t>(sparse.count); ++i) {
        const unsigned char* at =
            bytes_at(model, sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset)) +
            i * size(sparse.indices.componentType);
        load(bytes_at(model, sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset)) +
                 i * components * size(accessor.componentType),
             static_cast<size_t>(number_at(at, sparse.indices.componentType, false)));
    }
    return values;
}

Matrix product(const Matrix& a, const Matrix& b) {
    Matrix c = {};
    for (size_t column = 0; column < 4; ++column) {
        for (size_t row = 0; row < 4; ++row) {
            for (size_t k = 0; k < 4; ++k) c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
        }
    }
    return c;
}

Matrix matrix_of(const tinygltf::Node& node) {
    Matrix m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    if (!node.matrix.empty()) {
        std::copy(node.matrix.begin(), node.matrix.end(), m.begin());
        return m;
    }
    if (!node.translation.empty()) std::copy(node.translation.begin(), node.translation.end(), m.begin() + 12);
    if (!node.rotation.empty()) {
        const double x = node.rotation[0], y = node.rotation[1], z = node.rotation[2], w = node.rotation[3];
        const Matrix turn = {1 - 2 * (y * y + z * z),
                             2 * (x * y + z * w),
                             2 * (x * z - y * w),
                             0,
                             2 * (x * y - z * w),
                             1 - 2 * (x * x + z * z),
                             2 * (y * z + x * w),
                             0,
                             2 * (x * z + y * w),
                             2 * (y * z - x * w),
                             1 - 2 * (x * x + y * y),
                             0,
                             0,
                             0,
                             0,
                             1};
        m = product(m, turn);
    }
    for (size_t k = 0; k < node.scale.size(); ++k) {
        for (size_t row = 0; row < 4; ++row) m[4 * k + row] *= node.scale[k];
    }
    return m;
}

struct Corners {
    std::vector<double> positions;  // three a corner, three corners a triangle
    std::vector<double> colors;     // four a corner
};

void add_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive, const Matrix& m, Corners& to) {
    const std::vector<double> positions = values_of(model, primitive.attributes.at("POSITION"));
    const auto color = primitive.attributes.find("COLOR_0");
    std::vector<double> colors(positions.size() / 3 * 4, 1.0);
    if (color != primitive.attributes.end()) {
        const std::vector<double> found = values_of(model, color->second);
        const size_t components = found.size() * 3 / positions.size();
        for (size_t i = 0; i < found.size(); ++i) colors[i / components * 4 + i % components] = found[i];
    }
    std::vector<size_t> indices;
    if (primitive.indices >= 0) {
        for (double index : values_of(model, primitive.indices)) indices.push_back(static_cast<size_t>(index));
    } else {
        for (size_t i = 0; i < positions.size() / 3; ++i) indices.push_back(i);
    }
    const auto corner = [&](size_t index) {
        for (size_t row = 0; row < 3; ++row) {
            double value = m[12 + row];
            for (size_t k = 0; k < 3; ++k) value += m[4 * k + row] * positions[3 * index + k];
            to.positions.push_back(value);
        }
        to.colors.insert(to.colors.end(), &colors[4 * index], &colors[4 * index] + 4);
    };
    const double det =
        m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
    const auto triangle = [&](size_t a, size_t b, size_t c) {
        corner(indices[a]);
        corner(indices[det < 0 ? c : b]);
        corner(indices[det < 0 ? b : c]);
    };
    // The specification's formulas (3.7.2.1), in an order of corners that begins at p[i] as ours does.
    if (primitive.mode == TINYGLTF_MODE_TRIANGLES) {
        for (size_t i = 0; i + 2 < indices.size(); i += 3) triangle(i, i + 1, i + 2);
    } else {
        ASSERT_TRUE(primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP || primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN);
        for (size_t i = 0; i + 2 < indices.size(); ++i) {
            if (primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN) {
                triangle(0, i + 1, i + 2);
            } else {
                triangle(i % 2 ? i + 1 : i, i % 2 ? i : i + 1, i + 2);
            }
        }
    }
}

void add_node(const tinygltf::Model& model, int index, const Matrix& parent, Corners& to) {
    const tinygltf::Node& node = model.nodes.at(static_cast<size_t>(index));
    const Matrix m = product(parent, matrix_of(node));
    if (node.mesh >= 0) {
        for (const tinygltf::Primitive& primitive : model.meshes.at(static_cast<size_t>(node.mesh)).primitives)
            add_primitive(model, primitive, m, to);
    }
    for (int child : node.children) add_node(model, child, m, to);
}

Corners second_reading(const std::string& path) {
    tinygltf::TinyGLTF loader;
    tinygltf::Model model;
    std::string error, warning;
    const bool loaded = path.ends_with(".glb") ? loader.LoadBinaryFromFile(&model, &error, &warning, path)
                                               : loader.LoadASCIIFromFile(&model, &error, &warning, path);
    EXPECT_TRUE(loaded) << error;
    EXPECT_EQ(error, "");
    Corners corners;
    if (!loaded) return corners;
    const int scene = std::max(model.defaultScene, 0);
    for (int root : model.scenes.at(static_cast<size_t>(scene)).nodes)
        add_node(model, root, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, corners);
    return corners;
}

// ---- Ours, corner by corner.

void expect_read_alike(const std::string& path, size_t triangles) {
    SCOPED_TRACE(path);
    const Corners second = second_reading(path);
    EXPECT_EQ(second.positions.size(), 9 * triangles) << "the document does not hold what it is meant to";
    ReadMesh mesh = read_mesh(path);
    ASSERT_EQ(mesh.result, FLG_OK) << mesh.error;
    ASSERT_EQ(3 * mesh.triangles.size(), second.positions.size());
    for (size_t i = 0; i < second.positions.size(); ++i) {
        const float ours = mesh.positions()[3 * mesh.triangles[i / 3] + i % 3];
        EXPECT_NEAR(ours, second.positions[i], 1e-6 * std::max(1.0, std::abs(second.positions[i])))
            << "corner " << i / 3;
    }
    if (mesh.colors().empty()) {
        EXPECT_EQ(second.colors, std::vector<double>(second.colors.size(), 1.0));
        return;
    }
    for (size_t i = 0; i < second.colors.size(); ++i)
        EXPECT_NEAR(mesh.colors()[4 * mesh.triangles[i / 4] + i % 4], second.colors[i], 1e-6) << "corner " << i / 4;
}

// ---- Documents whose accessors and buffers are spelled out.

struct Parts {
    std::string primitives = R"({"attributes": {"POSITION": 0}})";
    std::string accessors, views, buffers, nodes = R"({"mesh": 0})", top;

    std::string text() const {
        return R"({"asset": {"version": "2.0"}, )" + top + R"("scene": 0, "scenes": [{"nodes": [0]}], "nodes": [)" +
               nodes + R"(], "meshes": [{"primitives": [)" + primitives + R"(]}], "accessors": [)" + accessors +
               R"(], "bufferViews": [)" + views + R"(], "buffers": [)" + buffers + "]}";
    }
};

std::string embedded(const std::string& bytes, const std::string& kind = "application/octet-stream") {
    return R"({"byteLength": )" + std::to_string(bytes.size()) + R"(, "uri": "data:)" + kind + ";base64," +
           base64(bytes) + "\"}";
}

const Floats square = {0, 0, 0, 1, 0, 0, 1, 1, 0.5f, 0, 1, 0.25f};

TEST(GltfSecondReader, SparseAccessors) {
    const Folder folder;
    for (const auto& [type, indices] :
         {std::pair(5121, std::string("\1\3\0\0", 4)), std::pair(5123, bytes_of(std::vector<uint16_t>{1, 3})),
          std::pair(5125, bytes_of(std::vector<uint32_t>{1, 3}))}) {
        for (const bool dense : {true, false}) {
            const std::string bytes = bytes_of(square) + bytes_of(Floats{7, 8, 9, -1, -2, -3}) + indices;
            Parts parts;
            parts.buffers = embedded(bytes);
            parts.views = R"({"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 24},
                {"buffer": 0, "byteOffset": 72, "byteLength": )" +
                          std::to_string(indices.size()) + "}";
            parts.accessors = std::string("{") + (dense ? R"("bufferView": 0, )" : "") +
                              R"("componentType": 5126, "count": 4, "type": "VEC3", "sparse": {"count": 2,
                              "indices": {"bufferView": 2, "componentType": )" +
                              std::to_string(type) + R"(}, "values": {"bufferView": 1}}})";
            parts.primitives = R"({"attributes": {"POSITION": 0}, "mode": 6})";
            expect_read_alike(folder.put("sparse.gltf", parts.text()), 2);
        }
    }
}

TEST(GltfSecondReader, SparseIndicesAndColours) {
    const Folder folder;
    // Indices 0 1 2, then 0 2 3 over zeros; colours white but for vertex 2; values at an offset in their view.
    const std::string bytes = bytes_of(square) + bytes_of(std::vector<uint16_t>{0, 1, 2, 0, 0, 0, 2, 3, 4, 5}) +
                              bytes_of(std::vector<uint32_t>{2}) + std::string("\xff\x80\x00\xff", 4);
    Parts parts;
    parts.buffers = embedded(bytes);
    parts.views = R"({"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 20},
                     {"buffer": 0, "byteOffset": 68, "byteLength": 8})";
    parts.accessors = R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR", "sparse": {"count": 2,
         "indices": {"bufferView": 1, "byteOffset": 16, "componentType": 5123},
         "values": {"bufferView": 1, "byteOffset": 12}}},
        {"componentType": 5121, "count": 4, "type": "VEC4", "normalized": true, "sparse": {"count": 1,
         "indices": {"bufferView": 2, "componentType": 5125}, "values": {"bufferView": 2, "byteOffset": 4}}})";
    parts.primitives = R"({"attributes": {"POSITION": 0, "COLOR_0": 2}, "indices": 1})";
    expect_read_alike(folder.put("a.gltf", parts.text()), 2);
}

TEST(GltfSecondReader, AccessorsWithoutDataAreZeros) {
    const Folder folder;
    Parts parts;
    parts.buffers = embedded(bytes_of(square));
    parts.views = R"({"buffer": 0, "byteLength": 48})";
    parts.accessors = R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
                         {"componentType": 5126, "count": 4, "type": "VEC3"})";
    parts.primitives = R"({"attributes": {"POSITION": 0, "COLOR_0": 1}, "mode": 5})";
    expect_read_alike(folder.put("a.gltf", parts.text()), 2);
}

TEST(GltfSecondReader, QuantizedPositions) {
    const Folder folder;
    struct Kind {
        int type;
        bool normalized;
        std::string bytes;  // of four vertices, 8 bytes each
    };
    const auto strided = [](const auto& values) {
        std::string bytes;
        using Number = typename std::decay_t<decltype(values)>::value_type;
        for (size_t v = 0; v < 4; ++v) {
            bytes.append(reinterpret_cast<const char*>(&values[3 * v]), 3 * sizeof(Number));
            bytes.resize(8 * (v + 1), '\x55');
        }
        return bytes;
    };
    const std::string bytes8 = strided(std::vector<int8_t>{-128, 0, 3, 127, -5, 0, 127, 100, 9, 0, 64, -127});
    const std::string bytes16 = strided(std::vector<int16_t>{-32768, 0, 3, 32767, -5, 0, 300, 100, 9, 0, 64, -32767});
    for (const Kind& kind : {Kind{5120, true, bytes8}, Kind{5120, false, bytes8}, Kind{5121, true, bytes8},
                             Kind{5121, false, bytes8}, Kind{5122, true, bytes16}, Kind{5122, false, bytes16},
                             Kind{5123, true, bytes16}, Kind{5123, false, bytes16}}) {
        Parts parts;
        parts.top = R"("extensionsUsed": ["KHR_mesh_quantization"], "extensionsRequired": ["KHR_mesh_quantization"], )";
        parts.nodes =
            R"({"mesh": 0, "translation": [1, -2, 3], "scale": [0.5, 0.25, 2], "rotation": [0, 0.6, 0, 0.8]})";
        parts.buffers = embedded(kind.bytes);
        parts.views = R"({"buffer": 0, "byteLength": 32, "byteStride": 8})";
        parts.accessors = R"({"bufferView": 0, "componentType": )" + std::to_string(kind.type) + R"(, "normalized": )" +
                          (kind.normalized ? "true" : "false") + R"(, "count": 4, "type": "VEC3"})";
        parts.primitives = R"({"attributes": {"POSITION": 0}, "mode": 5})";
        expect_read_alike(folder.put("a.gltf", parts.text()), 2);
    }
}

TEST(GltfSecondReader, Layouts) {
    const Folder folder;
    // Positions and 16-bit colours interleaved, 20 bytes a vertex after 4 bytes of something else.
    std::string bytes = "----";
    for (size_t v = 0; v < 4; ++v) {
        bytes += bytes_of(Floats(square.begin() + static_cast<std::ptrdiff_t>(3 * v),
                                 square.begin() + static_cast<std::ptrdiff_t>(3 * v + 3)));
        bytes += bytes_of(std::vector<uint16_t>{static_cast<uint16_t>(10000 * v), 65535, 0, 7});
    }
    Parts parts;
    parts.buffers = embedded(bytes);
    parts.views = R"({"buffer": 0, "byteOffset": 4, "byteLength": 80, "byteStride": 20})";
    parts.accessors = R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 0, "byteOffset": 12, "componentType": 5123, "normalized": true, "count": 4, "type": "VEC4"})";
    parts.primitives = R"({"attributes": {"POSITION": 0, "COLOR_0": 1}, "mode": 5},
                          {"attributes": {"POSITION": 0, "COLOR_0": 1}, "mode": 6})";
    expect_read_alike(folder.put("interleaved.gltf", parts.text()), 4);

    // A stride of 0, as some exporters write for values without gaps.
    parts.buffers = embedded(bytes_of(square));
    parts.views = R"({"buffer": 0, "byteLength": 48, "byteStride": 0})";
    parts.accessors = R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "byteOffset": 12})";
    parts.primitives = R"({"attributes": {"POSITION": 0}})";
    expect_read_alike(folder.put("stride.gltf", parts.text()), 1);

    // Indices of all widths, and none.
    bytes = bytes_of(square) + std::string("\0\1\2\0\2\3\0\0", 8) + bytes_of(std::vector<uint16_t>{3, 2, 1, 1, 0, 3}) +
            bytes_of(std::vector<uint32_t>{0, 1, 2, 3});
    parts.buffers = embedded(bytes);
    parts.views = R"({"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 6},
        {"buffer": 0, "byteOffset": 56, "byteLength": 12}, {"buffer": 0, "byteOffset": 68, "byteLength": 16})";
    parts.accessors = R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
        {"bufferView": 1, "componentType": 5121, "count": 6, "type": "SCALAR"},
        {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"},
        {"bufferView": 3, "componentType": 5125, "count": 4, "type": "SCALAR"})";
    parts.primitives = R"({"attributes": {"POSITION": 0}, "indices": 1}, {"attributes": {"POSITION": 0}, "indices": 2},
        {"attributes": {"POSITION": 0}, "indices": 3, "mode": 5},
        {"attributes": {"POSITION": 0}, "indices": 3, "mode": 6}, {"attributes": {"POSITION": 0}, "mode": 5})";
    parts.nodes = R"({"mesh": 0, "matrix": [0, 2, 0, 0, 2, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1], "children": [1]},
                     {"mesh": 0, "scale": [1, 1, -1]})";
    expect_read_alike(folder.put("indices.gltf", parts.text()), 20);
}

TEST(GltfSecondReader, Buffers) {
    const Folder folder;
    const std::string bytes = bytes_of(square);
    Parts parts;
    parts.views = R"({"buffer": 0, "byteLength": 48})";
    parts.accessors = R"({"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"})";
    parts.primitives = R"({"attributes": {"POSITION": 0}, "mode": 5})";
    for (const char* kind : {"application/octet-stream", "application/gltf-buffer"}) {
        parts.buffers = embedded(bytes, kind);
        expect_read_alike(folder.put("data.gltf", parts.text()), 2);
    }
    parts.buffers = R"({"byteLength": 48, "uri": "a%20folder/points.bin"})";
    folder.put("a folder/points.bin", bytes);
    expect_read_alike(folder.put("beside.gltf", parts.text()), 2);
    // With a byte order mark before the text.
    expect_read_alike(folder.put("mark.gltf", "\xef\xbb\xbf" + parts.text()), 2);

    // .glb: the first buffer in the binary chunk, which is padded, another embedded; a chunk of an unknown kind last.
    const auto chunk = [](const char* kind, std::string content, char padding) {
        content.resize((content.size() + 3) / 4 * 4, padding);
        return bytes_of(std::vector<uint32_t>{static_cast<uint32_t>(content.size())}) + std::string(kind, 4) + content;
    };
    parts.buffers = R"({"byteLength": 48}, )" + embedded(bytes_of(Floats{1, 0.5f, 0, 0, 1, 1, 1, 0, 0, 0, 0, 1}));
    parts.views += R"(, {"buffer": 1, "byteLength": 48})";
    parts.accessors += R"(, {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"})";
    parts.primitives = R"({"attributes": {"POSITION": 0, "COLOR_0": 1}, "mode": 5})";
    for (const std::string& more : {std::string(), chunk("MORE", "what is this", ' ')}) {
        const std::string chunks = chunk("JSON", parts.text(), ' ') + chunk("BIN\0", bytes + "pad", '\0') + more;
        const std::vector<uint32_t> header = {0x46546c67, 2, static_cast<uint32_t>(12 + chunks.size())};
        expect_read_alike(folder.put("a.glb", bytes_of(header) + chunks), 2);
    }
}

}  // namespace
}  // namespace flg::test
