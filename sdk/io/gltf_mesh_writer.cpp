// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2 primitives). All primitives share their vertices; 32-bit indices. With
// split regions a primitive holds the triangles of one region, in their order; its material is that of the host's table, or
// without one it is named after the region. Border lines, which glTF has no place for, are `extras` of the material.
#include "io/gltf_mesh_writer.h"

#include <algorithm>
#include <map>

#include "io/gltf_materials.h"
#include "io/vec3.h"

namespace flg::io {

namespace {

Vec3 load(const float* p) {
    return {p[0], p[1], p[2]};
}

// Unit length, as the format asks for: of the column, or where it has none of the triangles around, by area. Vertices
// without any get an axis.
std::vector<float> unit_normals(const CheckedMesh& mesh) {
    std::vector<Vec3> sums(mesh.vertex_count());
    for (size_t i = 0; mesh.normal && i < sums.size(); ++i) sums[i] = load(mesh.normal.at(i));
    for (size_t t = 0; !mesh.normal && t < mesh.triangle_count(); ++t) {
        const uint32_t* v = mesh.triangle(t);
        const Vec3 a = load(mesh.position.at(v[0]));
        const Vec3 n = cross(load(mesh.position.at(v[1])) - a, load(mesh.position.at(v[2])) - a);
        for (uint32_t k = 0; k < 3; ++k) sums[v[k]] = sums[v[k]] + n;
    }
    std::vector<float> normals;
    normals.reserve(3 * sums.size());
    for (const Vec3& sum : sums) {
        const Vec3 n = length(sum) > 0 ? normalized(sum) : Vec3{0, 0, 1};
        for (double value : {n.x, n.y, n.z}) normals.push_back(static_cast<float>(value));
    }
    return normals;
}

std::string material_of(const CheckedMesh& mesh, uint32_t region) {
    if (!mesh.split_regions()) return json_plain_material("surface");
    const std::string default_name = "region " + std::to_string(region);
    if (mesh.materials().empty()) return json_plain_material(default_name);
    return json_material(mesh.materials()[region], default_name);
}

}  // namespace

std::string add_mesh(GlbBuilder& glb, const CheckedMesh& mesh) {
    const size_t count = mesh.vertex_count();
    const std::vector<float> positions = packed(mesh.position, count, 3);
    std::string attributes =
        "\"POSITION\":" + std::to_string(glb.add_positions(glb.add_view(positions, 3), positions, 0, count));
    const size_t normals = glb.add_accessor(glb.add_view(unit_normals(mesh), 3), 0, count, glb_float, "VEC3");
    attributes += ",\"NORMAL\":" + std::to_string(normals);
    if (mesh.color) {
        const size_t view = glb.add_colors(packed(mesh.color, count, 4));
        attributes += ",\"COLOR_0\":" + std::to_string(glb.add_accessor(view, 0, count, glb_float, "VEC4"));
    }

    std::map<uint32_t, std::vector<uint32_t>> indices;  // by region
    for (size_t t = 0; t < mesh.triangle_count(); ++t) {
        std::vector<uint32_t>& list = indices[mesh.split_regions() ? mesh.region(t) : 0];
        list.insert(list.end(), mesh.triangle(t), mesh.triangle(t) + 3);
    }
    std::string materials;
    size_t material_count = 0;
    for (const auto& [region, list] : indices) {
        const size_t accessor = glb.add_accessor(glb.add_view(list), 0, list.size(), glb_unsigned, "SCALAR");
        glb.add_primitive(
            attributes, glb_triangles,
            ",\"indices\":" + std::to_string(accessor) + ",\"material\":" + std::to_string(material_count++));
        if (!materials.empty()) materials += ',';
        materials += material_of(mesh, region);
    }
    return "\"materials\":[" + materials + "],";
}

std::string write_glb_mesh(const CheckedMesh& mesh) {
    GlbBuilder glb;
    const std::string materials = add_mesh(glb, mesh);
    return glb.finish(materials);
}

}  // namespace flg::io
