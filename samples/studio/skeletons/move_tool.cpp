// SPDX-License-Identifier: MIT
#include "skeletons/move_tool.h"

#include <imgui.h>

#include <cmath>

#include "shell/widgets.h"
#include "skeletons/ink.h"

namespace flg::studio {
namespace {

// Units of the layout.
constexpr float kRing = 64.0f, kKnob = 7.0f, kReach = 11.0f;
// Places on the ring, from its centre: to the upper right, lower right, and below.
constexpr glm::vec2 kTurnAt{0.7071f, -0.7071f}, kSizeAt{0.7071f, 0.7071f}, kDepthAt{0.0f, 1.0f};
constexpr double kMinSize = 0.02, kMaxSize = 50.0;

double angle_of(glm::vec2 px) {
    return std::atan2(-static_cast<double>(px.y), static_cast<double>(px.x));
}

}  // namespace

std::optional<MoveTool::Knobs> MoveTool::knobs() const {
    const DrawnPart* part = editor_.selected();
    if (part == nullptr || !part->visible) return std::nullopt;
    const auto centre = editor_.app.view.project(glm::vec3(part->centre()));
    if (!centre) return std::nullopt;
    const float radius = kRing * editor_.app.scale;
    return Knobs{*centre, *centre + radius * kTurnAt, *centre + radius * kSizeAt, *centre + radius * kDepthAt, radius};
}

MoveTool::Knob MoveTool::knob_at(glm::vec2 px) const {
    const auto around = knobs();
    if (!around) return Knob::none;
    const float reach = kReach * editor_.app.scale;
    if (glm::distance(px, around->turn) < reach) return Knob::turn;
    if (glm::distance(px, around->size) < reach) return Knob::size;
    if (glm::distance(px, around->depth) < reach) return Knob::depth;
    if (glm::distance(px, around->centre) < reach) return Knob::part;
    return Knob::none;
}

void MoveTool::pointer(const Pointer& mouse) {
    if (drag_ == Knob::none) {
        hovered_ = mouse.inside ? knob_at(mouse.px) : Knob::none;
        const bool is_fresh = is_fresh_ && hover_px_ == mouse.px && hover_revision_ == editor_.live.skin_revision();
        if (!mouse.inside || hovered_ != Knob::none) {
            hovered_part_ = 0;
            is_fresh_ = false;
        } else if (!is_fresh) {
            const auto hit = pick_part(editor_, mouse.px);
            hovered_part_ = hit ? hit->id : 0;
            hover_px_ = mouse.px;
            hover_revision_ = editor_.live.skin_revision();
            is_fresh_ = true;
        }
    }
    if (mouse.pressed && mouse.inside) grab(mouse);
    if (drag_ == Knob::none) return;
    if (editor_.drawing().find(before_.id) == nullptr || editor_.selected_id() != before_.id) return drop();
    if (mouse.px != grab_px_ || editor_.is_acting()) drag(mouse);
    if (!mouse.down) {
        editor_.commit();
        drop();
    }
}

void MoveTool::grab(const Pointer& mouse) {
    editor_.commit();
    drag_ = knob_at(mouse.px);
    is_image_ = false;
    grab_px_ = mouse.px;
    if (drag_ != Knob::none) {
        grab_at_ = glm::vec3(editor_.selected()->centre());
    } else {
        const auto hit = pick_part(editor_, mouse.px);
        editor_.select(hit ? hit->id : 0);
        if (!hit) return;
        drag_ = Knob::part;
        is_image_ = hit->is_image;
        grab_at_ = hit->position;
    }
    before_ = *editor_.selected();
    const auto centre = knobs();
    centre_px_ = centre ? centre->centre : mouse.px;
    if (drag_ == Knob::part && mouse.shift) drag_ = Knob::depth;
}

glm::dvec3 MoveTool::moved_in_view(glm::vec2 px) const {
    constexpr float kFromFront = 0.9f;  // sights as near to z as this move parts in their plane
    const View& view = editor_.app.view;
    const glm::vec3 sight = glm::normalize(view.orbit.camera.target - view.orbit.camera.eye);
    const glm::vec3 normal = std::abs(sight.z) > kFromFront ? glm::vec3(0, 0, 1) : sight;
    const auto from = meet_plane(view.ray(grab_px_), grab_at_, normal), to = meet_plane(view.ray(px), grab_at_, normal);
    if (!from || !to) return glm::dvec3(0.0);
    return glm::dvec3(*to - *from);
}

double MoveTool::moved_in_depth(glm::vec2 px) const {
    constexpr float kMinSeen = 0.3f;  // of a length across the view
    const View& view = editor_.app.view;
    const float metres = view.metres_per_px(grab_at_);
    const glm::vec2 moved = px - grab_px_;
    const auto here = view.project(grab_at_), nearer = view.project(grab_at_ + glm::vec3(0, 0, 10.0f * metres));
    if (here && nearer) {
        const glm::vec2 axis = (*nearer - *here) / 10.0f;  // pixels to a pixel's worth of metres
        if (glm::length(axis) > kMinSeen)
            return static_cast<double>(metres * glm::dot(moved, axis) / glm::dot(axis, axis));
    }
    // Seen along it: down is nearer.
    return static_cast<double>(metres * moved.y);
}

void MoveTool::drag(const Pointer& mouse) {
    DrawnPart& part = editor_.change_selected("move");
    const double side = is_image_ ? -1.0 : 1.0;
    if (drag_ == Knob::part) {
        glm::dvec3 moved = moved_in_view(mouse.px);
        if (is_image_)
            moved = mirrored(editor_.drawing().mirror, moved) - mirrored(editor_.drawing().mirror, glm::dvec3(0.0));
        part.at = before_.at + moved;
    } else if (drag_ == Knob::depth) {
        part.at = before_.at + glm::dvec3(0.0, 0.0, side * moved_in_depth(mouse.px));
    } else if (drag_ == Knob::turn) {
        const glm::vec3 sight = editor_.app.view.orbit.camera.target - editor_.app.view.orbit.camera.eye;
        double turned = angle_of(mouse.px - centre_px_) - angle_of(grab_px_ - centre_px_);
        if (sight.z > 0.0f) turned = -turned;
        glm::dvec3 turn = before_.turn;
        turn.z = std::remainder(turn.z + glm::degrees(turned), 360.0);
        if (mouse.shift) turn.z = std::round(turn.z / 15.0) * 15.0;
        part.at = before_.at, part.turn = before_.turn;
        part.place(turn, before_.scale);
    } else {
        const double from = static_cast<double>(glm::distance(grab_px_, centre_px_));
        const double share = from > 0.0 ? static_cast<double>(glm::distance(mouse.px, centre_px_)) / from : 1.0;
        part.at = before_.at, part.scale = before_.scale;
        part.place(before_.turn, glm::clamp(before_.scale * share, kMinSize, kMaxSize));
    }
}

void MoveTool::overlay(ImDrawList& list) const {
    const float unit = editor_.app.scale;
    const auto around = knobs();
    if (!around) return;
    const Knob lit = drag_ != Knob::none ? drag_ : hovered_;
    list.AddCircle({around->centre.x, around->centre.y}, around->radius, ink::kShade, 64, 3.5f * unit);
    list.AddCircle({around->centre.x, around->centre.y}, around->radius, ink::kLine, 64, 1.5f * unit);
    struct Shown {
        Knob knob;
        glm::vec2 at;
        ImU32 color;
        const char* name;
        const char* what;
    };
    const Shown all[] = {
        {Knob::part, around->centre, ink::kChosen, "move part", "Drag to move. Shift-drag moves nearer or farther."},
        {Knob::turn, around->turn, IM_COL32(60, 140, 200, 255), "turn part",
         "Drag to turn. Shift snaps to 15 degrees."},
        {Knob::size, around->size, IM_COL32(90, 160, 70, 255), "size part", "Drag to resize."},
        {Knob::depth, around->depth, IM_COL32(150, 90, 170, 255), "depth part",
         "Drag to change the depth. Down is nearer to you."}};
    for (const Shown& shown : all) {
        const bool is_lit = lit == shown.knob;
        ink::knob(list, shown.at, kKnob, shown.color, is_lit, unit);
        const glm::vec2 half(kKnob * unit);
        ui::mark(shown.name, {shown.at - half, shown.at + half});
        if (is_lit && drag_ == Knob::none)
            ink::label(list, shown.at + glm::vec2(16.0f, -8.0f) * unit, shown.what, unit);
    }
}

}  // namespace flg::studio
