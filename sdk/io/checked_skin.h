// SPDX-License-Identifier: MIT
// A skin from a host, its animations, and how they are to be written, checked whole before anything is made of them.
#pragma once

#include <span>
#include <string>

#include "filigree/filigree_io.h"

namespace flg::io {

FlgSkinFileDesc skin_file_defaults();

class CheckedSkin {
public:
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    explicit CheckedSkin(const FlgSkinFileDesc* desc);

    const FlgSkinView& skin() const { return skin_; }
    size_t vertex_count() const { return skin_.vertex_count; }
    size_t joint_count() const { return skin_.joint_count; }
    std::span<const FlgSkinAnimation> animations() const { return {desc_.animations, desc_.animation_count}; }
    std::span<const FlgMeshMaterial> materials() const { return {desc_.materials, desc_.material_count}; }
    std::string name() const { return desc_.name ? desc_.name : "model"; }
    uint32_t part(size_t vertex) const { return skin_.vertex_parts ? skin_.vertex_parts[vertex] : 0; }

private:
    void check_vertices() const;
    void check_binding(size_t vertex) const;
    void check_triangles() const;
    void check_joints() const;
    void check_animation(uint32_t index) const;
    void check_materials() const;

    FlgSkinFileDesc desc_ = skin_file_defaults();
    FlgSkinView skin_ = {};
};

}  // namespace flg::io
