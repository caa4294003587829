// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2 primitives, and 3.7.4 for transforms that mirror).
// Each triangle primitive of each mesh that a node of the scene shows, placed. Primitives that follow each other and share
// their accessors of vertices share the vertices. Strips and fans lose the triangles that name a vertex twice: those
// only lead on.
#include "io/gltf_mesh_reader.h"

#include <algorithm>
#include <map>

#include "io/gltf_materials.h"
#include "io/gltf_scene.h"
#include "io/gltf_triangles.h"

namespace flg::io {

namespace {

constexpr uint64_t no_material = UINT64_MAX;

class GltfMeshReader {
public:
    explicit GltfMeshReader(const std::filesystem::path& path) : document_(path) {}

    MeshData read() {
        data_.format = "gltf";
        visit_primitives(document_, [this](const GltfPrimitive& primitive) { read_primitive(primitive); });
        if (data_.triangles.empty()) fail(FLG_ERROR_FORMAT, "meshes", "the file shows no triangles");
        if (!colors_.empty()) {
            colors_.resize(4 * data_.vertex_count(), 1.0f);
            data_.columns.push_back({FLG_ATTRIBUTE_COLOR, 4, std::move(colors_)});
        }
        if (regions_.size() == 1) data_.regions.clear();
        if (!says_color_) data_.materials.clear();
        data_.warn(others_, "primitive", "of points or lines, left out: only triangles are read");
        data_.warn(open_, "primitive", "of triangles that are not complete, the rest left out");
        return std::move(data_);
    }

private:
    // The vertices of one primitive, as the next may share them.
    struct SharedVertices {
        uint64_t placement, positions, colors;
        bool operator==(const SharedVertices&) const = default;
    };

    void read_primitive(const GltfPrimitive& primitive) {
        if (primitive.mode < gltf_triangles) {
            others_.add(primitive.index);
            return;
        }
        const GltfVertices vertices = read_vertices(document_, primitive);
        const uint64_t vertex_count = vertices.positions.count;
        const std::optional<GltfValues> values = read_index_values(document_, primitive);
        const Json& attributes = primitive.json["attributes"];
        const SharedVertices shared = {primitive.placement, attributes["POSITION"].get<uint64_t>(),
                                       vertices.colors ? attributes["COLOR_0"].get<uint64_t>() : no_material};
        const bool is_new = data_.positions.empty() || !(shared == shared_);
        const uint64_t corner_count = values ? values->count : vertex_count;
        data_.check_room(is_new ? vertex_count : 0, primitive.mode == gltf_triangles ? corner_count / 3 : corner_count,
                         primitive.place);
        const std::vector<uint32_t> indices = read_indices(values, vertex_count);
        if (is_new) append_vertices(vertices, primitive.transform);
        shared_ = shared;
        append_triangles(primitive, indices);

        const uint64_t material = gltf_unsigned(primitive.json, "material", no_material, primitive.place);
        const uint32_t next = static_cast<uint32_t>(regions_.size());
        if (data_.regions.size() < data_.triangle_count()) {
            const auto [found, is_first] = regions_.try_emplace(material, next);
            data_.regions.resize(data_.triangle_count(), found->second);
            if (!is_first) return;
            GltfMaterial look = read_material(document_, material, primitive.place + ".material");
            says_color_ |= look.says_color;
            data_.materials.push_back(std::move(look.data));
        }
    }

    void append_vertices(const GltfVertices& vertices, const Transform& transform) {
        first_vertex_ = static_cast<uint32_t>(data_.vertex_count());
        const uint32_t count = static_cast<uint32_t>(vertices.positions.count);
        data_.positions.resize(3 * (size_t{first_vertex_} + count));
        float* to = &data_.positions[3 * size_t{first_vertex_}];
        for (uint32_t i = 0; i < count; ++i, to += 3) {
            const std::array<float, 3> position = vertices.position(i, transform);
            std::copy(position.begin(), position.end(), to);
        }
        if (!vertices.colors) return;
        // White, where primitives before this one have no colours.
        colors_.resize(4 * size_t{first_vertex_}, 1.0f);
        for (uint32_t i = 0; i < count; ++i) {
            for (float value : vertices.color(i)) colors_.push_back(value);
        }
    }

    void append_triangles(const GltfPrimitive& primitive, const std::vector<uint32_t>& indices) {
        const bool mirrored = determinant(primitive.transform) < 0;
        const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
            data_.add_triangle(first_vertex_ + a, first_vertex_ + (mirrored ? c : b),
                               first_vertex_ + (mirrored ? b : c));
        };
        if (primitive.mode == gltf_triangles && indices.size() % 3 != 0) open_.add(primitive.index);
        visit_triangles(primitive.mode, indices, add);
    }

    GltfDocument document_;
    MeshData data_;
    std::vector<float> colors_;  // of the vertices up to the last that has one
    SharedVertices shared_ = {};
    uint32_t first_vertex_ = 0;
    std::map<uint64_t, uint32_t> regions_;  // of materials
    bool says_color_ = false;               // at least one of them
    Tally others_, open_;
};

}  // namespace

MeshData read_gltf_mesh(const std::filesystem::path& path) {
    return GltfMeshReader(path).read();
}

}  // namespace flg::io
