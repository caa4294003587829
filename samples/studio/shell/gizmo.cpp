// SPDX-License-Identifier: MIT
#include "shell/gizmo.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shell/widgets.h"

namespace flg::studio {
namespace {

// Units of the layout.
constexpr float kArm = 84.0f, kReach = 8.0f, kMissed = 15.0f, kKnob = 74.0f, kDot = 7.0f;
// Of the arm.
constexpr float kArmBegin = 0.22f, kSquare = 0.42f, kSquareHalf = 0.09f, kRing = 0.78f;
constexpr int kPieces = 72;
// With Shift.
constexpr float kTurnStep_deg = 15.0f;
constexpr float kLeast = 1e-4f, kMost = 1e4f;  // scale
constexpr ImU32 kAxes[] = {IM_COL32(226, 86, 74, 255), IM_COL32(128, 190, 84, 255), IM_COL32(86, 146, 236, 255)};
constexpr ImU32 kHot = IM_COL32(255, 214, 120, 255), kShade = IM_COL32(16, 18, 24, 130),
                kPlain = IM_COL32(240, 240, 236, 255);
constexpr const char* kNames[] = {"x", "y", "z"};

glm::vec3 axis_of(int axis) {
    glm::vec3 v(0.0f);
    v[axis] = 1.0f;
    return v;
}

ImVec2 im(glm::vec2 v) {
    return {v.x, v.y};
}

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 d = b - a;
    const float square = glm::dot(d, d);
    const float t = square > 0.0f ? glm::clamp(glm::dot(p - a, d) / square, 0.0f, 1.0f) : 0.0f;
    return glm::distance(p, a + t * d);
}

// The place of a line that is nearest to a ray.
glm::vec3 along_line(const Ray& ray, const glm::vec3& from, const glm::vec3& direction) {
    const glm::vec3 between = ray.origin - from;
    const float b = glm::dot(ray.direction, direction), d = glm::dot(ray.direction, between),
                e = glm::dot(direction, between), least = 1e-4f;
    const float denominator = std::max(1.0f - b * b, least);
    return from + ((e - b * d) / denominator) * direction;
}

}  // namespace

SceneMesh* Gizmo::mesh() const {
    SceneMesh* mesh = app_.scene.active();
    return mesh != nullptr && mesh->visible && mesh->is_placed && !mesh->box.empty() ? mesh : nullptr;
}

float Gizmo::size(const glm::vec3& middle) const {
    return kArm * app_.scale * app_.view.metres_per_px(middle);
}

std::vector<glm::vec3> Gizmo::ring(const glm::vec3& middle, int axis) const {
    const glm::vec3 u = axis_of((axis + 1) % 3), v = axis_of((axis + 2) % 3);
    const float radius = kRing * size(middle);
    std::vector<glm::vec3> places;
    for (int i = 0; i <= kPieces; ++i) {
        const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(i) / kPieces;
        places.push_back(middle + radius * (std::cos(angle) * u + std::sin(angle) * v));
    }
    return places;
}

glm::vec2 Gizmo::knob(glm::vec2 middle_px) const {
    return middle_px + kKnob * app_.scale * glm::vec2(0.7071f, -0.7071f);
}

