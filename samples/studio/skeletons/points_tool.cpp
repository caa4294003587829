// SPDX-License-Identifier: MIT
#include "skeletons/points_tool.h"

#include <imgui.h>

#include <algorithm>
#include <limits>

#include "shell/widgets.h"
#include "skeletons/ink.h"

namespace flg::studio {
namespace {

// Units of the layout.
constexpr float kPointReach = 9.0f, kPointDot = 2.6f, kPointGap = 5.0f;
constexpr float kPointStart = 3.0f;    // so far the mouse may go without moving the point
constexpr float kPointSpacing = 4.0f;  // of points that are drawn by hand
constexpr double kOffEnds = 0.25;      // of an edge: new points keep this distance from its ends
constexpr size_t kFewestPoints = 3;    // points of a ring

double diagonal_of(const Contour& contour) {
    glm::dvec2 low = contour.rings[0][0], high = low;
    for (const glm::dvec2& p : contour.rings[0]) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    return glm::distance(low, high);
}

// Calls `see(is_image, ring, index, px)` for all points of the part and its image that are in front of the eye.
template <class See>
void each_point(const Editor& editor, const DrawnPart& part, See see) {
    const glm::dmat4 matrix = part.matrix();
    for (const bool is_image : {false, true}) {
        if (is_image && !part.mirrored) continue;
        for (uint32_t r = 0; r < part.contour->rings.size(); ++r) {
            const Ring& ring = part.contour->rings[r];
            for (uint32_t i = 0; i < ring.size(); ++i) {
                glm::dvec3 at(matrix * glm::dvec4(ring[i], 0.0, 1.0));
                if (is_image) at = mirrored(editor.drawing().mirror, at);
                if (const auto px = editor.app.view.project(glm::vec3(at))) see(is_image, ContourPoint{r, i}, *px);
            }
        }
    }
}

}  // namespace

std::optional<PointsTool::Hit> PointsTool::point_at(const DrawnPart& part, glm::vec2 px) const {
    std::optional<Hit> found;
    float nearest = kPointReach * editor_.app.scale;
    each_point(editor_, part, [&](bool is_image, ContourPoint point, glm::vec2 at) {
        const float distance = glm::distance(at, px);
        if (distance >= nearest) return;
        nearest = distance;
        found = Hit{point, std::nullopt, is_image};
    });
    return found;
}

std::optional<PointsTool::Hit> PointsTool::edge_at(const DrawnPart& part, glm::vec2 px) const {
    std::optional<Hit> found;
    double nearest = std::numeric_limits<double>::infinity();
    for (const bool is_image : {false, true}) {
        if (is_image && !part.mirrored) continue;
        const auto at = meet_part(editor_.app.view, part, px, is_image ? &editor_.drawing().mirror : nullptr);
        if (!at) continue;
        for (uint32_t r = 0; r < part.contour->rings.size(); ++r) {
            const Ring& ring = part.contour->rings[r];
            for (uint32_t i = 0; i < ring.size(); ++i) {
                const glm::dvec2 a = ring[i], along = ring[(i + 1) % ring.size()] - a;
                const double length_sq = glm::dot(along, along);
                if (!(length_sq > 0.0)) continue;
                const double share = glm::dot(*at - a, along) / length_sq;
                const double distance = glm::distance(*at, a + glm::clamp(share, 0.0, 1.0) * along);
                if (distance >= nearest) continue;
                nearest = distance;
                found = Hit{{r, i}, a + glm::clamp(share, kOffEnds, 1.0 - kOffEnds) * along, is_image};
            }
        }
    }
    const double near = spacing_of(part) * static_cast<double>(kPointReach / kPointSpacing);
    return nearest < near ? found : std::nullopt;
}

std::optional<ContourPoint> PointsTool::chosen() const {
    const DrawnPart* part = editor_.selected();
    if (part == nullptr || !chosen_ || chosen_of_ != part->id || chosen_->ring >= part->contour->rings.size())
        return std::nullopt;
    return chosen_->index < part->contour->rings[chosen_->ring].size() ? chosen_ : std::nullopt;
}

double PointsTool::reach_of(const DrawnPart& part) const {
    return static_cast<double>(reach) * diagonal_of(*part.contour);
}

// What a hand would draw here, in the part's drawing.
double PointsTool::spacing_of(const DrawnPart& part) const {
    const float metres = editor_.app.scale * editor_.app.view.metres_per_px(glm::vec3(part.centre()));
    return static_cast<double>(kPointSpacing * metres) / part.scale;
}

void PointsTool::pointer(const Pointer& mouse) {
    const DrawnPart* part = editor_.selected();
    if (!is_dragging_) {
        hovered_.reset();
        if (part != nullptr && part->visible && mouse.inside) hovered_ = point_at(*part, mouse.px);
        if (part != nullptr && part->visible && mouse.inside && !hovered_) hovered_ = edge_at(*part, mouse.px);
    }
    if (mouse.pressed && mouse.inside) press(mouse);
    if (!is_dragging_) return;
    if (editor_.selected() == nullptr || chosen_of_ != editor_.selected_id()) return drop();
    drag(mouse);
    if (!mouse.down) {
        editor_.commit();
        drop();
    }
}

void PointsTool::press(const Pointer& mouse) {
    editor_.commit();
    const DrawnPart* part = editor_.selected();
    if (!hovered_) {
        const auto hit = pick_part(editor_, mouse.px);
        chosen_.reset();
        return editor_.select(hit ? hit->id : 0);
    }
    chosen_of_ = part->id;
    if (mouse.double_clicked) {
        if (const auto edge = edge_at(*part, mouse.px)) insert(*part, *edge);
        return;
    }
    if (hovered_->at) return chosen_.reset();
    chosen_ = hovered_->point;
    grabbed_ = *hovered_;
    is_dragging_ = true;
    is_moved_ = false;
    is_alone_ = mouse.shift;
    grab_px_ = last_px_ = mouse.px;
    before_ = part->contour;
}

void PointsTool::drag(const Pointer& mouse) {
    is_moved_ = is_moved_ || glm::distance(mouse.px, grab_px_) > kPointStart * editor_.app.scale;
    // Each change makes new bones: only where there is one.
    if (!is_moved_ || mouse.px == last_px_) return;
    last_px_ = mouse.px;
    DrawnPart part = *editor_.selected();
    part.contour = before_;
    const glm::vec4* mirror = grabbed_.is_image ? &editor_.drawing().mirror : nullptr;
    const auto from = meet_part(editor_.app.view, part, grab_px_, mirror),
               to = meet_part(editor_.app.view, part, mouse.px, mirror);
    if (!from || !to) return;
    auto contour = std::make_shared<Contour>(
        with_point_moved(*before_, grabbed_.point, *to - *from, is_alone_ ? 0.0 : reach_of(part)));
    const Ring& old = before_->rings[grabbed_.point.ring];
    Ring& ring = contour->rings[grabbed_.point.ring];
    for (size_t i = 0; i < ring.size(); ++i)
        if (ring[i] != old[i]) ring[i] = rounded(ring[i], spacing_of(part));
    editor_.change_selected("points").contour = std::move(contour);
}

void PointsTool::insert(const DrawnPart& part, const Hit& hit) {
    auto contour =
        std::make_shared<Contour>(with_point_after(*part.contour, hit.point, rounded(*hit.at, spacing_of(part))));
    editor_.change_selected("add a point").contour = std::move(contour);
    editor_.commit();
    chosen_ = ContourPoint{hit.point.ring, hit.point.index + 1};
}

void PointsTool::remove_chosen() {
    const auto point = chosen();
    if (!point) return;
    const Contour& contour = *editor_.selected()->contour;
    if (contour.rings[point->ring].size() <= kFewestPoints) throw StudioError("A line needs at least three points.");
    auto smaller = std::make_shared<Contour>(without_point(contour, *point));
    editor_.commit();
    editor_.change_selected("remove a point").contour = std::move(smaller);
    editor_.commit();
    chosen_.reset(), hovered_.reset();
}

void PointsTool::overlay(ImDrawList& list) const {
    const DrawnPart* part = editor_.selected();
    if (part == nullptr || !part->visible) return;
    const float unit = editor_.app.scale;
    const auto lit = is_dragging_ ? std::optional(grabbed_) : hovered_;
    const auto bright = chosen();
    // Those that follow are larger, so that it is seen how many do.
    std::vector<double> shares;
    if (lit && !lit->at && lit->point.ring < part->contour->rings.size()) {
        const Ring& ring = (is_dragging_ ? *before_ : *part->contour).rings[lit->point.ring];
        shares = follow_shares(ring, lit->point.index, is_dragging_ && is_alone_ ? 0.0 : reach_of(*part));
    }
    // Where points are denser than can be told apart, not all are drawn; all can be grabbed.
    glm::vec2 last(std::numeric_limits<float>::lowest());
    each_point(editor_, *part, [&](bool is_image, ContourPoint point, glm::vec2 at) {
        const bool is_chosen = bright == point;
        const bool is_lit = lit && !lit->at && lit->point == point && lit->is_image == is_image;
        const bool is_of_lit = lit && !lit->at && lit->point.ring == point.ring && lit->is_image == is_image;
        const float share = is_of_lit && point.index < shares.size() ? static_cast<float>(shares[point.index]) : 0.0f;
        if (!is_chosen && !is_lit && share == 0.0f && glm::distance(at, last) < kPointGap * unit) return;
        last = at;
        const float radius = (is_lit || is_chosen ? 2.0f : 1.0f + 0.6f * share) * kPointDot * unit;
        const ImU32 color = is_lit ? ink::kHover : is_chosen || share > 0.0f ? ink::kChosen : ink::kLine;
        list.AddCircleFilled({at.x, at.y}, radius + 1.2f * unit, ink::kShade);
        list.AddCircleFilled({at.x, at.y}, radius, color);
        const glm::vec2 half(kPointReach * unit);
        if (is_chosen && !is_image) ui::mark("chosen point", {at - half, at + half});
    });
}

}  // namespace flg::studio
