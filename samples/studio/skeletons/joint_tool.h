// SPDX-License-Identifier: MIT
// Selects a joint of the rest pose, and drags it within its part: there it is pinned.
#pragma once

#include <optional>

#include "skeletons/part_picking.h"

struct ImDrawList;

namespace flg::studio {

class JointTool {
public:
    explicit JointTool(Editor& editor) : editor_(editor) {}

    // True where the mouse is this tool's. `joints`: of the rig, as they are shown.
    bool pointer(const Pointer& mouse, const Rig& rig, const PosedJoints& joints);
    void overlay(ImDrawList& list, const Rig& rig, const PosedJoints& joints) const;
    void drop() { dragged_.clear(); }
    void leave() { selected_.clear(), hovered_.reset(), drop(); }
    bool is_dragging() const { return !dragged_.empty(); }

    // By its key, without a side; none while it is not there.
    std::optional<uint32_t> selected(const Rig& rig) const;
    void select(const std::string& key) { selected_ = key; }
    std::vector<uint32_t> bright(const Rig& rig) const;

private:
    Editor& editor_;
    std::optional<uint32_t> hovered_;
    std::string selected_, dragged_;  // keys
    bool is_moved_ = false;
    // When it was grabbed:
    glm::vec2 grab_px_{0.0f};
    glm::dvec3 grab_place_{0.0};
    uint32_t part_ = 0;
    bool is_image_ = false;
};

}  // namespace flg::studio
