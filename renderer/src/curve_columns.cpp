// SPDX-License-Identifier: MIT
#include "curve_columns.h"

#include "vk.h"

namespace flg::render {
namespace {

std::span<const FlgColumn> columns_of(const FlgCurveSetView& view) {
    return {view.columns, view.column_count};
}

}  // namespace

void check_view(const FlgCurveSetView& view) {
    if (view.curve_count == 0) return;
    if (!view.curve_offsets) fail("The view has %u curves but no curve_offsets.", view.curve_count);
    if (view.curve_offsets[0] != 0) fail("curve_offsets begins with %u instead of 0.", view.curve_offsets[0]);
    for (uint32_t c = 0; c < view.curve_count; ++c)
        if (view.curve_offsets[c + 1] < view.curve_offsets[c])
            fail("curve_offsets falls from %u to %u after curve %u.", view.curve_offsets[c], view.curve_offsets[c + 1],
                 c);
    if (view.column_count == 0 || !view.columns) fail("The view has no columns.");
}

void check_look(const CurveLook& look) {
    check_in(look.radius, 0.0f, largest_coordinate, "radius");
    check_in(look.radius_scale, 0.0f, largest_coordinate, "radius_scale");
    check_in(static_cast<float>(look.sides), 3.0f, 32.0f, "sides");
    check_in(look.line_width_px, 0.5f, 64.0f, "line_width_px");
    check_in(look.gloss, 0.0f, 1.0f, "gloss");
    check_color(look.color, "color");
    check_color(look.color_end, "color_end");
}

CurveColumns::CurveColumns(const FlgCurveSetView& view)
    : position_(find_column(columns_of(view), FLG_ATTRIBUTE_POSITION, 3, "POSITION")),
      radius_(find_column(columns_of(view), FLG_ATTRIBUTE_RADIUS, 1, "RADIUS")),
      color_(find_column(columns_of(view), FLG_ATTRIBUTE_COLOR, 4, "COLOR")),
      normal_(find_column(columns_of(view), FLG_ATTRIBUTE_NORMAL, 3, "NORMAL")),
      displacement_(find_column(columns_of(view), FLG_ATTRIBUTE_DISPLACEMENT, 3, "DISPLACEMENT")) {
    if (!position_) fail("The view has no POSITION column.");
}

glm::vec3 CurveColumns::position(uint32_t point) const {
    const auto p = position_.at<glm::vec3>(point);
    if (!is_usable(p))
        fail("Point %u is at (%g, %g, %g); positions must be finite, at most 1e30.", point, p.x, p.y, p.z);
    return p;
}

void CurveColumns::check(uint32_t point) const {
    if (radius_) {
        const auto radius = radius_.at<float>(point);
        if (!(radius >= 0.0f && radius <= largest_coordinate))
            fail("Point %u has the radius %g; it must be in 0 to 1e30.", point, radius);
    }
    if (normal_ && !is_usable(normal(point))) fail("Point %u has a normal that is not finite.", point);
    if (color_ && !is_usable(color_.at<glm::vec3>(point))) fail("Point %u has a colour that is not finite.", point);
    if (displacement_ && !is_usable(displacement(point)))
        fail("Point %u has a displacement that is not finite, or longer than 1e30.", point);
}

}  // namespace flg::render
