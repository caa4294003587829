// SPDX-License-Identifier: MIT
#include "skeletons/pose_tool.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"
#include "skeletons/ink.h"
#include "skeletons/part_picking.h"

namespace flg::studio {
namespace {

constexpr float kTurn_per_unit = 0.0125f;  // radians

}  // namespace

std::vector<uint32_t> PoseTool::bright(const Rig& rig) const {
    const auto joint = dragged_ ? dragged_ : hovered_;
    if (!joint || *joint >= rig.count()) return {};
    return {*joint};
}

void PoseTool::pointer(const Pointer& mouse, const Rig& rig, const PosedJoints& joints) {
    if (!dragged_)
        hovered_ = mouse.inside ? joint_at(editor_.app.view, mouse.px, rig, joints, kJointReach * editor_.app.scale)
                                : std::nullopt;
    if (mouse.pressed && mouse.inside && hovered_) {
        editor_.commit();
        if (mouse.double_clicked) {
            editor_.change("rest").pose.turns.erase(rig.keys[*hovered_]);
            editor_.commit();
            return;
        }
        dragged_ = hovered_;
        key_ = rig.keys[*dragged_];
        grab_px_ = mouse.px;
        grab_at_ = joints.at[*dragged_];
        is_twist_ = mouse.shift;
        before_ = editor_.drawing().pose;
    }
    if (!dragged_) return;
    // The bones may be others by now.
    if (*dragged_ >= rig.count() || rig.keys[*dragged_] != key_) return leave();
    if (mouse.px != grab_px_ || editor_.is_acting()) {
        const View& view = editor_.app.view;
        Pose pose = before_;
        if (is_twist_) {
            twist(rig, pose, *dragged_, kTurn_per_unit * (mouse.px.x - grab_px_.x) / editor_.app.scale);
        } else {
            const glm::vec3 sight = glm::normalize(view.orbit.camera.target - view.orbit.camera.eye);
            const auto from = meet_plane(view.ray(grab_px_), grab_at_, sight),
                       to = meet_plane(view.ray(mouse.px), grab_at_, sight);
            if (from && to) pull(rig, pose, *dragged_, grab_at_ + *to - *from);
        }
        editor_.change("pose").pose = std::move(pose);
    }
    if (!mouse.down) {
        editor_.commit();
        drop();
    }
}

void PoseTool::overlay(ImDrawList& list, const Rig& rig, const PosedJoints& joints) const {
    const View& view = editor_.app.view;
    const float unit = editor_.app.scale;
    for (uint32_t j = 0; j < rig.count(); ++j) {
        const auto at = view.project(joints.at[j]);
        if (at) ui::mark("joint " + rig.names[j], {*at - kJointReach * unit, *at + kJointReach * unit});
    }
    const auto lit = dragged_ ? dragged_ : hovered_;
    if (!lit || *lit >= rig.count()) return;
    const auto at = view.project(joints.at[*lit]);
    if (!at) return;
    list.AddCircle({at->x, at->y}, 12.0f * unit, ink::kShade, 0, 3.5f * unit);
    list.AddCircle({at->x, at->y}, 12.0f * unit, ink::kChosen, 0, 2.0f * unit);
    if (!dragged_) ink::label(list, *at + glm::vec2(18.0f, -22.0f) * unit, rig.names[*lit].c_str(), unit);
}

}  // namespace flg::studio
