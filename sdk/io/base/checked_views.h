// SPDX-License-Identifier: MIT
// What a host hands over to be written (curves, a mesh, a skin with its animations) and how it is to be written: each
// is checked whole before anything is made of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/origin.h"
#include "filigree/filigree.h"
#include "filigree/filigree_io.h"
#include "io/base/checked_morphs.h"
#include "io/base/memory.h"

namespace flg::io {

// A column with its stride resolved; null data when the view has none of that attribute.
struct Column {
    const float* data = nullptr;
    size_t stride = 0;  // bytes
    explicit operator bool() const { return data != nullptr; }
    const float* at(size_t point) const {
        return reinterpret_cast<const float*>(reinterpret_cast<const char*>(data) + point * stride);
    }
};

class CheckedColumns {
public:
    CheckedColumns() = default;
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    CheckedColumns(const FlgColumn* columns, uint32_t count, size_t point_count);

    Column find(FlgAttribute attribute) const;

private:
    void check(uint32_t index, size_t point_count) const;

    const FlgColumn* columns_ = nullptr;
    uint32_t count_ = 0;
};

Column resolved(const FlgColumn& column);

// The values of a column back to back.
Vector<float> packed(const Column& column, size_t point_count, uint32_t components);

// Refuses what no object can be relative to.
void check_origin(const double (&origin)[3], const char* name);

class CheckedView {
public:
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    explicit CheckedView(const FlgCurveSetView* view);

    uint32_t curve_count() const { return view_.curve_count; }
    size_t point_count() const { return view_.curve_offsets[view_.curve_count]; }
    size_t begin(uint32_t curve) const { return view_.curve_offsets[curve]; }
    size_t end(uint32_t curve) const { return view_.curve_offsets[curve + 1]; }
    std::span<const FlgColumn> columns() const { return {view_.columns, view_.column_count}; }
    Origin origin() const { return {view_.origin[0], view_.origin[1], view_.origin[2]}; }
    bool closed(uint32_t curve) const { return view_.curve_flags && (view_.curve_flags[curve] & FLG_CURVE_CLOSED); }

    Column position, radius, color, normal;

private:
    void check_curves() const;

    FlgCurveSetView view_ = {};
};

// White paint, without a name.
FlgMeshMaterial material_defaults();

class CheckedMesh {
public:
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    CheckedMesh(const FlgMeshView* view, const FlgMeshFileWriteDesc* desc);

    size_t vertex_count() const { return view_.vertex_count; }
    size_t triangle_count() const { return view_.triangle_count; }
    const uint32_t* triangle(size_t index) const { return view_.triangles + 3 * index; }
    const uint32_t* regions() const { return view_.regions; }
    uint32_t region(size_t triangle) const { return view_.regions ? view_.regions[triangle] : 0; }
    std::span<const FlgColumn> columns() const { return {view_.columns, view_.column_count}; }
    const Vector<FlgMeshFaceColumn>& face_columns() const { return face_columns_; }
    Origin origin() const { return {view_.origin[0], view_.origin[1], view_.origin[2]}; }
    bool split_regions() const { return desc_.split_regions != 0; }
    // By label; empty: none are given.
    const Vector<FlgMeshMaterial>& materials() const { return materials_; }
    // The file whose triangles were cut; none: the mesh stands alone.
    const char* asset() const { return desc_.asset; }
    const std::optional<FlgSurfaceProvenanceView>& provenance() const { return provenance_; }

    Column position, color, normal, uv;

private:
    void check_triangles() const;
    void check_face_column(uint32_t index) const;
    void check_labels() const;
    void check_provenance() const;

    FlgMeshView view_ = {};
    FlgMeshFileWriteDesc desc_ = {};
    Vector<FlgMeshFaceColumn> face_columns_;
    Vector<FlgMeshMaterial> materials_;
    std::optional<FlgSurfaceProvenanceView> provenance_;
};

class CheckedSkin {
public:
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    explicit CheckedSkin(const FlgSkinFileWriteDesc* desc);

    const FlgSkinView& skin() const { return meshes_[0]; }
    // The skin, and its levels of detail.
    const Vector<FlgSkinView>& meshes() const { return meshes_; }
    size_t joint_count() const { return skin().joint_count; }
    const Vector<FlgSkinAnimation>& animations() const { return animations_; }
    const Vector<FlgMeshMaterial>& materials() const { return materials_; }
    Origin origin() const { return {skin().origin[0], skin().origin[1], skin().origin[2]}; }
    String name() const { return desc_.name ? desc_.name : "model"; }
    const std::optional<FlgRig>& rig() const { return rig_; }
    const std::optional<FlgVrm>& vrm() const { return vrm_; }
    const Vector<FlgTexture>& textures() const { return textures_; }
    // FLG_NO_INDEX: none.
    uint32_t texture_of(const FlgMeshMaterial& material) const;
    // 4 per vertex of the skin, or null.
    const float* vertex_colors() const { return desc_.vertex_colors; }
    const CheckedMorphs& morphs() const { return morphs_; }

private:
    void check_mesh(const FlgSkinView& mesh, const String& place) const;
    void check_binding(const FlgSkinView& mesh, const String& place, size_t vertex) const;
    void check_triangles(const FlgSkinView& mesh, const String& place) const;
    void check_labels(const FlgSkinView& mesh, const String& place) const;
    void check_joints() const;
    void check_levels();
    void check_textures();
    void check_colors() const;
    void check_animation(const FlgSkinAnimation& animation, const String& place) const;
    void check_rig();
    void check_vrm();

    FlgSkinFileWriteDesc desc_ = {};
    Vector<FlgSkinView> meshes_;
    std::optional<FlgRig> rig_;
    std::optional<FlgVrm> vrm_;
    Vector<FlgSkinAnimation> animations_;
    Vector<FlgMeshMaterial> materials_;
    Vector<FlgTexture> textures_;
    CheckedMorphs morphs_;
};

// The part of a vertex, and of a triangle, as FlgSkinView has them.
uint32_t part_of_vertex(const FlgSkinView& skin, size_t vertex);
uint32_t part_of_triangle(const FlgSkinView& skin, size_t triangle);

}  // namespace flg::io
