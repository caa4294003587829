// SPDX-License-Identifier: MIT
#include "splines/overlay.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "shell/widgets.h"

namespace flg::studio::splines {
namespace {

constexpr double kSlack = 0.02;  // of the scene's size
constexpr float kHiddenAlpha = 0.28f;

ImVec2 im(glm::vec2 v) {
    return {v.x, v.y};
}

ImU32 color(const glm::vec3& srgb, float alpha) {
    return ImGui::ColorConvertFloat4ToU32({srgb.x, srgb.y, srgb.z, alpha});
}

constexpr glm::vec3 kWhite{1.0f, 1.0f, 1.0f}, kInk{0.10f, 0.11f, 0.14f}, kWarm{1.0f, 0.78f, 0.36f};

class Drawing {
public:
    Drawing(ImDrawList& list, const SplineEditor& editor, const Handle& hot)
        : list_(list), editor_(editor), hot_(hot), scale_(editor.app.scale) {}

    // A round handle with what scripts find it by; returns where it is.
    std::optional<glm::vec2> dot(const glm::dvec3& place, const Handle& handle, const glm::vec3& fill,
                                 const std::string& label, bool chosen, float radius = 5.0f) {
        const auto at = editor_.app.view.project(place);
        if (!at || !editor_.app.view.contains(*at)) return std::nullopt;
        const bool hot = handle == hot_;
        const bool hidden = !hot && editor_.surfaces.hidden(place, kSlack * editor_.size());
        const float alpha = hidden ? kHiddenAlpha : 1.0f;
        const float r = (hot ? 1.45f : 1.0f) * radius * scale_;
        list_.AddCircleFilled(im(*at), r + 1.6f * scale_, color(kInk, 0.55f * alpha), 24);
        list_.AddCircleFilled(im(*at), r, color(hot ? kWhite : fill, alpha), 24);
        if (chosen) list_.AddCircle(im(*at), r + 3.0f * scale_, color(kWarm, alpha), 28, 1.6f * scale_);
        ui::mark(label, {*at - glm::vec2(r), *at + glm::vec2(r)});
        return hidden ? std::nullopt : at;
    }

    void chain(const std::vector<glm::vec2>& places, ImU32 tint, float width) {
        for (size_t i = 1; i < places.size(); ++i)
            list_.AddLine(im(places[i - 1]), im(places[i]), tint, width * scale_);
    }

    void text(glm::vec2 at, const std::string& what) {
        const ImVec2 size = ImGui::CalcTextSize(what.c_str());
        list_.AddRectFilled({at.x - 2.0f * scale_, at.y}, {at.x + size.x + 2.0f * scale_, at.y + size.y},
                            color(kInk, 0.45f), 2.0f * scale_);
        list_.AddText({at.x, at.y}, color(kWhite, 0.95f), what.c_str());
    }

    void curves();
    void obstacles();
    void keys();

private:
    void slopes(const Curve& curve);
    void highlight(const Curve& curve, float alpha);

