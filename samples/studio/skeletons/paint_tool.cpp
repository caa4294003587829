// SPDX-License-Identifier: MIT
#include "skeletons/paint_tool.h"

#include <imgui.h>

#include <cmath>

#include "filigree_renderer/surface_look.h"
#include "shell/widgets.h"
#include "skeletons/body_place.h"
#include "skeletons/ink.h"

namespace flg::studio {
namespace {

constexpr float kBrushStep = 0.3f;   // of the radius, from dab to dab
constexpr float kPressReach = 4.0f;  // units of the layout: a press that moves further paints
constexpr float kOnPlane = 0.25f;    // of the radius: nearer to the mirror a dab is its own image

}  // namespace

std::optional<uint32_t> PaintTool::chosen(const Rig& rig) const {
    for (uint32_t j = 0; j < rig.count() && !joint_.empty(); ++j)
        if (rig.keys[j] == joint_) return j;
    return std::nullopt;
}

std::vector<uint32_t> PaintTool::bright(const Rig& rig) const {
    std::vector<uint32_t> joints;
    if (const auto joint = chosen(rig)) joints.push_back(*joint);
    if (hovered_ && *hovered_ < rig.count() && !stroke_) joints.push_back(*hovered_);
    return joints;
}

void PaintTool::look_at(const Rig& rig) {
    if (symmetry_of_ == editor_.live.shape_revision()) return;
    symmetry_of_ = editor_.live.shape_revision();
    symmetry_ = symmetry_of(rig);
}

void PaintTool::drop() {
    if (stroke_) layer_.drop();
    stroke_.reset(), pressed_joint_.reset();
}

void PaintTool::pointer(const Pointer& mouse, const Rig& rig, const PosedJoints& joints) {
    look_at(rig);
    const View& view = editor_.app.view;
    hover_px_ = mouse.px;
    on_body_ = mouse.inside;
    if (!stroke_ && !pressed_joint_)
        hovered_ = mouse.inside ? joint_at(view, mouse.px, rig, joints, kJointReach * editor_.app.scale) : std::nullopt;
    const auto joint = chosen(rig);
    if (mouse.pressed && mouse.inside) {
        editor_.commit();
        press_px_ = last_px_ = mouse.px;
        pressed_shift_ = mouse.shift;
        pressed_joint_ = hovered_;
        if (!hovered_ && joint) {
            begin_stroke(rig, *joint, mouse.shift);
            paint_at(mouse.px);
        }
    }
    if (pressed_joint_ && glm::distance(mouse.px, press_px_) > kPressReach * editor_.app.scale) {
        pressed_joint_.reset();
        if (joint) {
            begin_stroke(rig, *joint, pressed_shift_);
            paint_at(press_px_);
        }
    }
    if (pressed_joint_ && !mouse.down) {
        if (*pressed_joint_ < rig.count()) joint_ = rig.keys[*pressed_joint_];
        pressed_joint_.reset();
    }
    if (!stroke_) return;
    for (const MouseSample& sample : mouse.pressed ? std::span<const MouseSample>() : mouse.path) paint_to(sample.px);
    if (mouse.down) return;
    WeightStroke stroke = std::move(*stroke_);
    stroke_.reset();
    if (!stroke.dabs.empty()) layer_.keep(std::move(stroke));
}

void PaintTool::begin_stroke(const Rig& rig, uint32_t joint, bool inverts) {
    // What the last stroke changed may still be painted again.
    if (layer_.weights() == nullptr) return;
    stroke_ = WeightStroke{brush, rig.keys[joint], {}, strength, {}};
    if (inverts && brush != WeightBrush::smooth)
        stroke_->brush = brush == WeightBrush::add ? WeightBrush::subtract : WeightBrush::add;
    if (mirrors && symmetry_) stroke_->mirror_joint = rig.keys[symmetry_->pairs[joint]];
}

void PaintTool::paint_to(glm::vec2 px) {
    const float step = kBrushStep * radius * editor_.app.scale;
    while (glm::distance(px, last_px_) >= step) {
        last_px_ += step * glm::normalize(px - last_px_);
        paint_at(last_px_);
    }
}

void PaintTool::paint_at(glm::vec2 px) {
    const LiveModel::Skinned* skin = editor_.live.skin();
    if (!stroke_ || skin == nullptr) return;
    const FlgSkinView& view = skin->view;
    const auto hit = pick_skin(view, {view.positions, size_t{3} * view.vertex_count}, editor_.app.view.ray(px));
    if (!hit) return;
    const float metres = radius * editor_.app.scale * editor_.app.view.metres_per_px(hit->position);
    const auto add = [&](uint32_t part, const glm::vec3& at, bool is_mirror) {
        WeightDab dab{place_on(editor_.drawing(), *skin, part, at), 0.0, is_mirror};
        const DrawnPart* drawn = editor_.drawing().find(skin->parts[part]);
        if (drawn == nullptr) return;
        dab.radius = static_cast<double>(metres) / drawn->scale;
        layer_.paint(*stroke_, dab);
        stroke_->dabs.push_back(std::move(dab));
    };
    add(view.vertex_parts[view.triangles[3 * size_t{hit->triangle}]], hit->position, false);
    if (stroke_->mirror_joint.empty() || !symmetry_) return;
    const glm::vec3 image = mirrored_in(symmetry_->plane, hit->position);
    const bool is_own =
        stroke_->mirror_joint == stroke_->joint && glm::distance(image, hit->position) < kOnPlane * metres;
    const uint32_t nearest = is_own ? FLG_NO_INDEX : nearest_vertex(view, FLG_NO_INDEX, image);
    if (nearest != FLG_NO_INDEX) add(view.vertex_parts[nearest], image, true);
}

void PaintTool::overlay(ImDrawList& list, const Rig& rig, const PosedJoints& joints) const {
    const View& view = editor_.app.view;
    const float unit = editor_.app.scale;
    for (uint32_t j = 0; j < rig.count(); ++j)
        if (const auto at = view.project(joints.at[j]))
            ui::mark("joint " + rig.names[j], {*at - kJointReach * unit, *at + kJointReach * unit});
    const auto joint = chosen(rig);
    if (hovered_ && *hovered_ < rig.count() && !stroke_)
        if (const auto at = view.project(joints.at[*hovered_]))
            ink::label(list, *at + glm::vec2(18.0f, -22.0f) * unit, rig.names[*hovered_].c_str(), unit);
    if (!joint) return;
    if (on_body_ && (!hovered_ || stroke_)) {
        list.AddCircle({hover_px_.x, hover_px_.y}, radius * unit, ink::kShade, 0, 3.5f * unit);
        list.AddCircle({hover_px_.x, hover_px_.y}, radius * unit, ink::kChosen, 0, 1.8f * unit);
    }
    // The scale of the colours.
    constexpr int kSteps = 32;
    constexpr float kWide = 180.0f, kHigh = 12.0f, kFromEdge = 18.0f;
    const glm::vec4 port(view.viewport);
    const glm::vec2 low(port.x + kFromEdge * unit, port.y + port.w - (kFromEdge + 34.0f) * unit);
    ink::label(list, low - glm::vec2(0.0f, 24.0f) * unit, ("Weight of " + rig.names[*joint]).c_str(), unit);
    for (int i = 0; i < kSteps; ++i) {
        const float from = static_cast<float>(i) / kSteps, to = static_cast<float>(i + 1) / kSteps;
        list.AddRectFilled({low.x + from * kWide * unit, low.y}, {low.x + to * kWide * unit, low.y + kHigh * unit},
                           ui::shown_color(render::field_color(0.5f * (from + to))));
    }
    for (const float share : {0.0f, 0.5f, 1.0f}) {
        const char* text = share == 0.0f ? "0" : share == 1.0f ? "1" : "0.5";
        const float wide = ImGui::CalcTextSize(text).x;
        list.AddText({low.x + share * (kWide * unit - wide), low.y + (kHigh + 3.0f) * unit}, ink::kLine, text);
    }
}

}  // namespace flg::studio
