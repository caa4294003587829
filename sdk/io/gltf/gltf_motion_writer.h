// SPDX-License-Identifier: MIT
// Motions of rigid bodies as glTF 2.0, binary.
#pragma once

#include <optional>

#include "filigree/filigree_io.h"
#include "io/base/checked_views.h"
#include "io/base/memory.h"

namespace flg::io {

// A motion from a host, checked whole before anything is made of it.
class CheckedMotion {
public:
    // Fails with FLG_ERROR_INVALID_ARGUMENT at the first thing that is wrong. The host's arrays must outlive this.
    explicit CheckedMotion(const FlgMotionFileWriteDesc* desc);

    // Poses, one more where the first comes again.
    size_t position_count() const { return size_t{desc_.position_count} + (returns() ? 1 : 0); }
    float time(size_t position) const;
    const double* pose(size_t position) const { return desc_.poses + 12 * (position % desc_.position_count); }
    const std::optional<CheckedMesh>& mesh() const { return mesh_; }
    Origin origin() const { return {desc_.origin[0], desc_.origin[1], desc_.origin[2]}; }
    float camera_fov_rad() const { return desc_.camera_fov_rad; }
    String name() const { return desc_.name ? desc_.name : "motion"; }

private:
    bool returns() const { return desc_.end_time != 0; }
    void check_positions() const;

    FlgMotionFileWriteDesc desc_ = {};
    std::optional<CheckedMesh> mesh_;
};

String write_glb_motion(const CheckedMotion& motion);

}  // namespace flg::io