std::optional<Gizmo::Grip> Gizmo::grip_at(glm::vec2 px, float reach_units) const {
    const SceneMesh* placed = mesh();
    if (!is_on_ || placed == nullptr) return std::nullopt;
    const View& view = app_.view;
    const glm::vec3 centre = middle(*placed);
    const auto at = view.project(centre);
    if (!at) return std::nullopt;
    const float reach = reach_units * app_.scale, arm = size(centre);
    if (glm::distance(px, *at) < kDot * app_.scale + 0.4f * reach) return Grip{Kind::free, 0};
    if (glm::distance(px, knob(*at)) < 1.2f * reach) return Grip{Kind::scale, 0};
    std::optional<Grip> found;
    float nearest = reach;
    const auto offer = [&](const Grip& grip, float distance) {
        if (distance < nearest) found = grip, nearest = distance;
    };
    for (int axis = 0; axis < 3; ++axis) {
        const auto from = view.project(centre + kArmBegin * arm * axis_of(axis)),
                   to = view.project(centre + arm * axis_of(axis));
        // An arm that points to the viewer can't be dragged along.
        if (from && to && glm::distance(*from, *to) > 0.15f * kArm * app_.scale)
            offer({Kind::axis, axis}, distance_to_segment(px, *from, *to));
        const auto square = view.project(centre + kSquare * arm * (axis_of((axis + 1) % 3) + axis_of((axis + 2) % 3)));
        if (square) offer({Kind::plane, axis}, glm::distance(px, *square) - 0.4f * reach);
    }
    if (found) return found;
    for (int axis = 0; axis < 3; ++axis) {
        std::optional<glm::vec2> before;
        for (const glm::vec3& place : ring(centre, axis)) {
            const auto here = view.project(place);
            if (here && before) offer({Kind::ring, axis}, distance_to_segment(px, *before, *here));
            before = here;
        }
    }
    return found;
}

bool Gizmo::pointer(const Pointer& mouse) {
    if (grip_held_) {
        if (app_.scene.find(mesh_) == nullptr) {
            grip_held_.reset();
            return true;
        }
        if (mouse.px != grabbed_px_) drag(mouse);
        if (!mouse.down) end();
        return true;
    }
    if (std::exchange(missed_, missed_ && mouse.down)) return true;
    const bool is_free = mouse.inside && !(mouse.down && !mouse.pressed);
    grip_ = is_free ? grip_at(mouse.px, kReach) : std::nullopt;
    if (grip_) {
        if (mouse.pressed) begin(*grip_, mouse);
        return true;
    }
    // Who misses a handle by a little wants to draw nothing.
    const bool is_near = is_free && grip_at(mouse.px, kMissed);
    missed_ = is_near && mouse.pressed;
    return is_near;
}

void Gizmo::begin(const Grip& grip, const Pointer& mouse) {
    const SceneMesh& placed = *mesh();
    mesh_ = placed.id;
    before_ = placed.placement;
    const render::Box box = placed.placed_box();
    middle_ = box.center();
    foot_ = {middle_.x, box.min.y, middle_.z};
    grabbed_px_ = mouse.px;
    angle_ = last_angle_ = 0.0f;
    const Ray ray = app_.view.ray(mouse.px);
    const render::Camera& camera = app_.view.orbit.camera;
    grabbed_ = middle_;
    if (grip.kind == Kind::axis) grabbed_ = along_line(ray, middle_, axis_of(grip.axis));
    if (grip.kind == Kind::plane) grabbed_ = meet_plane(ray, middle_, axis_of(grip.axis)).value_or(middle_);
    if (grip.kind == Kind::free) grabbed_ = meet_plane(ray, middle_, camera.eye - camera.target).value_or(middle_);
    grip_held_ = grip;
}

