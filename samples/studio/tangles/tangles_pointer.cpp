// SPDX-License-Identifier: MIT
// The mouse over the picture: selecting, painting, and the seeds of the step that is tried.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "shell/widgets.h"
#include "tangles/tangles_workspace.h"

namespace flg::studio {
namespace {

constexpr float kReachUnits = 8.0f;    // of handles
constexpr float kBorderUnits = 14.0f;  // of borders
constexpr float kClickUnits = 4.0f;    // the mouse may move in a click
constexpr float kOffMesh = 0.01f;      // of the mesh's size: how far the step may have moved the surface
constexpr size_t kLookedAt = 4000;     // points of borders

}  // namespace

bool TanglesWorkspace::is_hidden(const Ornament& ornament, const glm::vec3& own) const {
    const glm::vec3 place = ornament.mesh()->placement.point(own);
    const auto at = app_.view.project(place);
    if (!at) return true;
    const Ray ray = app_.view.ray(*at);
    const auto hit = app_.scene.hit(ray);
    if (!hit) return false;
    const float distance = glm::distance(place, ray.origin);
    return glm::distance(hit->position(), ray.origin) < 0.99f * distance;
}

std::optional<glm::vec2> TanglesWorkspace::project(const Ornament& ornament, const glm::vec3& own) const {
    return app_.view.project(ornament.mesh()->placement.point(own));
}

std::optional<SeedPoint> TanglesWorkspace::place_under(const Ornament& ornament, const Ray& ray) const {
    const auto hit = app_.scene.hit(ray);
    if (!hit || hit->mesh->id != ornament.mesh_id()) return std::nullopt;
    return ornament.live->before.nearest(hit->own_position(), kOffMesh * hit->mesh->box.diagonal());
}

void TanglesWorkspace::pointer(const Pointer& mouse) {
    while (!waiting_clicks_.empty() && click(waiting_clicks_.front())) waiting_clicks_.pop_front();
    Ornament* ornament = active();
    if (ornament != nullptr && ornament->live && is_operator(ornament->live->recipe.action)) {
        if (edit_seeds(*ornament, mouse)) {
            hovered_.clear();
            return;
        }
    }
    if (mouse.inside && !mouse.down) {
        // Over a step that is tried the mouse is on its way to the sliders.
        const auto hit = app_.scene.hit(app_.view.ray(mouse.px));
        const Ornament* under = hit && ornament != nullptr && !ornament->live ? find(hit->mesh->id) : nullptr;
        hovered_mesh_ = hit ? hit->mesh->id : 0;
        if (under == nullptr)
            hovered_.clear();
        else if (under->idle())
            hovered_ = mouse.control ? Regions{hit->hit.region} : meant(*under, hit->hit.region);
    } else if (!mouse.inside && !hovers_row_) {
        hovered_.clear();
    }
    if (mouse.pressed) {
        pressed_px_ = mouse.px;
        pressed_on_picture_ = true;
    }
    if (!mouse.released || !pressed_on_picture_) return;
    pressed_on_picture_ = false;
    if (glm::distance(mouse.px, pressed_px_) <= kClickUnits * app_.scale)
        waiting_clicks_.push_back({app_.view.ray(mouse.px), mouse.shift, mouse.control, false});
}

bool TanglesWorkspace::click(const Click& click) {
    const auto hit = app_.scene.hit(click.ray);
    if (!hit && !app_.scene.settled()) return false;
    Ornament* tried = trying();
    if (click.adds_point && tried != nullptr) {
        SeedChoice& seeds = edited_seeds(tried->live.value());
        if (seeds.kind == SeedKind::points && add_point(*tried, seeds, click.ray)) return true;
    }
    if (!hit) {
        if (!click.shift && !paints_ && tried == nullptr) selected_.clear();
        return true;
    }
    if (tried != nullptr) later([this] { keep(); });
    if (app_.scene.active() != hit->mesh) {
        app_.scene.set_active(hit->mesh->id);
        selected_.clear();
        selected_mesh_ = hit->mesh->id;
    }
    later([this, mesh = hit->mesh->id, leaf = hit->hit.region, shift = click.shift, control = click.control] {
        const Ornament* ornament = find(mesh);
        if (ornament == nullptr || ornament != active() || leaf >= ornament->regions.count()) return;
        Regions regions = control ? Regions{leaf} : meant(*ornament, leaf);
        if (paints_) {
            paint(material_, std::move(regions));
            return;
        }
        if (!shift && !control) {
            select(std::move(regions));
            return;
        }
        // Again takes them out.
        Regions all = ornament->regions.leaves_below(selected_);
        const bool has_all = std::all_of(regions.begin(), regions.end(),
                                         [&](uint32_t r) { return std::binary_search(all.begin(), all.end(), r); });
        if (has_all)
            std::erase_if(all,
                          [&](uint32_t r) { return std::find(regions.begin(), regions.end(), r) != regions.end(); });
        else
            all.insert(all.end(), regions.begin(), regions.end());
        select(std::move(all));
    });
    return true;
}

SeedChoice& TanglesWorkspace::edited_seeds(LiveStep& live) {
    const bool has_towards = live.recipe.action == Action::contour || live.recipe.action == Action::stream;
    return edits_towards_ && has_towards ? live.recipe.towards : live.recipe.from;
}

bool TanglesWorkspace::add_point(Ornament& ornament, SeedChoice& seeds, const Ray& ray) {
    const auto place = place_under(ornament, ray);
    if (!place) return false;
    // The point that was proposed makes way for the first that is clicked.
    const LiveStep& live = *ornament.live;
    if (&seeds == &live.recipe.from && seeds.points == live.first.from.points) seeds.points.clear();
    seeds.points.push_back(*place);
    return true;
}

bool TanglesWorkspace::edit_seeds(Ornament& ornament, const Pointer& mouse) {
    SeedChoice& seeds = edited_seeds(*ornament.live);
    if (seeds.kind == SeedKind::points) return edit_points(ornament, seeds, mouse);
    if (seeds.kind == SeedKind::picked) return edit_borders(ornament, seeds, mouse);
    return false;
}

bool TanglesWorkspace::edit_points(Ornament& ornament, SeedChoice& seeds, const Pointer& mouse) {
    LiveStep& live = *ornament.live;
    if (dragged_point_) {
        if (*dragged_point_ < seeds.points.size())
            if (const auto place = place_under(ornament, app_.view.ray(mouse.px)))
                seeds.points[*dragged_point_] = *place;
        if (mouse.released || !mouse.down) dragged_point_.reset();
        return true;
    }
    hovered_point_.reset();
    if (!mouse.inside) return false;
    float nearest = kReachUnits * app_.scale;
    for (size_t i = 0; i < seeds.points.size(); ++i) {
        const auto at = project(ornament, seeds.points[i].place);
        if (!at || glm::distance(*at, mouse.px) > nearest || is_hidden(ornament, seeds.points[i].place)) continue;
        nearest = glm::distance(*at, mouse.px);
        hovered_point_ = i;
    }
    if (!mouse.pressed) return false;
    if (mouse.double_clicked) {
        later([this] { keep(); });
        return true;
    }
    if (hovered_point_) {
        // The first point of a line, clicked at its end, closes it.
        if (live.recipe.action == Action::polyline && *hovered_point_ == 0 && seeds.points.size() > 2)
            live.recipe.closed = true;
        if (mouse.control)
            delete_point();
        else
            dragged_point_ = hovered_point_;
        return true;
    }
    if (!add_point(ornament, seeds, app_.view.ray(mouse.px))) {
        if (app_.scene.settled()) return false;
        waiting_clicks_.push_back({app_.view.ray(mouse.px), mouse.shift, mouse.control, true});
        return true;
    }
    hovered_point_ = dragged_point_ = seeds.points.size() - 1;
    return true;
}

bool TanglesWorkspace::edit_borders(Ornament& ornament, SeedChoice& seeds, const Pointer& mouse) {
    hovered_grip_.reset();
    if (!mouse.inside && !mouse.released) return false;
    const std::vector<BorderLoop>& loops = ornament.live->before.outline.loops;
    size_t count = 0;
    for (const BorderLoop& loop : loops) count += loop.points.size();
    const size_t step = std::max<size_t>(1, count / kLookedAt);
    float nearest = kBorderUnits * app_.scale;
    for (uint32_t l = 0; l < loops.size(); ++l) {
        for (size_t i = 0; i < loops[l].points.size(); i += step) {
            const auto at = project(ornament, loops[l].points[i]);
            if (!at || glm::distance(*at, mouse.px) >= nearest || is_hidden(ornament, loops[l].points[i])) continue;
            nearest = glm::distance(*at, mouse.px);
            hovered_grip_ = {l, loops[l].shares[i]};
        }
    }
    if (mouse.pressed && hovered_grip_) {
        dragged_grip_ = hovered_grip_;
        pressed_px_ = mouse.px;
        return true;
    }
    if (!dragged_grip_) return hovered_grip_.has_value();
    if (!mouse.released) return true;
    const Grip from = *std::exchange(dragged_grip_, std::nullopt);
    if (glm::distance(mouse.px, pressed_px_) <= kClickUnits * app_.scale) {
        // The whole border, or none of it.
        const size_t before = seeds.stretches.size();
        std::erase_if(seeds.stretches, [&](const SeedStretch& s) { return s.loop == from.loop; });
        if (seeds.stretches.size() == before) seeds.stretches.push_back({from.loop, 0.0f, 1.0f});
        return true;
    }
    if (!hovered_grip_ || hovered_grip_->loop != from.loop) return true;
    // The shorter way from one to the other.
    float begin = from.share, end = hovered_grip_->share;
    float ahead = end - begin - std::floor(end - begin);
    if (ahead > 0.5f) {
        std::swap(begin, end);
        ahead = 1.0f - ahead;
    }
    if (ahead > 1e-3f) seeds.stretches.push_back({from.loop, std::min(begin, 0.9999f), begin + ahead});
    return true;
}

bool TanglesWorkspace::delete_point() {
    Ornament* ornament = trying();
    if (ornament == nullptr || !is_operator(ornament->live->recipe.action)) return false;
    SeedChoice& seeds = edited_seeds(*ornament->live);
    if (seeds.kind == SeedKind::picked && !seeds.stretches.empty()) {
        seeds.stretches.pop_back();
        return true;
    }
    if (seeds.kind != SeedKind::points || seeds.points.empty()) return false;
    const size_t at = std::min(hovered_point_.value_or(seeds.points.size() - 1), seeds.points.size() - 1);
    seeds.points.erase(seeds.points.begin() + static_cast<std::ptrdiff_t>(at));
    hovered_point_.reset();
    dragged_point_.reset();
    return true;
}

void TanglesWorkspace::overlay(ImDrawList& list) {
    const Ornament* ornament = active();
    if (ornament == nullptr || !ornament->live || !is_operator(ornament->live->recipe.action)) return;
    const Recipe& recipe = ornament->live->recipe;
    const float unit = app_.scale;
    const auto draw_points = [&](const SeedChoice& seeds, bool is_edited, ImU32 color) {
        if (seeds.kind != SeedKind::points) return;
        std::optional<glm::vec2> before, first;
        for (size_t i = 0; i < seeds.points.size(); ++i) {
            const auto at = project(*ornament, seeds.points[i].place);
            if (!at) continue;
            const bool hidden = is_hidden(*ornament, seeds.points[i].place);
            if (recipe.action == Action::polyline && before && !ornament->live->is_made)
                list.AddLine({before->x, before->y}, {at->x, at->y}, IM_COL32(255, 255, 255, 120), 1.0f * unit);
            before = at;
            const bool hot = is_edited && hovered_point_ == i;
            const float radius = (hot ? 7.0f : 5.0f) * unit;
            const ImU32 fade = hidden ? 0x50ffffffu : 0xffffffffu;
            list.AddCircleFilled({at->x, at->y}, radius + 1.5f * unit, IM_COL32(20, 16, 12, hidden ? 50 : 190));
            list.AddCircleFilled({at->x, at->y}, radius, (hot ? IM_COL32(255, 245, 225, 255) : color) & fade);
            const std::string name = (&seeds == &recipe.towards ? "towards point " : "point ") + std::to_string(i + 1);
            ui::mark(name, {*at - glm::vec2(radius), *at + glm::vec2(radius)});
        }
    };
    draw_points(recipe.from, !edits_towards_, IM_COL32(255, 160, 50, 255));
    draw_points(recipe.towards, edits_towards_, IM_COL32(70, 200, 230, 255));
    // Borders that are seeds.
    const std::vector<BorderLoop>& loops = ornament->live->before.outline.loops;
    const auto draw_stretch = [&](const SeedStretch& s, ImU32 color) {
        if (s.loop >= loops.size()) return;
        const BorderLoop& loop = loops[s.loop];
        const size_t n = loop.points.size(), step = std::max<size_t>(1, n / 200);
        std::optional<glm::vec2> before;
        for (size_t i = 0; i <= 2 * n; i += step) {
            const float share = loop.shares[i % n] + static_cast<float>(i / n);
            if (share < s.begin || share > s.end || is_hidden(*ornament, loop.points[i % n])) {
                before.reset();
                continue;
            }
            const auto at = project(*ornament, loop.points[i % n]);
            if (at && before) list.AddLine({before->x, before->y}, {at->x, at->y}, color, 4.0f * unit);
            before = at;
        }
    };
    if (recipe.from.kind == SeedKind::picked)
        for (const SeedStretch& s : recipe.from.stretches) draw_stretch(s, IM_COL32(255, 150, 40, 230));
    if (recipe.towards.kind == SeedKind::picked)
        for (const SeedStretch& s : recipe.towards.stretches) draw_stretch(s, IM_COL32(70, 200, 230, 230));
}

}  // namespace flg::studio
