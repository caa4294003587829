// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2 primitives, and 3.7.4 for transforms that mirror).
//
// Read: each triangle primitive of each mesh that a node of the scene shows, placed. Primitives that follow each other
// and share their accessors of vertices share the vertices. Strips and fans lose the triangles that name a vertex
// twice: those only lead on.
//
// Written: all primitives share their vertices; 32-bit indices. With
// split regions a primitive holds the triangles of one region, in their order; its material is that of the host's
// table, or without one it is named after the region. Border lines, which glTF has no place for, are `extras` of the
// material.
#include "io/gltf/gltf_mesh.h"

#include <algorithm>
#include <utility>

#include "io/base/vec3.h"
#include "io/gltf/gltf_materials.h"
#include "io/gltf/gltf_normals.h"
#include "io/gltf/gltf_scene.h"
#include "io/gltf/gltf_textures.h"
#include "io/gltf/gltf_triangles.h"

namespace flg::io {

namespace {

constexpr uint64_t no_material = UINT64_MAX;

class GltfMeshReader {
public:
    GltfMeshReader(const Path& path, const Origin& origin) : document_(path), origin_(origin), textures_(document_) {}

    MeshData read() {
        data_.format = "gltf";
        visit_primitives(document_, origin_, [this](const GltfPrimitive& primitive) { read_primitive(primitive); });
        if (data_.triangles.empty()) fail(FLG_ERROR_FORMAT, "meshes", "the file shows no triangles");
        if (!colors_.empty()) {
            colors_.resize(4 * data_.vertex_count(), 1.0f);
            data_.columns.push_back({FLG_ATTRIBUTE_COLOR, 4, std::move(colors_)});
        }
        if (all_have_normals_) data_.columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, std::move(normals_)});
        if (!data_.corner_uvs.empty()) data_.corner_uvs.resize(6 * data_.triangle_count());
        if (regions_.size() == 1) data_.regions.clear();
        if (!says_color_) data_.materials.clear();
        data_.textures = textures_.take(data_.warnings);
        lost_.warn(data_.warnings);
        data_.warn(shapes_, "primitive", "with morph targets, left out");
        data_.warn(columns_, "primitive",
                   "with attributes besides positions, normals, colours and texture coordinates, left out");
        data_.warn(others_, "primitive", "of points or lines, left out: only triangles are read");
        data_.warn(open_, "primitive", "of triangles that are not complete, the rest left out");
        return std::move(data_);
    }

private:
    // The vertices of one primitive, as the next may share them.
    struct SharedVertices {
        uint64_t placement, positions, colors, normals;
        bool operator==(const SharedVertices&) const = default;
    };

    // Names what a primitive has and is not read. Joints and weights are for those who read skins, and so are shapes of
    // what has joints.
    void note_lost(const GltfPrimitive& primitive, const Json& attributes, const GltfTextureUse& use) {
        const Json* const targets = primitive.json.find("targets");
        if (targets && targets->size() != 0 && !attributes.find("JOINTS_0")) shapes_.add(primitive.index);
        const String seen = "TEXCOORD_" + to_text(use.set);
        for (const JsonMember& attribute : attributes.members()) {
            if (attribute.name == "POSITION" || attribute.name == "NORMAL" || attribute.name == "COLOR_0" ||
                attribute.name == seen || attribute.name.starts_with("JOINTS_") ||
                attribute.name.starts_with("WEIGHTS_") || attribute.name == "_PART")
                continue;
            columns_.add(primitive.index);
            return;
        }
    }