    ImDrawList& list_;
    const SplineEditor& editor_;
    const Handle hot_;
    const float scale_;
};

void Drawing::highlight(const Curve& curve, float alpha) {
    const LiveCurve* const live = editor_.live_curve(curve.id);
    if (live == nullptr) return;
    std::vector<glm::vec2> seen;
    const FoundCurve& found = live->found();
    const render::Placement placement = editor_.surfaces.placement(curve.ground);
    for (size_t i = 0; i < found.nodes.size() + (found.closed ? 1 : 0); ++i) {
        const glm::vec3 node = placement.point(found.nodes[i % found.nodes.size()]);
        const auto at = editor_.app.view.project(node);
        if (at && !editor_.surfaces.hidden(node, kSlack * editor_.size())) {
            seen.push_back(*at);
            continue;
        }
        chain(seen, color(kWarm, alpha), 2.5f);
        seen.clear();
    }
    chain(seen, color(kWarm, alpha), 2.5f);
}

void Drawing::slopes(const Curve& curve) {
    for (const bool begin : {true, false}) {
        const auto tip = slope_tip(editor_, curve, begin);
        if (!tip) continue;
        const auto from = editor_.app.view.project(
            editor_.surfaces.to_world(curve.ground, begin ? curve.points.front() : curve.points.back()));
        const auto to = editor_.app.view.project(*tip);
        if (from && to) chain({*from, *to}, color(kWarm, 0.9f), 2.0f);
        dot(*tip, {begin ? HandleKind::begin_slope : HandleKind::end_slope, curve.id, 0}, kWarm,
            begin ? "begin direction" : "end direction", false, 4.0f);
    }
}

void Drawing::curves() {
    for (const Curve& curve : editor_.document.curves) {
        if (!curve.visible || !editor_.surfaces.is_seen(curve.ground)) continue;
        if (hot_.item == curve.id && (hot_.kind == HandleKind::curve || hot_.kind == HandleKind::span))
            highlight(curve, 0.8f);
        if (curve.id != editor_.curve) continue;
        slopes(curve);
        for (size_t i = 0; i < curve.points.size(); ++i) {
            const std::string number = std::to_string(i + 1);
            const Handle handle{HandleKind::point, curve.id, static_cast<int>(i)};
            const bool last = editor_.drawing == curve.id && i + 1 == curve.points.size();
            const auto at = dot(editor_.surfaces.to_world(curve.ground, curve.points[i]), handle, last ? kWarm : kWhite,
                                "point " + number, editor_.point == static_cast<int>(i));
            if (at) text(*at + glm::vec2(8.0f, -18.0f) * scale_, number);
        }
    }
}

void Drawing::obstacles() {
    for (const Obstacle& obstacle : editor_.document.obstacles) {
        const bool chosen = obstacle.id == editor_.obstacle;
        const Handle handle{HandleKind::solid, obstacle.id, 0};
        const auto at = editor_.app.view.project(obstacle.centre);
        if (!at || !editor_.app.view.contains(*at)) continue;
        ui::mark(obstacle.name, {*at - 3.0f, *at + 3.0f});
        if (handle == hot_ || (chosen && editor_.tool == Tool::obstacles)) {
            const float r = static_cast<float>(reach_of(obstacle)) / editor_.app.view.metres_per_px(obstacle.centre);
            const glm::vec2 middle = obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE
                                         ? editor_.app.view.project(0.5 * (obstacle.centre + obstacle.to)).value_or(*at)
                                         : *at;
            const bool capsule = obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE;
            list_.AddCircle(im(middle), capsule ? 0.6f * r : r, color(kWarm, handle == hot_ ? 0.9f : 0.45f), 48,
                            1.5f * scale_);
        }
        if (!chosen || editor_.tool != Tool::obstacles) continue;
        dot(size_handle(editor_, obstacle), {HandleKind::solid_size, obstacle.id, 0}, kWarm, "obstacle size", false,
            4.5f);
        if (obstacle.kind == FLG_OBSTACLE_KIND_CAPSULE)
            dot(obstacle.to, {HandleKind::solid_end, obstacle.id, 0}, kWhite, "capsule end", false, 4.5f);
    }
}

void Drawing::keys() {
    constexpr glm::vec3 kAxes[] = {{0.93f, 0.36f, 0.30f}, {0.55f, 0.80f, 0.35f}, {0.36f, 0.60f, 0.95f}};
    for (const Motion& motion : editor_.document.motions) {
        if (!motion.visible || motion.id != editor_.motion) continue;
        if (editor_.key >= 0 && editor_.key < static_cast<int>(motion.keys.size()) && !editor_.playing) {
            const Key& key = motion.keys[static_cast<size_t>(editor_.key)];
            for (int axis = 0; axis < 3; ++axis) {
                const bool hot = hot_ == Handle{HandleKind::ring, motion.id, axis};
                const auto ring = project(editor_.app.view, ring_of(motion, key, axis));
                chain(ring, color(kAxes[axis], hot ? 1.0f : 0.75f), hot ? 4.0f : 2.0f);
                if (ring.empty()) continue;
                const glm::vec2 at = ring[ring.size() / 8];
                ui::mark(std::string("ring ") + "xyz" [axis], { at - 1.0f, at + 1.0f });
            }
        }
        for (size_t i = 0; i < motion.keys.size(); ++i) {
            const std::string number = std::to_string(i + 1);
            const auto at = dot(motion.keys[i].place, {HandleKind::key, motion.id, static_cast<int>(i)}, kWhite,
                                "key " + number, editor_.key == static_cast<int>(i), 6.0f);
            if (at) text(*at + glm::vec2(9.0f, -20.0f) * scale_, number);
        }
    }
}

}  // namespace

void draw_overlay(ImDrawList& list, const SplineEditor& editor, const MouseTool& mouse_tool) {
    Drawing drawing(list, editor, mouse_tool.hot());
    drawing.obstacles();
    if (editor.tool == Tool::curves) drawing.curves();
    if (editor.tool == Tool::motions) drawing.keys();
    const char* const tip = mouse_tool.tip();
    if (tip[0] != '\0') ImGui::SetTooltip("%s", tip);
}

}  // namespace flg::studio::splines