void Gizmo::drag(const Pointer& mouse) {
    const Ray ray = app_.view.ray(mouse.px);
    const render::Camera& camera = app_.view.orbit.camera;
    const Grip& grip = *grip_held_;
    render::Placement now = before_;
    std::optional<glm::vec3> to;
    switch (grip.kind) {
        case Kind::axis: to = along_line(ray, middle_, axis_of(grip.axis)); break;
        case Kind::plane: to = meet_plane(ray, middle_, axis_of(grip.axis)); break;
        case Kind::free: to = meet_plane(ray, middle_, camera.eye - camera.target); break;
        case Kind::ring: {
            const auto at = app_.view.project(middle_);
            if (!at) return;
            // As the mouse goes around the middle; the other way, seen from behind.
            const glm::vec2 from = grabbed_px_ - *at, here = mouse.px - *at;
            if (glm::length(from) < 1.0f || glm::length(here) < 1.0f) return;
            const float raw = -std::atan2(from.x * here.y - from.y * here.x, glm::dot(from, here));
            const float turn = 2.0f * std::numbers::pi_v<float>;
            angle_ += std::remainder(raw - last_angle_, turn);
            last_angle_ = raw;
            const bool is_behind = glm::dot(camera.eye - middle_, axis_of(grip.axis)) < 0.0f;
            float angle = is_behind ? -angle_ : angle_;
            const float step = glm::radians(kTurnStep_deg);
            if (mouse.shift) angle = step * std::round(angle / step);
            const glm::quat about = glm::angleAxis(angle, axis_of(grip.axis));
            now.turn = glm::normalize(about * before_.turn);
            now.at = middle_ + about * (before_.at - middle_);
            break;
        }
        case Kind::scale: {
            const auto at = app_.view.project(middle_);
            if (!at) return;
            const float from = glm::distance(grabbed_px_, *at), here = glm::distance(mouse.px, *at);
            const float factor = here / std::max(from, 1.0f);
            now.scale = std::clamp(before_.scale * factor, kLeast, kMost);
            // What it stands on stays.
            now.at = foot_ + (now.scale / before_.scale) * (before_.at - foot_);
            break;
        }
    }
    if (to) now.at = before_.at + *to - grabbed_;
    if (std::isfinite(glm::dot(now.at, now.at))) app_.scene.set_placement(*app_.scene.find(mesh_), now);
}

void Gizmo::end() {
    steps_.placed(*app_.scene.find(mesh_), before_);
    grip_held_.reset();
}

bool Gizmo::give_up() {
    if (!grip_held_) return false;
    if (SceneMesh* placed = app_.scene.find(mesh_)) app_.scene.set_placement(*placed, before_);
    grip_held_.reset();
    return true;
}

