// SPDX-License-Identifier: MIT
#include "tangles/highlight.h"

#include <algorithm>

namespace flg::studio {

void Highlight::show(std::span<const BorderLoop> loops, float lift, const render::Placement& placement, float scale) {
    points_.clear();
    normals_.clear();
    offsets_ = {0};
    flags_.clear();
    for (const BorderLoop& loop : loops) {
        for (size_t i = 0; i < loop.points.size(); ++i) {
            points_.push_back(placement.point(loop.points[i] + lift * loop.normals[i]));
            normals_.push_back(placement.direction(loop.normals[i]));
        }
        offsets_.push_back(static_cast<uint32_t>(points_.size()));
        flags_.push_back(FLG_CURVE_CLOSED);
    }
    upload(scale);
}

void Highlight::upload(float scale) {
    if (points_.empty()) {
        clear();
        return;
    }
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, &points_[0].x, 0, 0},
                                 {FLG_ATTRIBUTE_NORMAL, 3, &normals_[0].x, 0, 0}};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(flags_.size());
    view.curve_offsets = offsets_.data();
    view.curve_flags = flags_.data();
    view.columns = columns;
    view.column_count = 2;
    render::CurveLook look;
    look.shape = render::Shape::line;
    look.color = look.color_end = color_;
    look.line_width_px = std::clamp(width_ * scale, 0.5f, 64.0f);
    look.casts_shadow = false;
    if (drawn_.value == 0)
        drawn_ = renderer_.upload(view, look);
    else
        renderer_.update(drawn_, view, look);
}

void Highlight::clear() {
    if (drawn_.value != 0) renderer_.remove(drawn_);
    drawn_ = {};
}

}  // namespace flg::studio
