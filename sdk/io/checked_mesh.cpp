// SPDX-License-Identifier: MIT
#include "io/checked_mesh.h"

#include <algorithm>
#include <cstring>
#include <string_view>

#include "io/entry_point.h"
#include "io/json_text.h"
#include "io/mesh_data.h"

namespace flg::io {

FlgMeshWriteDesc mesh_write_defaults() {
    FlgMeshWriteDesc desc = {};
    desc.struct_size = sizeof desc;
    return desc;
}

void check_material(const FlgMeshMaterial& material, const std::string& place) {
    constexpr size_t longest_name = 255;
    constexpr float widest_border_px = 64;
    const auto check_in = [&](float value, float most, const char* member) {
        if (value >= 0 && value <= most) return;
        fail(FLG_ERROR_INVALID_ARGUMENT, place + member, "is %g, must be from 0 to %g", double{value}, double{most});
    };
    if (material.name && (strnlen(material.name, longest_name + 1) > longest_name || !is_utf8(material.name))) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + "name", "must be UTF-8 of at most 255 bytes");
    }
    for (const float value : material.color) check_in(value, 1, "color");
    check_in(material.metallic, 1, "metallic");
    check_in(material.roughness, 1, "roughness");
    for (const float value : material.border_color) check_in(value, 1, "border_color");
    check_in(material.border_width_px, widest_border_px, "border_width_px");
}

CheckedMesh::CheckedMesh(const FlgMeshView* view, const FlgMeshWriteDesc* desc) {
    check_argument(view, "view");
    check_size<FlgMeshView>(view->struct_size, "view");
    std::memcpy(&view_, view, sizeof view_);
    if (desc) {
        check_size<FlgMeshWriteDesc>(desc->struct_size, "desc");
        std::memcpy(&desc_, desc, sizeof desc_);
    }
    const CheckedColumns columns(view_.columns, view_.column_count, view_.vertex_count);
    position = columns.find(FLG_ATTRIBUTE_POSITION);
    color = columns.find(FLG_ATTRIBUTE_COLOR);
    normal = columns.find(FLG_ATTRIBUTE_NORMAL);
    check_triangles();
    if (desc_.face_column_count > most_face_columns) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "desc.face_column_count", "is %u, must be at most %u", desc_.face_column_count,
             most_face_columns);
    }
    if (desc_.face_column_count != 0) check_argument(desc_.face_columns, "desc.face_columns");
    for (uint32_t i = 0; i < desc_.face_column_count; ++i) check_face_column(i);
    if (desc_.material_count == 0) return;
    check_argument(desc_.materials, "desc.materials");
    for (uint32_t i = 0; i < desc_.material_count; ++i)
        check_material(desc_.materials[i], "desc.materials[" + std::to_string(i) + "].");
    if (split_regions()) check_labels();
}

void CheckedMesh::check_triangles() const {
    if (view_.triangle_count == 0) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.triangle_count", "is 0: there is nothing to write");
    }
    check_argument(view_.triangles, "view.triangles");
    // Signed indices in .ply; .glb keeps the last value of 32 bits for itself.
    if (view_.vertex_count > static_cast<uint32_t>(INT32_MAX)) {
        fail(FLG_ERROR_LIMIT, "view.vertex_count", "is %u, more than the limit of 2^31 - 1", view_.vertex_count);
    }
    const size_t corner_count = 3 * triangle_count();
    for (size_t i = 0; i < corner_count; ++i) {
        if (view_.triangles[i] < view_.vertex_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.triangles[" + std::to_string(i) + "]",
             "is %u, but there are %u vertices", view_.triangles[i], view_.vertex_count);
    }
}

void CheckedMesh::check_face_column(uint32_t index) const {
    constexpr size_t longest_name = 63;
    const std::string place = "desc.face_columns[" + std::to_string(index) + "]";
    const FlgMeshFaceColumn& column = desc_.face_columns[index];
    check_argument(column.name, (place + ".name").c_str());
    check_argument(column.values, (place + ".values").c_str());
    const std::string_view name(column.name, strnlen(column.name, longest_name + 1));
    const bool sound =
        !name.empty() && name.size() <= longest_name && std::all_of(name.begin(), name.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        });
    if (!sound || name == "region" || name == "vertex_indices") {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".name", "is %s, which is no name for a face column",
             cited(name).c_str());
    }
    for (uint32_t i = 0; i < index; ++i) {
        if (name != desc_.face_columns[i].name) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".name", "is %s, as that of column %u", cited(name).c_str(), i);
    }
}

void CheckedMesh::check_labels() const {
    for (size_t t = 0; t < triangle_count(); ++t) {
        if (region(t) < desc_.material_count) continue;
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.regions[" + std::to_string(t) + "]", "is %u, but there are %u materials",
             region(t), desc_.material_count);
    }
}

}  // namespace flg::io