void Gizmo::overlay(ImDrawList& list) const {
    const SceneMesh* placed = mesh();
    if (!is_on_ || placed == nullptr) return;
    const View& view = app_.view;
    const glm::vec3 centre = middle(*placed);
    const auto at = view.project(centre);
    if (!at) return;
    const float unit = app_.scale, arm = size(centre);
    const std::optional<Grip>& lit = grip_held_ ? grip_held_ : grip_;
    const auto color = [&](const Grip& grip, ImU32 usual) { return lit == grip ? kHot : usual; };
    const auto line = [&](glm::vec2 a, glm::vec2 b, ImU32 tint, float width) {
        list.AddLine(im(a), im(b), kShade, (width + 2.0f) * unit);
        list.AddLine(im(a), im(b), tint, width * unit);
    };
    const auto mark = [&](const std::string& label, glm::vec2 place) { ui::mark(label, {place - 2.0f, place + 2.0f}); };
    const glm::vec3 to_eye = glm::normalize(view.orbit.camera.eye - centre);
    for (int axis = 0; axis < 3; ++axis) {
        const Grip grip{Kind::ring, axis};
        std::optional<glm::vec2> before;
        const std::vector<glm::vec3> places = ring(centre, axis);
        for (size_t i = 0; i < places.size(); ++i) {
            const auto here = view.project(places[i]);
            const bool is_near = glm::dot(places[i] - centre, to_eye) > -0.02f * arm;
            const ImU32 tint = color(grip, is_near ? kAxes[axis] : (kAxes[axis] & 0x00ffffffu) | 0x48000000u);
            if (here && before) list.AddLine(im(*before), im(*here), tint, (lit == grip ? 3.0f : 1.8f) * unit);
            if (here && i == 3 * kPieces / 8) mark(std::string("gizmo ring ") + kNames[axis], *here);
            before = here;
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        const Grip plane{Kind::plane, axis};
        const glm::vec3 u = arm * axis_of((axis + 1) % 3), v = arm * axis_of((axis + 2) % 3);
        ImVec2 corners[4];
        bool is_whole = true;
        for (int i = 0; i < 4; ++i) {
            const float a = kSquare + (i == 1 || i == 2 ? kSquareHalf : -kSquareHalf),
                        b = kSquare + (i >= 2 ? kSquareHalf : -kSquareHalf);
            const auto corner = view.project(centre + a * u + b * v);
            is_whole = is_whole && corner;
            if (corner) corners[i] = im(*corner);
        }
        if (is_whole) list.AddQuadFilled(corners[0], corners[1], corners[2], corners[3], color(plane, kAxes[axis]));
        if (const auto here = view.project(centre + kSquare * (u + v)))
            mark(std::string("gizmo plane ") + kNames[axis], *here);
        const Grip grip{Kind::axis, axis};
        const auto from = view.project(centre + kArmBegin * arm * axis_of(axis)),
                   to = view.project(centre + arm * axis_of(axis));
        if (!from || !to) continue;
        line(*from, *to, color(grip, kAxes[axis]), 3.0f);
        const glm::vec2 way = *to - *from;
        const float length = glm::length(way);
        if (length < 1.0f) continue;
        const glm::vec2 ahead = way / length * 12.0f * unit, aside = glm::vec2(-ahead.y, ahead.x) * 0.42f;
        list.AddTriangleFilled(im(*to + ahead), im(*to + aside), im(*to - aside), color(grip, kAxes[axis]));
        mark(std::string("gizmo ") + kNames[axis], glm::mix(*from, *to, 0.85f));
    }
    const Grip scale{Kind::scale, 0}, free{Kind::free, 0};
    const glm::vec2 corner = knob(*at), half(5.0f * unit);
    list.AddRectFilled(im(corner - half - 1.5f * unit), im(corner + half + 1.5f * unit), kShade);
    list.AddRectFilled(im(corner - half), im(corner + half), color(scale, kPlain));
    mark("gizmo scale", corner);
    list.AddCircleFilled(im(*at), (kDot + 1.5f) * unit, kShade, 24);
    list.AddCircleFilled(im(*at), kDot * unit, color(free, kPlain), 24);
    mark("gizmo free", *at);
}

void Gizmo::edited(const SceneMesh& placed, const render::Placement& placement) {
    if (!edited_from_) edited_from_ = placed.placement;
    app_.scene.set_placement(*app_.scene.find(placed.id), placement);
}

void Gizmo::panel() {
    const SceneMesh* placed = mesh();
    if (placed == nullptr) return;
    ui::heading("Placement");
    bool on = is_on_;
    if (ui::toggle("Handles", &on, "Shows handles in the picture that move, turn and scale the selected mesh. M."))
        is_on_ = on;
    render::Placement now = placed->placement;
    bool is_done = false;
    const float step = 0.005f * std::max(app_.scene.box().diagonal(), 1e-3f);
    if (ui::numbers("Position", &now.at, step, "%.3f", "Where the mesh stands: right, up, near, in metres."))
        edited(*placed, now);
    is_done = is_done || ui::released();
    // Angles are kept as they were typed, as long as they are those of the placement.
    if (!(degrees_of_ == placed->placement)) {
        degrees_ = glm::degrees(glm::eulerAngles(placed->placement.turn)) + 0.0f;  // no -0
        degrees_of_ = placed->placement;
    }
    if (ui::numbers("Rotation", &degrees_, 0.5f, "%.1f", "Turns about the axes right, up, near, in degrees.")) {
        const glm::vec3 middle_before = middle(*placed);
        now = placed->placement;
        now.turn = glm::normalize(glm::quat(glm::radians(degrees_)));
        now.at = middle_before - now.scale * (now.turn * placed->box.center());
        edited(*placed, now);
        degrees_of_ = now;
    }
    is_done = is_done || ui::released();
    float scale = placed->placement.scale;
    if (ui::slider("Scale", &scale, 0.05f, 20.0f, "%.3f", "How many times as large as it was made.", true)) {
        const render::Box box = placed->placed_box();
        const glm::vec3 foot(box.center().x, box.min.y, box.center().z);
        now = placed->placement;
        now.scale = std::clamp(scale, kLeast, kMost);
        now.at = foot + (now.scale / placed->placement.scale) * (now.at - foot);
        edited(*placed, now);
    }
    is_done = is_done || ui::released();
    if (is_done && edited_from_) steps_.placed(*placed, *std::exchange(edited_from_, std::nullopt));
}

}  // namespace flg::studio
