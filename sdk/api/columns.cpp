// SPDX-License-Identifier: MIT
#include "api/columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "api/descriptors.h"
#include "api/inputs.h"

namespace flg {

namespace {

// Whether a float column may have it.
bool is_of(ColumnsOf whose, int32_t attribute) {
    const bool of_points = attribute < FLG_ATTRIBUTE_JOINTS || attribute >= FLG_ATTRIBUTE_USER;
    return of_points ||
           (whose == ColumnsOf::any && (attribute == FLG_ATTRIBUTE_WEIGHTS || attribute == FLG_ATTRIBUTE_VALUE));
}

// The least value that a component may have.
float min_value(FlgAttribute attribute, uint32_t component) {
    switch (attribute) {
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_WIDTH: return 0;
        case FLG_ATTRIBUTE_RADII: return component < 2 ? 0 : -HUGE_VALF;
        case FLG_ATTRIBUTE_SPEED: return std::numeric_limits<float>::min();
        default: return -HUGE_VALF;
    }
}

const char* rule_broken_by(FlgAttribute attribute, float value) {
    if (!std::isfinite(value)) return "must be finite";
    if (!is_coordinate(value)) return "must be at most 1e30 in size";
    return attribute == FLG_ATTRIBUTE_SPEED ? "must be above 0, and no denormal number" : "must not be negative";
}

}  // namespace

int components_of(int32_t attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_POSITION:
        case FLG_ATTRIBUTE_TANGENT:
        case FLG_ATTRIBUTE_NORMAL:
        case FLG_ATTRIBUTE_RADII:
        case FLG_ATTRIBUTE_DISPLACEMENT: return 3;
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_TIME:
        case FLG_ATTRIBUTE_PRESSURE:
        case FLG_ATTRIBUTE_STYLE_INDEX:
        case FLG_ATTRIBUTE_ANGLE:
        case FLG_ATTRIBUTE_WIDTH:
        case FLG_ATTRIBUTE_SPEED:
        case FLG_ATTRIBUTE_PART:
        case FLG_ATTRIBUTE_VALUE:
        case FLG_ATTRIBUTE_LABEL: return 1;
        case FLG_ATTRIBUTE_COLOR:
        case FLG_ATTRIBUTE_ORIENTATION:
        case FLG_ATTRIBUTE_JOINTS:
        case FLG_ATTRIBUTE_WEIGHTS: return 4;
        case FLG_ATTRIBUTE_UV: return 2;
        default: return attribute >= FLG_ATTRIBUTE_USER ? 0 : -1;
    }
}

void check_columns(const FlgColumn* columns, uint32_t count, const char* owner, ColumnsOf whose) {
    if (count < 1 || count > max_columns) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.column_count is %u, must be 1 to %u", owner, count, max_columns);
    }
    if (!columns) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.columns is null", owner);
    bool has_positions = false;
    for (uint32_t i = 0; i < count; ++i) {
        const FlgColumn& column = columns[i];
        const int32_t attribute = number_of(column.attribute);
        const int components = components_of(attribute);
        if (components < 0 || !is_of(whose, attribute)) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.columns[%u].attribute is %d, not one of FLG_ATTRIBUTE_...",
                          owner, i, attribute);
        }
        const bool fits = components == 0 ? column.components >= 1 && column.components <= max_user_components
                                          : column.components == static_cast<uint32_t>(components);
        if (!fits) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.columns[%u].components is %u, attribute %d has %d", owner, i,
                          column.components, attribute, components == 0 ? max_user_components : components);
        }
        if (column.reserved != 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.columns[%u].reserved is %u, must be 0", owner, i,
                          column.reserved);
        }
        if (!column.data) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.columns[%u].data is null", owner, i);
        if (column.stride != 0 &&
            (column.stride % sizeof(float) != 0 || column.stride < column.components * sizeof(float))) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "%s.columns[%u].stride is %u bytes, must be 0 or a multiple of 4 and at least %zu", owner, i,
                          column.stride, column.components * sizeof(float));
        }
        for (uint32_t j = 0; j < i; ++j) {
            if (columns[j].attribute == column.attribute) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.columns[%u] and [%u] are both attribute %d", owner, j, i,
                              attribute);
            }
        }
        has_positions = has_positions || column.attribute == FLG_ATTRIBUTE_POSITION;
    }
    if (whose == ColumnsOf::points && !has_positions) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "%s.columns has no FLG_ATTRIBUTE_POSITION", owner);
    }
}

BadValue copy_column(const FlgColumn& column, uint32_t first, uint32_t end, float* out) {
    const size_t stride = column.stride ? column.stride / sizeof(float) : column.components;
    std::array<float, max_user_components> least;
    for (uint32_t k = 0; k < column.components; ++k) least[k] = min_value(column.attribute, k);
    for (uint32_t row = first; row < end; ++row) {
        for (uint32_t k = 0; k < column.components; ++k) {
            const float value = column.data[row * stride + k];
            if (!(is_coordinate(value) && value >= least[k])) {
                return {row, value, rule_broken_by(column.attribute, value)};
            }
            *out++ = value;
        }
    }
    return {};
}

const FlgColumn* find_column(const FlgColumn* columns, uint32_t count, FlgAttribute attribute) {
    if (!columns) return nullptr;
    const FlgColumn* const end = columns + count;
    const FlgColumn* const found =
        std::find_if(columns, end, [&](const FlgColumn& column) { return column.attribute == attribute; });
    return found != end ? found : nullptr;
}

}  // namespace flg
