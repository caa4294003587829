// SPDX-License-Identifier: MIT
#include "io/checked_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "io/failure.h"
#include "io/limits.h"

namespace flg::io {

namespace {

constexpr uint32_t most_columns = 16;
constexpr uint32_t most_components = 16;

struct ColumnRule {
    FlgAttribute attribute;
    uint32_t components;
};
constexpr ColumnRule rules[] = {
    {FLG_ATTRIBUTE_POSITION, 3}, {FLG_ATTRIBUTE_RADIUS, 1},       {FLG_ATTRIBUTE_COLOR, 4},
    {FLG_ATTRIBUTE_TANGENT, 3},  {FLG_ATTRIBUTE_NORMAL, 3},       {FLG_ATTRIBUTE_TIME, 1},
    {FLG_ATTRIBUTE_PRESSURE, 1}, {FLG_ATTRIBUTE_ORIENTATION, 4},  {FLG_ATTRIBUTE_STYLE_INDEX, 1},
    {FLG_ATTRIBUTE_RADII, 3},    {FLG_ATTRIBUTE_ANGLE, 1},        {FLG_ATTRIBUTE_WIDTH, 1},
    {FLG_ATTRIBUTE_SPEED, 1},    {FLG_ATTRIBUTE_DISPLACEMENT, 3},
};

}  // namespace

CheckedView::CheckedView(const FlgCurveSetView* view) {
    if (!view) fail(FLG_ERROR_INVALID_ARGUMENT, "view", "is null");
    if (view->struct_size < sizeof(FlgCurveSetView)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.struct_size", "is %u; FlgCurveSetView has %zu bytes", view->struct_size,
             sizeof(FlgCurveSetView));
    }
    std::memcpy(&view_, view, sizeof view_);
    check_curves();
    if (view_.column_count < 1 || view_.column_count > most_columns) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.column_count", "is %u, must be 1 to %u", view_.column_count,
             most_columns);
    }
    if (!view_.columns) fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns", "is null");
    for (uint32_t i = 0; i < view_.column_count; ++i) {
        check_column(i);
        const FlgColumn& column = view_.columns[i];
        const size_t packed = column.components * sizeof(float);
        const Column resolved{column.data, column.stride == 0 ? packed : column.stride};
        Column* slot = nullptr;
        if (column.attribute == FLG_ATTRIBUTE_POSITION) slot = &position;
        if (column.attribute == FLG_ATTRIBUTE_RADIUS) slot = &radius;
        if (column.attribute == FLG_ATTRIBUTE_COLOR) slot = &color;
        if (column.attribute == FLG_ATTRIBUTE_NORMAL) slot = &normal;
        if (slot) *slot = resolved;
    }
    if (!position) fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns", "has no FLG_ATTRIBUTE_POSITION");
}

void CheckedView::check_curves() const {
    if (view_.curve_count == 0) fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_count", "is 0: there is nothing to write");
    if (!view_.curve_offsets) fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets", "is null");
    if (view_.curve_offsets[0] != 0) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[0]", "is %u, must be 0", view_.curve_offsets[0]);
    }
    for (uint32_t c = 0; c < view_.curve_count; ++c) {
        if (view_.curve_offsets[c + 1] <= view_.curve_offsets[c]) {
            fail(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[" + std::to_string(c + 1) + "]",
                 "is %u, not above %u: every curve needs a point", view_.curve_offsets[c + 1], view_.curve_offsets[c]);
        }
    }
    if (point_count() > max_points) {
        fail(FLG_ERROR_LIMIT, "view", "has %zu points, more than the limit of 2^31", point_count());
    }
}

void CheckedView::check_column(uint32_t index) const {
    const FlgColumn& column = view_.columns[index];
    const std::string place = "view.columns[" + std::to_string(index) + "]";
    for (uint32_t i = 0; i < index; ++i) {
        if (view_.columns[i].attribute == column.attribute) {
            fail(FLG_ERROR_INVALID_ARGUMENT, place, "has the same attribute (%d) as column %u", column.attribute, i);
        }
    }
    const auto rule = std::find_if(std::begin(rules), std::end(rules),
                                   [&](const ColumnRule& r) { return r.attribute == column.attribute; });
    if (rule == std::end(rules) && column.attribute < FLG_ATTRIBUTE_USER) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".attribute", "is %d, no attribute known", column.attribute);
    }
    const bool fits = rule == std::end(rules) ? column.components >= 1 && column.components <= most_components
                                              : column.components == rule->components;
    if (!fits) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".components", "is %u, which does not fit attribute %d",
             column.components, column.attribute);
    }
    if (!column.data) fail(FLG_ERROR_INVALID_ARGUMENT, place + ".data", "is null");
    if (column.stride % sizeof(float) != 0 ||
        (column.stride != 0 && column.stride < column.components * sizeof(float))) {
        fail(FLG_ERROR_INVALID_ARGUMENT, place + ".stride", "is %u, must be a multiple of 4 and at least %zu",
             column.stride, column.components * sizeof(float));
    }
    const Column values{column.data, column.stride == 0 ? column.components * sizeof(float) : column.stride};
    const bool is_length = column.attribute == FLG_ATTRIBUTE_POSITION || column.attribute == FLG_ATTRIBUTE_RADIUS;
    for (size_t point = 0; point < point_count(); ++point) {
        for (uint32_t i = 0; i < column.components; ++i) {
            const float value = values.at(point)[i];
            if (!std::isfinite(value) || (is_length && std::abs(value) > max_coordinate)) {
                fail(FLG_ERROR_INVALID_ARGUMENT, place + ".data", "has %g at point %zu: must be finite%s",
                     double{value}, point, is_length ? " and at most 1e30 in size" : "");
            }
            if (column.attribute == FLG_ATTRIBUTE_RADIUS && value < 0) {
                fail(FLG_ERROR_INVALID_ARGUMENT, place + ".data", "has the radius %g at point %zu: must be >= 0",
                     double{value}, point);
            }
        }
    }
}

}  // namespace flg::io
