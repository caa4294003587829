// SPDX-License-Identifier: MIT
#include "shell/side_panel.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"

namespace flg::studio {
namespace {

constexpr float kNarrowest = 180.0f, kWidest = 560.0f;
constexpr float kLargestShare = 0.45f;

}  // namespace

float SidePanel::width(float window_units) const {
    if (folded_) return 0.0f;
    return std::round(std::min(width_, std::max(share_ * window_units, kNarrowest)));
}

void SidePanel::draw_border(const char* label, float x, float top, float height, float scale, float window_units,
                            float sign) {
    ImGui::SetNextWindowPos({x, top});
    ImGui::SetNextWindowSize({kBorder * scale, height});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    ImGui::Begin(label, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    const std::string name = label + 2;
    const bool clicked = ImGui::InvisibleButton(name.c_str(), {kBorder * scale, height});
    ui::mark(name, {{x, top}, {x + kBorder * scale, top + height}});
    const bool hovered = ImGui::IsItemHovered(), held = ImGui::IsItemActive();
    if (held && std::abs(ImGui::GetMouseDragDelta(0).x) > 3.0f * scale && !folded_) dragged_ = true;
    if (dragged_ && held) {
        share_ = kLargestShare;
        width_ = std::clamp(width(window_units) + sign * ImGui::GetIO().MouseDelta.x / scale, kNarrowest, kWidest);
    } else if (clicked && !dragged_) {
        folded_ = !folded_;
    }
    if (!held) dragged_ = false;
    if (hovered || held) ImGui::SetMouseCursor(folded_ ? ImGuiMouseCursor_Hand : ImGuiMouseCursor_ResizeEW);
    ui::tip(folded_ ? "Click to unfold the panel. Tab." : "Drag to resize the panel, click to fold it. Tab.");
    // An arrow that points where the panel goes.
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered || held) list.AddRectFilled({x, top}, {x + kBorder * scale, top + height}, IM_COL32(84, 76, 67, 255));
    const ImU32 ink = hovered ? IM_COL32(255, 222, 170, 255) : IM_COL32(154, 149, 141, 255);
    const float points = (folded_ ? -sign : sign) * 2.5f * scale, r = 5.0f * scale;
    const ImVec2 c = {x + 0.5f * kBorder * scale, top + 0.5f * height};
    list.AddTriangleFilled({c.x - points, c.y}, {c.x + points, c.y - r}, {c.x + points, c.y + r}, ink);
    ImGui::End();
    ImGui::PopStyleVar(2);
}

}  // namespace flg::studio
