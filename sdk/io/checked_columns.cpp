// SPDX-License-Identifier: MIT
#include "io/checked_columns.h"

#include <algorithm>
#include <cmath>
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

Column resolved(const FlgColumn& column) {
    return {column.data, column.stride == 0 ? column.components * sizeof(float) : column.stride};
}

std::vector<float> packed(const Column& column, size_t point_count, uint32_t components) {
    std::vector<float> values;
    values.reserve(point_count * components);
    for (size_t i = 0; i < point_count; ++i) values.insert(values.end(), column.at(i), column.at(i) + components);
    return values;
}

CheckedColumns::CheckedColumns(const FlgColumn* columns, uint32_t count, size_t point_count)
    : columns_(columns), count_(count) {
    if (count < 1 || count > most_columns) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.column_count", "is %u, must be 1 to %u", count, most_columns);
    }
    if (!columns) fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns", "is null");
    for (uint32_t i = 0; i < count; ++i) check(i, point_count);
    if (!find(FLG_ATTRIBUTE_POSITION)) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns", "has no FLG_ATTRIBUTE_POSITION");
    }
}

Column CheckedColumns::find(FlgAttribute attribute) const {
    for (uint32_t i = 0; i < count_; ++i) {
        if (columns_[i].attribute == attribute) return resolved(columns_[i]);
    }
    return {};
}

void CheckedColumns::check(uint32_t index, size_t point_count) const {
    const FlgColumn& column = columns_[index];
    const std::string place = "view.columns[" + std::to_string(index) + "]";
    for (uint32_t i = 0; i < index; ++i) {
        if (columns_[i].attribute == column.attribute) {
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
    const Column values = resolved(column);
    const bool is_length = column.attribute == FLG_ATTRIBUTE_POSITION || column.attribute == FLG_ATTRIBUTE_RADIUS;
    for (size_t point = 0; point < point_count; ++point) {
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
