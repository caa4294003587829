// SPDX-License-Identifier: MIT
// Drags the points of the selected part's contour. Neighbours follow softly; with Shift a point moves alone. A double
// click on the line adds a point.
#pragma once

#include <optional>

#include "skeletons/contour_edits.h"
#include "skeletons/part_picking.h"

struct ImDrawList;

namespace flg::studio {

class PointsTool {
public:
    explicit PointsTool(Editor& editor) : editor_(editor) {}

    // How far along the line points follow the one that is dragged, as a share of the part's size.
    float reach = 0.15f;

    void pointer(const Pointer& mouse);
    void overlay(ImDrawList& list) const;
    void drop() { is_dragging_ = false; }
    void leave() { chosen_.reset(), hovered_.reset(), drop(); }
    bool is_dragging() const { return is_dragging_; }

    // Of the selected part; none once its contour has other points.
    std::optional<ContourPoint> chosen() const;
    // Throws StudioError where the line would have less than three points.
    void remove_chosen();

private:
    // On the selected part's line, or its mirror image's.
    struct Hit {
        ContourPoint point;            // the nearest one, or that before `at`
        std::optional<glm::dvec2> at;  // between two points, in the part's drawing; none: on the point
        bool is_image = false;
    };
    std::optional<Hit> point_at(const DrawnPart& part, glm::vec2 px) const;
    std::optional<Hit> edge_at(const DrawnPart& part, glm::vec2 px) const;
    void press(const Pointer& mouse);
    void drag(const Pointer& mouse);
    void insert(const DrawnPart& part, const Hit& hit);
    double reach_of(const DrawnPart& part) const;
    double spacing_of(const DrawnPart& part) const;

    Editor& editor_;
    std::optional<Hit> hovered_;
    std::optional<ContourPoint> chosen_;
    uint32_t chosen_of_ = 0;  // the part
    bool is_dragging_ = false, is_moved_ = false, is_alone_ = false;
    // When it was grabbed:
    glm::vec2 grab_px_{0.0f}, last_px_{0.0f};
    ContourPtr before_;
    Hit grabbed_{};
};

}  // namespace flg::studio