    void read_primitive(const GltfPrimitive& primitive) {
        if (primitive.mode < gltf_triangles) {
            others_.add(primitive.index);
            return;
        }
        const GltfVertices vertices = read_vertices(document_, primitive);
        const uint64_t vertex_count = vertices.positions.count;
        const std::optional<GltfValues> values = read_index_values(document_, primitive);
        const Json& attributes = *primitive.json.find("attributes");
        const std::optional<GltfNormals> normals = GltfNormals::read(document_, primitive, vertex_count);
        const SharedVertices shared = {primitive.placement, attributes.find("POSITION")->count(),
                                       vertices.colors ? attributes.find("COLOR_0")->count() : no_material,
                                       normals ? attributes.find("NORMAL")->count() : no_material};
        const bool is_new = data_.positions.empty() || !(shared == shared_);
        const uint64_t corner_count = values ? values->count : vertex_count;
        data_.check_room(is_new ? vertex_count : 0, primitive.mode == gltf_triangles ? corner_count / 3 : corner_count,
                         primitive.place);
        const Vector<uint32_t> indices = read_indices(values, vertex_count);
        if (is_new) append_vertices(vertices, normals, primitive);
        shared_ = shared;
        const uint64_t material = gltf_unsigned(primitive.json, "material", no_material, primitive.place);
        const GltfTextureUse use = textures_.of_material(material);
        note_lost(primitive, attributes, use);
        append_triangles(primitive, indices, GltfUvs::read(document_, primitive, use, vertex_count));

        const uint32_t next = static_cast<uint32_t>(regions_.size());
        if (data_.regions.size() < data_.triangle_count()) {
            const auto [found, is_first] = regions_.try_emplace(material, next);
            data_.regions.resize(data_.triangle_count(), found->second);
            if (!is_first) return;
            GltfMaterial look = read_material(document_, material, primitive.place + ".material");
            look.data.texture = use.texture;
            says_color_ |= look.says_color || use.texture != FLG_NO_INDEX;
            lost_.add(document_, material);
            data_.materials.push_back(std::move(look.data));
        }
    }

    void append_vertices(const GltfVertices& vertices, const std::optional<GltfNormals>& normals,
                         const GltfPrimitive& primitive) {
        const Transform& transform = primitive.transform;
        if (!data_.placing.stored) data_.placing.stored = place_of(primitive);
        first_vertex_ = static_cast<uint32_t>(data_.vertex_count());
        const uint32_t count = static_cast<uint32_t>(vertices.positions.count);
        data_.positions.resize(3 * (size_t{first_vertex_} + count));
        float* to = &data_.positions[3 * size_t{first_vertex_}];
        for (uint32_t i = 0; i < count; ++i, to += 3) {
            const std::array<float, 3> position = vertices.position(i, transform);
            std::copy(position.begin(), position.end(), to);
        }
        all_have_normals_ = all_have_normals_ && normals;
        for (uint32_t i = 0; all_have_normals_ && i < count; ++i) {
            const std::array<float, 3> normal = normals->at(i, transform);
            normals_.insert(normals_.end(), normal.begin(), normal.end());
        }
        if (!vertices.colors) return;
        // White, where primitives before this one have no colours.
        colors_.resize(4 * size_t{first_vertex_}, 1.0f);
        for (uint32_t i = 0; i < count; ++i) {
            for (float value : vertices.color(i)) colors_.push_back(value);
        }
    }

    void append_triangles(const GltfPrimitive& primitive, const Vector<uint32_t>& indices,
                          const std::optional<GltfUvs>& uvs) {
        const bool mirrored = determinant(primitive.transform) < 0;
        if (uvs) data_.corner_uvs.resize(6 * data_.triangle_count());
        const auto add = [&](uint32_t a, uint32_t b, uint32_t c) {
            if (mirrored) std::swap(b, c);
            data_.add_triangle(first_vertex_ + a, first_vertex_ + b, first_vertex_ + c);
            for (const uint32_t vertex : {a, b, c}) {
                if (!uvs) break;
                const std::array<float, 2> uv = uvs->at(vertex);
                data_.corner_uvs.insert(data_.corner_uvs.end(), uv.begin(), uv.end());
            }
        };
        if (primitive.mode == gltf_triangles && indices.size() % 3 != 0) open_.add(primitive.index);
        visit_triangles(primitive.mode, indices, add);
    }

