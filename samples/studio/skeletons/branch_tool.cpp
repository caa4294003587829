// SPDX-License-Identifier: MIT
#include "skeletons/branch_tool.h"

#include <imgui.h>

#include <algorithm>
#include <string>

#include "shell/widgets.h"
#include "skeletons/ink.h"

namespace flg::studio {
namespace {

constexpr float kReach = 9.0f;  // units of the layout

float distance_to(const std::vector<glm::vec2>& line, glm::vec2 px) {
    float nearest = 1e30f;
    for (size_t i = 1; i < line.size(); ++i) {
        const glm::vec2 along = line[i] - line[i - 1];
        const float square = glm::dot(along, along);
        const float t = square > 0.0f ? std::clamp(glm::dot(px - line[i - 1], along) / square, 0.0f, 1.0f) : 0.0f;
        nearest = std::min(nearest, glm::distance(px, line[i - 1] + t * along));
    }
    return nearest;
}

}  // namespace

std::vector<glm::vec2> BranchTool::branch_in_window(const DrawnPart& part, const FlgPartView& axis,
                                                    uint32_t branch) const {
    const glm::dmat4 matrix = part.matrix();
    std::vector<glm::vec2> line;
    for (uint32_t s = axis.branches[4 * branch + 2]; s < axis.branches[4 * branch + 3]; ++s) {
        const glm::dvec4 at = matrix * glm::dvec4(axis.samples[s].x, axis.samples[s].y, 0.0, 1.0);
        if (const auto px = editor_.app.view.project(glm::vec3(at))) line.push_back(*px);
    }
    return line;
}

std::optional<uint32_t> BranchTool::branch_at(glm::vec2 px) const {
    const DrawnPart* part = editor_.selected();
    const FlgPartView* axis = part && part->visible ? editor_.live.axis_of(part->contour) : nullptr;
    if (axis == nullptr) return std::nullopt;
    std::optional<uint32_t> found;
    float nearest = kReach * editor_.app.scale;
    for (uint32_t b = 0; b < axis->branch_count; ++b) {
        const float distance = distance_to(branch_in_window(*part, *axis, b), px);
        if (distance >= nearest) continue;
        nearest = distance;
        found = b;
    }
    return found;
}

std::optional<uint32_t> BranchTool::branch() const {
    const DrawnPart* part = editor_.selected();
    return part != nullptr && contour_.lock() == part->contour ? branch_ : std::nullopt;
}

void BranchTool::pointer(const Pointer& mouse) {
    hovered_ = mouse.inside ? branch_at(mouse.px) : std::nullopt;
    if (!mouse.pressed || !mouse.inside) return;
    editor_.commit();
    if (hovered_) {
        branch_ = hovered_;
        contour_ = editor_.selected()->contour;
        return;
    }
    branch_.reset();
    const auto hit = pick_part(editor_, mouse.px);
    editor_.select(hit ? hit->id : 0);
}

void BranchTool::overlay(ImDrawList& list) const {
    const DrawnPart* part = editor_.selected();
    const FlgPartView* axis = part && part->visible ? editor_.live.axis_of(part->contour) : nullptr;
    if (axis == nullptr) return;
    const float unit = editor_.app.scale;
    for (uint32_t b = 0; b < axis->branch_count; ++b) {
        const std::vector<glm::vec2> line = branch_in_window(*part, *axis, b);
        if (line.size() < 2) continue;
        const bool is_chosen = branch() == b, is_hovered = hovered_ == b;
        ink::line(list, line, ink::kShade, (is_chosen || is_hovered ? 5.5f : 3.5f) * unit, false);
        ink::line(list, line,
                  is_chosen    ? ink::kChosen
                  : is_hovered ? ink::kHover
                               : ink::kAxis,
                  (is_chosen || is_hovered ? 3.0f : 1.5f) * unit, false);
        const glm::vec2 middle = line[line.size() / 2], half(kReach * unit);
        ui::mark("branch " + std::to_string(b + 1), {middle - half, middle + half});
    }
}

}  // namespace flg::studio
