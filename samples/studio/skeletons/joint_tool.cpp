// SPDX-License-Identifier: MIT
#include "skeletons/joint_tool.h"

#include <imgui.h>

#include "shell/widgets.h"
#include "skeletons/ink.h"
#include "skeletons/joint_edits.h"

namespace flg::studio {
namespace {

constexpr float kStart = 3.0f;  // units of the layout: so far the mouse may go without moving the joint

bool is_in_contour(const Contour& contour, const glm::dvec2& at) {
    bool is_in = false;
    for (const Ring& ring : contour.rings) {
        std::vector<glm::vec2> polygon;
        for (const glm::dvec2& p : ring) polygon.emplace_back(p - at);
        is_in = is_in != is_in_polygon(polygon, glm::vec2(0.0f));
    }
    return is_in;
}

}  // namespace

std::optional<uint32_t> JointTool::selected(const Rig& rig) const {
    for (uint32_t j = 0; j < rig.count() && !selected_.empty(); ++j)
        if (key_of(rig, j) == selected_) return j;
    return std::nullopt;
}

std::vector<uint32_t> JointTool::bright(const Rig& rig) const {
    std::vector<uint32_t> joints;
    for (uint32_t j = 0; j < rig.count(); ++j)
        if (key_of(rig, j) == selected_ || hovered_ == j) joints.push_back(j);
    return joints;
}

bool JointTool::pointer(const Pointer& mouse, const Rig& rig, const PosedJoints& joints) {
    const View& view = editor_.app.view;
    if (dragged_.empty())
        hovered_ = mouse.inside ? joint_at(view, mouse.px, rig, joints, kJointReach * editor_.app.scale) : std::nullopt;
    if (mouse.pressed && mouse.inside) {
        editor_.commit();
        selected_ = hovered_ ? key_of(rig, *hovered_) : std::string();
        if (!hovered_) return false;
        dragged_ = selected_;
        is_moved_ = false;
        grab_px_ = mouse.px;
        grab_place_ = rig.places[*hovered_];
        part_ = rig.parts[*hovered_];
        is_image_ = rig.is_image[*hovered_];
        editor_.select(part_);
    }
    if (dragged_.empty()) return hovered_.has_value();
    is_moved_ = is_moved_ || glm::distance(mouse.px, grab_px_) > kStart * editor_.app.scale;
    const DrawnPart* part = editor_.drawing().find(part_);
    if (part == nullptr) {
        drop();
        return true;
    }
    if (is_moved_) {
        const auto place = [&](glm::vec2 px) {
            return meet_part(view, *part, px, is_image_ ? &editor_.drawing().mirror : nullptr);
        };
        const auto from = place(grab_px_), to = place(mouse.px);
        const glm::dvec2 at = from && to ? glm::dvec2(grab_place_) + *to - *from : glm::dvec2(grab_place_);
        // Outside of its part it waits at the border.
        if (is_in_contour(*part->contour, at))
            pin_joint(editor_.change("joint"), dragged_, {at.x, at.y, grab_place_.z});
    }
    if (!mouse.down) {
        editor_.commit();
        drop();
    }
    return true;
}

void JointTool::overlay(ImDrawList& list, const Rig& rig, const PosedJoints& joints) const {
    const View& view = editor_.app.view;
    const float unit = editor_.app.scale;
    const auto chosen = selected(rig);
    for (uint32_t j = 0; j < rig.count(); ++j) {
        const auto at = view.project(joints.at[j]);
        if (!at) continue;
        ui::mark("joint " + rig.names[j], {*at - kJointReach * unit, *at + kJointReach * unit});
        if (rig.pinned[j]) list.AddCircleFilled({at->x, at->y}, 3.5f * unit, ink::kShade);
        const bool is_chosen = chosen && key_of(rig, *chosen) == key_of(rig, j);
        if (!is_chosen && hovered_ != j) continue;
        list.AddCircle({at->x, at->y}, 12.0f * unit, ink::kShade, 0, 3.5f * unit);
        list.AddCircle({at->x, at->y}, 12.0f * unit, is_chosen ? ink::kChosen : ink::kHover, 0, 2.0f * unit);
        if (dragged_.empty() && (hovered_ == j || chosen == j))
            ink::label(list, *at + glm::vec2(18.0f, -22.0f) * unit, rig.names[j].c_str(), unit);
    }
}

}  // namespace flg::studio
