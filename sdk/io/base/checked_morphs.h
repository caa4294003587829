// SPDX-License-Identifier: MIT
// Morph targets of a skin and what animates them, as a host hands them over: checked whole before anything is written.
#pragma once

#include <cstddef>

#include "filigree/filigree_io.h"
#include "io/base/memory.h"

namespace flg::io {

class CheckedMorphs {
public:
    CheckedMorphs() = default;
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    explicit CheckedMorphs(const FlgSkinFileWriteDesc& desc);

    const Vector<FlgMorphTarget>& targets() const { return targets_; }
    const Vector<FlgMorphAnimation>& animations() const { return animations_; }

private:
    void check_target(const FlgMorphTarget& target, size_t vertex_count, const String& place) const;
    void check_animation(const FlgMorphAnimation& animation, uint32_t skin_animations, const String& place) const;

    Vector<FlgMorphTarget> targets_;
    Vector<FlgMorphAnimation> animations_;
};

}  // namespace flg::io
