// SPDX-License-Identifier: MIT
// Curve sets: checked and copied at the door, shown, released.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/inputs.h"

namespace flg {

namespace {

constexpr uint32_t max_columns = 16;
constexpr uint32_t max_user_components = 16;
constexpr float max_coordinate = 1e30f;

FlgCurveSetView default_view() {
    FlgCurveSetView view{};
    view.struct_size = sizeof view;
    return view;
}

// Floats a point that an attribute has; 0 for user attributes, which choose, and -1 for numbers that mean nothing.
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
        case FLG_ATTRIBUTE_SPEED: return 1;
        case FLG_ATTRIBUTE_COLOR:
        case FLG_ATTRIBUTE_ORIENTATION: return 4;
        default: return attribute >= FLG_ATTRIBUTE_USER ? 0 : -1;
    }
}

// The least value that a component may have.
float least_value(FlgAttribute attribute, uint32_t component) {
    switch (attribute) {
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_WIDTH: return 0;
        case FLG_ATTRIBUTE_RADII: return component < 2 ? 0 : -HUGE_VALF;
        case FLG_ATTRIBUTE_SPEED: return std::numeric_limits<float>::min();
        default: return -HUGE_VALF;
    }
}

void check_structure(const FlgCurveSetView& view) {
    if (view.curve_count == 0) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.curve_count is 0, must be at least 1");
    const uint32_t* offsets = &require(view.curve_offsets, "view.curve_offsets");
    if (offsets[0] != 0)
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.curve_offsets[0] is %u, must be 0", offsets[0]);
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        if (offsets[c + 1] <= offsets[c]) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "view.curve_offsets[%u] is %u after %u; every curve needs at least one point", c + 1,
                          offsets[c + 1], offsets[c]);
        }
        if (view.curve_flags && (view.curve_flags[c] & ~FLG_CURVE_CLOSED) != 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.curve_flags[%u] is %u, must be 0 or FLG_CURVE_CLOSED", c,
                          view.curve_flags[c]);
        }
    }
}

void check_columns(const FlgCurveSetView& view) {
    if (view.column_count < 1 || view.column_count > max_columns) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.column_count is %u, must be 1 to %u", view.column_count,
                      max_columns);
    }
    require(view.columns, "view.columns");
    bool has_positions = false;
    for (uint32_t i = 0; i < view.column_count; ++i) {
        const FlgColumn& column = view.columns[i];
        const int32_t attribute = number_of(column.attribute);
        const int components = components_of(attribute);
        if (components < 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.columns[%u].attribute is %d, not one of FLG_ATTRIBUTE_...",
                          i, attribute);
        }
        const bool fits = components == 0 ? column.components >= 1 && column.components <= max_user_components
                                          : column.components == static_cast<uint32_t>(components);
        if (!fits) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.columns[%u].components is %u, attribute %d has %d", i,
                          column.components, attribute, components == 0 ? max_user_components : components);
        }
        if (!column.data) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.columns[%u].data is null", i);
        if (column.stride != 0 &&
            (column.stride % sizeof(float) != 0 || column.stride < column.components * sizeof(float))) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                          "view.columns[%u].stride is %u bytes, must be 0 or a multiple of 4 and at least %zu", i,
                          column.stride, column.components * sizeof(float));
        }
        for (uint32_t j = 0; j < i; ++j) {
            if (view.columns[j].attribute == column.attribute) {
                throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.columns[%u] and [%u] are both attribute %d", j, i,
                              attribute);
            }
        }
        has_positions = has_positions || column.attribute == FLG_ATTRIBUTE_POSITION;
    }
    if (!has_positions) throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.columns has no FLG_ATTRIBUTE_POSITION");
}

