// SPDX-License-Identifier: MIT
// Morph targets of a skin and what animates them, as a host hands them over: checked whole before anything is written.
#pragma once

#include <cstddef>
#include <span>

#include "filigree/filigree_io.h"
#include "io/base/memory.h"

namespace flg::io {

class CheckedMorphs {
public:
    CheckedMorphs() = default;
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    // `meshes`: the skin and its levels of detail.
    CheckedMorphs(const FlgSkinFileWriteDesc& desc, std::span<const FlgSkinView> meshes);

    // Of one of the meshes.
    std::span<const FlgMorphTarget> targets(size_t mesh = 0) const {
        return std::span(targets_).subspan(mesh == 0 || has_levels_ ? mesh * count_ : 0,
                                           mesh == 0 || has_levels_ ? count_ : 0);
    }
    const Vector<FlgMorphAnimation>& animations() const { return animations_; }

private:
    void add_targets(const FlgMorphTarget* from, size_t vertex_count, uint32_t first, const String& list);
    void check_target(const FlgMorphTarget& target, size_t vertex_count, const String& place) const;
    void check_animation(const FlgMorphAnimation& animation, uint32_t skin_animations, const String& place) const;

    Vector<FlgMorphTarget> targets_;  // mesh by mesh
    size_t count_ = 0;
    bool has_levels_ = false;
    Vector<FlgMorphAnimation> animations_;
};

}  // namespace flg::io
