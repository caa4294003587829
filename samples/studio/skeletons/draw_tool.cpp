// SPDX-License-Identifier: MIT
#include "skeletons/draw_tool.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "skeletons/contour_edits.h"
#include "skeletons/ink.h"
#include "skeletons/part_picking.h"

namespace flg::studio {
namespace {

constexpr double kSpacing_px = 4.0;  // of a contour's points, units of the layout
constexpr float kNearStart_px = 14.0f;

Ring rounded_ring(Ring ring, double spacing) {
    for (glm::dvec2& p : ring) p = rounded(p, spacing);
    return ring;
}

}  // namespace

void DrawTool::pointer(const Pointer& mouse) {
    hover_ = mouse.px;
    is_inside_ = mouse.inside;
    if (mouse.pressed && mouse.inside) {
        path_ = {mouse.px};
        is_hole_ = mouse.shift;
    }
    if (path_.empty()) return;
    // In the frame of the press places are from before it.
    for (const MouseSample& sample : mouse.pressed ? std::span<const MouseSample>() : mouse.path)
        if (sample.px != path_.back()) path_.push_back(sample.px);
    if (mouse.released) {
        finish(is_hole_);
    } else if (!mouse.down) {
        drop();
    }
}

void DrawTool::finish(bool hole) {
    try {
        hole ? make_hole() : make_part();
    } catch (...) {
        drop();
        throw;
    }
    drop();
}

std::vector<glm::dvec2> DrawTool::path_on_plane(double z) const {
    std::vector<glm::dvec2> points;
    for (const glm::vec2& px : path_) {
        const auto at = meet_plane(editor_.app.view.ray(px), {0.0f, 0.0f, static_cast<float>(z)}, {0.0f, 0.0f, 1.0f});
        if (at) points.emplace_back(at->x, at->y);
    }
    return points;
}

double DrawTool::spacing_at(const glm::vec3& place) const {
    return kSpacing_px * static_cast<double>(editor_.app.scale * editor_.app.view.metres_per_px(place));
}

void DrawTool::make_part() {
    const glm::vec3 sight = editor_.app.view.orbit.camera.target - editor_.app.view.orbit.camera.eye;
    double z = depth;
    const double spacing = spacing_at({0.0f, 0.0f, depth});
    Ring ring = ring_of_path(path_on_plane(z), spacing);
    if (ring.empty()) {
        const auto hit = pick_part(editor_, path_.front());
        return editor_.select(hit ? hit->id : 0);
    }
    if (std::abs(glm::normalize(sight).z) < 0.2f)
        throw StudioError("The drawing plane is seen edge-on. Press Front view to draw.");
    DrawnPart part = editor_.brush;
    if (editor_.brush_mirror == MirrorAs::front_back && z == 0.0) {
        z = depth_beside(editor_.drawing(), ring, part.thickness);
        z = std::round(z * 1e3) * 1e-3;
        const Ring there = ring_of_path(path_on_plane(z), spacing);
        if (!there.empty()) ring = there;
    }
    auto contour = std::make_shared<Contour>();
    contour->rings.push_back(rounded_ring(std::move(ring), spacing));
    if (part.name.empty()) part.name = "part " + std::to_string(editor_.drawing().parts.size() + 1);
    editor_.brush.name.clear();
    part.contour = std::move(contour);
    part.at = {0.0, 0.0, z};
    editor_.add({std::move(part)}, editor_.brush_mirror);
}

void DrawTool::make_hole() {
    const auto hit = pick_part(editor_, path_.front());
    if (!hit) throw StudioError("A hole must start inside a part, with Shift held down.");
    const DrawnPart& part = *editor_.drawing().find(hit->id);
    std::vector<glm::dvec2> points;
    for (const glm::vec2& px : path_)
        if (const auto at = meet_part(editor_.app.view, part, px)) points.push_back(*at);
    const double spacing = spacing_at(hit->position) / part.scale;
    const Ring hole = rounded_ring(ring_of_path(points, spacing), spacing);
    if (hole.empty()) return editor_.select(hit->id);
    for (const glm::dvec2& p : hole) {
        bool is_free = is_inside(part.contour->rings[0], p);
        for (size_t r = 1; r < part.contour->rings.size(); ++r)
            is_free = is_free && !is_inside(part.contour->rings[r], p);
        if (!is_free) throw StudioError("The hole must lie inside '" + part.name + "' and touch no other hole.");
    }
    auto contour = std::make_shared<Contour>(*part.contour);
    contour->rings.push_back(hole);
    editor_.commit();
    editor_.select(hit->id);
    DrawnPart& changed = editor_.change_selected("hole");
    changed.contour = std::move(contour);
    changed.branch_simplify.clear();
    editor_.commit();
}

void DrawTool::overlay(ImDrawList& list) const {
    const float unit = editor_.app.scale;
    const View& view = editor_.app.view;
    // The line that both halves meet at.
    if (editor_.brush_mirror == MirrorAs::left_right && editor_.drawing().mirror == glm::vec4(1, 0, 0, 0)) {
        const glm::vec3& aim = view.orbit.camera.target;
        const float half = 0.6f * view.metres_per_px(aim) * static_cast<float>(view.viewport.w);
        const auto a = view.project({0.0f, aim.y - half, 0.0f}), b = view.project({0.0f, aim.y + half, 0.0f});
        if (a && b) ink::dashes(list, *a, *b, ink::kGuide, 1.5f * unit, 8.0f * unit);
    }
    if (path_.empty()) {
        if (is_inside_) list.AddCircle({hover_.x, hover_.y}, 3.0f * unit, ink::kLine, 0, 1.5f * unit);
        return;
    }
    const ImU32 color = is_hole_ ? ink::kHole : ink::solid(editor_.brush.color);
    ink::line(list, path_, ink::kShade, 5.0f * unit, false);
    ink::line(list, path_, color, 3.0f * unit, false);
    const glm::vec2 start = path_.front(), end = path_.back();
    const bool is_near = path_.size() > 12 && glm::distance(start, end) < kNearStart_px * unit;
    if (!is_near && path_.size() > 4) ink::dashes(list, end, start, ink::kShade, 1.5f * unit, 6.0f * unit);
    list.AddCircleFilled({start.x, start.y}, (is_near ? 8.0f : 4.0f) * unit, is_near ? ink::kChosen : color);
    list.AddCircle({start.x, start.y}, (is_near ? 8.0f : 4.0f) * unit, ink::kShade, 0, 1.5f * unit);
}

}  // namespace flg::studio