[[noreturn]] void refuse_value(const FlgCurveSetView& view, uint32_t column, uint32_t point, float value) {
    uint32_t curve = 0;
    while (view.curve_offsets[curve + 1] <= point) ++curve;
    const char* rule = "must be finite";
    if (std::isfinite(value)) {
        const FlgAttribute attribute = view.columns[column].attribute;
        rule = attribute == FLG_ATTRIBUTE_POSITION ? "must be at most 1e30 in size"
               : attribute == FLG_ATTRIBUTE_SPEED  ? "must be above 0"
                                                   : "must not be negative";
    }
    throw Failure(FLG_ERROR_INVALID_ARGUMENT, "view.columns[%u] holds %g at point %u of curve %u, %s", column,
                  static_cast<double>(value), point - view.curve_offsets[curve], curve, rule);
}

void copy_column(const FlgCurveSetView& view, uint32_t index, uint32_t point_count, float* out) {
    const FlgColumn& column = view.columns[index];
    const size_t stride = column.stride ? column.stride / sizeof(float) : column.components;
    const float largest = column.attribute == FLG_ATTRIBUTE_POSITION ? max_coordinate : HUGE_VALF;
    std::array<float, max_user_components> least;
    for (uint32_t k = 0; k < column.components; ++k) {
        least[k] = std::max(-largest, least_value(column.attribute, k));
    }
    for (uint32_t p = 0; p < point_count; ++p) {
        for (uint32_t k = 0; k < column.components; ++k) {
            const float value = column.data[p * stride + k];
            if (!(std::isfinite(value) && value >= least[k] && value <= largest)) refuse_value(view, index, p, value);
            out[size_t{p} * column.components + k] = value;
        }
    }
}

// The columns in our order: POSITION first, the others as given.
std::pmr::vector<uint32_t> column_order(const FlgCurveSetView& view, Memory* memory) {
    std::pmr::vector<uint32_t> order(memory);
    for (uint32_t i = 0; i < view.column_count; ++i) {
        const bool first = view.columns[i].attribute == FLG_ATTRIBUTE_POSITION;
        order.insert(first ? order.begin() : order.end(), i);
    }
    return order;
}

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgCurveSetViewInit(FlgCurveSetView* view, uint32_t struct_size) {
    return guarded([&] {
        init_struct(view, struct_size, default_view(), "view");
        return FLG_OK;
    });
}

FlgResult flgCurveSetCreate(FlgContext context, const FlgCurveSetView* view, FlgCurveSet* out_set) {
    return guarded([&] {
        require(out_set, "out_set") = {};
        Context& self = get_context(context);
        const FlgCurveSetView read = read_struct(view, default_view(), "view");
        check_structure(read);
        check_columns(read);

        const auto set = make_object<CurveSet>(self, &self.memory);
        set->allocate_curves(read.curve_count);
        std::memcpy(set->offsets().data(), read.curve_offsets, (size_t{read.curve_count} + 1) * sizeof(uint32_t));
        for (uint32_t c = 0; c < read.curve_count; ++c) set->flags()[c] = read.curve_flags ? read.curve_flags[c] : 0;

        const auto order = column_order(read, &self.memory);
        std::pmr::vector<CurveSet::ColumnLayout> layout(&self.memory);
        for (uint32_t i : order) layout.push_back({read.columns[i].attribute, read.columns[i].components});
        set->allocate_columns(layout);
        for (size_t i = 0; i < order.size(); ++i) {
            copy_column(read, order[i], set->point_count(), set->columns()[i].values.data());
        }
        set->publish_complete();
        *out_set = {self.curve_sets.add(set)};
        return FLG_OK;
    });
}

FlgResult flgCurveSetGetView(FlgContext context, FlgCurveSet set, FlgCurveSetView* out_view) {
    return guarded([&] {
        write_struct(out_view, default_view(), "out_view");
        const CurveSet& self = *get_context(context).curve_sets.get(set.id, "set");
        const FlgResult result = self.visible_result();
        if (result == FLG_NOT_READY) return result;
        if (result != FLG_OK) return set_last_error(result, self.error());
        write_struct(out_view, self.view(), "out_view");
        return FLG_OK;
    });
}

FlgResult flgCurveSetRelease(FlgContext context, FlgCurveSet set) {
    return guarded([&] {
        get_context(context).curve_sets.remove(set.id, "set");
        return FLG_OK;
    });
}

}  // extern "C"