    GltfDocument document_;
    const Origin origin_;
    MeshData data_;
    GltfTextures textures_;
    LostLooks lost_;
    Vector<float> colors_;  // of the vertices up to the last that has one
    Vector<float> normals_;
    bool all_have_normals_ = true;
    SharedVertices shared_ = {};
    uint32_t first_vertex_ = 0;
    Map<uint64_t, uint32_t> regions_;  // of materials
    bool says_color_ = false;          // at least one of them
    Tally others_, open_, shapes_, columns_;
};

}  // namespace

MeshData read_gltf_mesh(const Path& path, const Origin& origin) {
    return GltfMeshReader(path, origin).read();
}

namespace {

Vec3 load(const float* p) {
    return {p[0], p[1], p[2]};
}

// Unit length, as the format asks for: of the column, or where it has none of the triangles around, by area. Vertices
// without any get an axis.
Vector<float> unit_normals(const CheckedMesh& mesh) {
    Vector<Vec3> sums(mesh.vertex_count());
    for (size_t i = 0; mesh.normal && i < sums.size(); ++i) sums[i] = load(mesh.normal.at(i));
    for (size_t t = 0; !mesh.normal && t < mesh.triangle_count(); ++t) {
        const uint32_t* v = mesh.triangle(t);
        const Vec3 a = load(mesh.position.at(v[0]));
        const Vec3 n = cross(load(mesh.position.at(v[1])) - a, load(mesh.position.at(v[2])) - a);
        for (uint32_t k = 0; k < 3; ++k) sums[v[k]] = sums[v[k]] + n;
    }
    Vector<float> normals;
    normals.reserve(3 * sums.size());
    for (const Vec3& sum : sums) {
        const Vec3 n = length(sum) > 0 ? normalized(sum) : Vec3{0, 0, 1};
        for (double value : {n.x, n.y, n.z}) normals.push_back(static_cast<float>(value));
    }
    return normals;
}

String material_of(const CheckedMesh& mesh, uint32_t region) {
    if (!mesh.split_regions()) return json_plain_material("surface");
    const String default_name = "region " + to_text(region);
    if (mesh.materials().empty()) return json_plain_material(default_name);
    return json_material(mesh.materials()[region], default_name);
}

}  // namespace

String add_mesh(GlbBuilder& glb, const CheckedMesh& mesh) {
    const size_t count = mesh.vertex_count();
    const Vector<float> positions = packed(mesh.position, count, 3);
    String attributes = "\"POSITION\":" + to_text(glb.add_positions(glb.add_view(positions, 3), positions, 0, count));
    const size_t normals = glb.add_accessor(glb.add_view(unit_normals(mesh), 3), 0, count, glb_float, "VEC3");
    attributes += ",\"NORMAL\":" + to_text(normals);
    if (mesh.color) {
        const size_t view = glb.add_colors(packed(mesh.color, count, 4));
        attributes += ",\"COLOR_0\":" + to_text(glb.add_accessor(view, 0, count, glb_float, "VEC4"));
    }
    if (mesh.uv) {
        const size_t view = glb.add_view(packed(mesh.uv, count, 2), 2);
        attributes += ",\"TEXCOORD_0\":" + to_text(glb.add_accessor(view, 0, count, glb_float, "VEC2"));
    }

    Map<uint32_t, Vector<uint32_t>> indices;  // by region
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        Vector<uint32_t>& list = indices[mesh.split_regions() ? mesh.region(t) : 0];
        list.insert(list.end(), mesh.triangle(t), mesh.triangle(t) + 3);
    }
    String materials;
    size_t material_count = 0;
    for (const auto& [region, list] : indices) {
        const size_t accessor = glb.add_accessor(glb.add_view(list), 0, list.size(), glb_unsigned, "SCALAR");
        glb.add_primitive(attributes, glb_triangles,
                          ",\"indices\":" + to_text(accessor) + ",\"material\":" + to_text(material_count++));
        if (!materials.empty()) materials += ',';
        materials += material_of(mesh, region);
    }
    return "\"materials\":[" + materials + "],";
}

String write_glb_mesh(const CheckedMesh& mesh) {
    GlbBuilder glb;
    const String materials = add_mesh(glb, mesh);
    return glb.finish(materials, mesh.origin());
}

}  // namespace flg::io
