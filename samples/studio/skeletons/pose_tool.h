// SPDX-License-Identifier: MIT
// Poses the skinned body: joints are dragged, bones turned about themselves with Shift.
#pragma once

#include <optional>

#include "skeletons/editor.h"

struct ImDrawList;

namespace flg::studio {

class PoseTool {
public:
    explicit PoseTool(Editor& editor) : editor_(editor) {}

    // `joints`: of the rig, as they are shown.
    void pointer(const Pointer& mouse, const Rig& rig, const PosedJoints& joints);
    void overlay(ImDrawList& list, const Rig& rig, const PosedJoints& joints) const;
    void drop() { dragged_.reset(); }
    void leave() { hovered_.reset(), drop(); }
    bool is_dragging() const { return dragged_.has_value(); }
    // What is to be bright: the joint under the mouse and what turns with it.
    std::vector<uint32_t> bright(const Rig& rig) const;

private:
    Editor& editor_;
    std::optional<uint32_t> hovered_, dragged_;
    std::string key_;  // of the dragged joint
    glm::vec2 grab_px_{0.0f};
    glm::vec3 grab_at_{0.0f};
    bool is_twist_ = false;
    Pose before_;
};

}  // namespace flg::studio
