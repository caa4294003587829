// SPDX-License-Identifier: MIT
#include "skeletons/pull_tool.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "shell/widgets.h"
#include "skeletons/ink.h"

namespace flg::studio {
namespace {

// Units of the layout.
constexpr float kPinReach = 10.0f, kPinRadius = 5.0f;
constexpr float kPullStart = 3.0f;     // so far the mouse may go and it is still a click
constexpr double kKeySeconds = 0.05;   // between keys
constexpr double kPauseSeconds = 0.5;  // at the end of a record, before it begins again

}  // namespace

std::span<const float> PullTool::positions() const {
    if (!solver_.positions().empty()) return solver_.positions();
    if (!posed_.empty()) return posed_;
    const FlgSkinView& view = editor_.live.skin()->view;
    return {view.positions, size_t{3} * view.vertex_count};
}

void PullTool::update(std::vector<float> posed) {
    posed_ = posed;
    const Pulls& pulls = editor_.drawing().pulls;
    if (plays_ && pulls.record) {
        double seconds = editor_.app.seconds - play_from_;
        if (seconds > static_cast<double>(pulls.record->length()) + kPauseSeconds) {
            play_from_ = editor_.app.seconds;
            seconds = 0.0;
            solver_.restart();
        }
        shown_ = pulls.record->at(static_cast<float>(seconds));
    } else {
        plays_ = false;
        shown_ = pulls.pins;
    }
    solver_.update(editor_.live, editor_.drawing(), shown_, std::move(posed));
}

void PullTool::leave() {
    drop();
    hovered_.reset();
    plays_ = records = false;
    solver_.clear();
}

void PullTool::play(bool on) {
    plays_ = on && editor_.drawing().pulls.record != nullptr;
    play_from_ = editor_.app.seconds;
    solver_.restart();
}

void PullTool::release_all() {
    editor_.commit();
    editor_.change("pins").pulls.pins.clear();
    editor_.commit();
}

void PullTool::forget_record() {
    editor_.commit();
    editor_.change("record").pulls.record.reset();
    editor_.commit();
    plays_ = false;
}

std::optional<size_t> PullTool::pin_at(glm::vec2 px) const {
    const auto& pins = editor_.drawing().pulls.pins;
    std::optional<size_t> found;
    float nearest = kPinReach * editor_.app.scale;
    for (size_t p = 0; p < pins.size(); ++p) {
        const auto place = position_of(editor_.drawing(), pins[p].place);
        if (!place) continue;
        const auto at = editor_.app.view.project(glm::vec3(*place) + pins[p].by);
        if (!at || glm::distance(*at, px) >= nearest) continue;
        nearest = glm::distance(*at, px);
        found = p;
    }
    return found;
}

void PullTool::pointer(const Pointer& mouse) {
    // The body that is pulled must be that of the drawing.
    if (editor_.live.skin() == nullptr || editor_.live.busy()) return drop();
    if (plays_ && mouse.pressed && mouse.inside) play(false);
    if (plays_) return;
    if (!dragged_) hovered_ = mouse.inside ? pin_at(mouse.px) : std::nullopt;
    if (mouse.pressed && mouse.inside) press(mouse);
    if (!dragged_) return;
    if (*dragged_ >= editor_.drawing().pulls.pins.size()) return drop();
    drag(mouse);
    if (!mouse.down) release();
}

void PullTool::press(const Pointer& mouse) {
    editor_.commit();
    const LiveModel::Skinned& skin = *editor_.live.skin();
    grab_px_ = mouse.px;
    grab_seconds_ = editor_.app.seconds;
    last_key_ = -1.0;
    is_moved_ = false;
    is_new_ = !hovered_;
    if (hovered_) {
        dragged_ = hovered_;
        const PullPin& pin = editor_.drawing().pulls.pins[*dragged_];
        grab_at_ = glm::vec3(*position_of(editor_.drawing(), pin.place)) + pin.by;
    } else {
        const auto hit = pick_skin(skin.view, positions(), editor_.app.view.ray(mouse.px));
        if (!hit) return;
        if (editor_.drawing().pulls.pins.size() == FLG_PULL_MAX_HANDLES)
            throw StudioError("A body has at most 256 pins. Click some to take them away.");
        const uint32_t* corners = skin.view.triangles + 3 * size_t{hit->triangle};
        const glm::vec3& shares = hit->shares;
        const uint32_t vertex = corners[shares.x >= shares.y && shares.x >= shares.z ? 0
                                        : shares.y >= shares.z                       ? 1
                                                                                     : 2];
        const glm::vec3 rest = glm::make_vec3(skin.view.positions + 3 * size_t{vertex});
        grab_at_ = glm::make_vec3(positions().data() + 3 * size_t{vertex});
        PullPin pin{place_on(editor_.drawing(), skin, skin.view.vertex_parts[vertex], rest), grab_at_ - rest};
        if (pin.place.part.empty()) return;
        editor_.change("pull").pulls.pins.push_back(std::move(pin));
        dragged_ = editor_.drawing().pulls.pins.size() - 1;
    }
    grab_by_ = editor_.drawing().pulls.pins[*dragged_].by;
    if (!records) return;
    const auto& record = editor_.drawing().pulls.record;
    taken_ = record ? *record : PullRecord{};
    taken_from_ = taken_->keys.empty() ? 0.0f : taken_->length() + static_cast<float>(kKeySeconds);
}

void PullTool::drag(const Pointer& mouse) {
    const View& view = editor_.app.view;
    is_moved_ = is_moved_ || glm::distance(mouse.px, grab_px_) > kPullStart * editor_.app.scale;
    if (!is_moved_) return;
    const glm::vec3 sight = glm::normalize(view.orbit.camera.target - view.orbit.camera.eye);
    const auto from = meet_plane(view.ray(grab_px_), grab_at_, sight),
               to = meet_plane(view.ray(mouse.px), grab_at_, sight);
    if (from && to) editor_.change("pull").pulls.pins[*dragged_].by = grab_by_ + *to - *from;
    const double seconds = editor_.app.seconds - grab_seconds_;
    if (!taken_ || (seconds < last_key_ + kKeySeconds && mouse.down)) return;
    last_key_ = seconds;
    taken_->add(taken_from_ + static_cast<float>(seconds), editor_.drawing().pulls.pins);
}

void PullTool::release() {
    // A click on a pin takes it away.
    if (!is_moved_ && !is_new_) {
        auto& pins = editor_.change("pull").pulls.pins;
        pins.erase(pins.begin() + static_cast<std::ptrdiff_t>(*dragged_));
        hovered_.reset();
    }
    if (taken_ && is_moved_)
        editor_.change("pull").pulls.record = std::make_shared<const PullRecord>(std::move(*taken_));
    editor_.commit();
    drop();
}

void PullTool::overlay(ImDrawList& list) const {
    if (editor_.live.skin() == nullptr || editor_.live.busy()) return;
    const float unit = editor_.app.scale;
    for (size_t p = 0; p < shown_.size(); ++p) {
        const auto place = position_of(editor_.drawing(), shown_[p].place);
        if (!place) continue;
        const auto at = editor_.app.view.project(glm::vec3(*place) + shown_[p].by);
        if (!at) continue;
        const bool is_lit = !plays_ && (dragged_ == p || (!dragged_ && hovered_ == p));
        ink::knob(list, *at, kPinRadius, ink::kChosen, is_lit, unit);
        const glm::vec2 half(kPinReach * unit);
        ui::mark("pin " + std::to_string(p + 1), {*at - half, *at + half});
        if (is_lit && !dragged_)
            ink::label(list, *at + glm::vec2(14.0f, -8.0f) * unit, "Drag to pull. Click to let go.", unit);
    }
}

}  // namespace flg::studio
