// SPDX-License-Identifier: MIT
// A mesh view from a host and how it is to be written, checked whole before anything is made of them.
#pragma once

#include <span>
#include <string>

#include "filigree/filigree_io.h"
#include "io/checked_columns.h"

namespace flg::io {

FlgMeshWriteDesc mesh_write_defaults();

// Refuses what no material can be; `place` names it, and ends with a dot.
void check_material(const FlgMeshMaterial& material, const std::string& place);

class CheckedMesh {
public:
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    CheckedMesh(const FlgMeshView* view, const FlgMeshWriteDesc* desc);

    size_t vertex_count() const { return view_.vertex_count; }
    size_t triangle_count() const { return view_.triangle_count; }
    const uint32_t* triangle(size_t index) const { return view_.triangles + 3 * index; }
    const uint32_t* regions() const { return view_.regions; }
    uint32_t region(size_t triangle) const { return view_.regions ? view_.regions[triangle] : 0; }
    std::span<const FlgColumn> columns() const { return {view_.columns, view_.column_count}; }
    std::span<const FlgMeshFaceColumn> face_columns() const { return {desc_.face_columns, desc_.face_column_count}; }
    bool split_regions() const { return desc_.split_regions != 0; }
    // By label; empty: none are given.
    std::span<const FlgMeshMaterial> materials() const { return {desc_.materials, desc_.material_count}; }

    Column position, color, normal;

private:
    void check_triangles() const;
    void check_face_column(uint32_t index) const;
    void check_labels() const;

    FlgMeshView view_ = {};
    FlgMeshWriteDesc desc_ = mesh_write_defaults();
};

}  // namespace flg::io
