// SPDX-License-Identifier: MIT
#include "io/base/column_names.h"

#include <algorithm>
#include <charconv>

namespace flg::io {

namespace {

struct NamedAttribute {
    FlgAttribute attribute;
    uint32_t components;
    const char* name;
};
constexpr NamedAttribute named[] = {
    {FLG_ATTRIBUTE_COLOR, 4, "color"},   {FLG_ATTRIBUTE_NORMAL, 3, "normal"},
    {FLG_ATTRIBUTE_RADIUS, 1, "radius"}, {FLG_ATTRIBUTE_TANGENT, 3, "tangent"},
    {FLG_ATTRIBUTE_TIME, 1, "time"},     {FLG_ATTRIBUTE_PRESSURE, 1, "pressure"},
    {FLG_ATTRIBUTE_RADII, 3, "radii"},   {FLG_ATTRIBUTE_ORIENTATION, 4, "orientation"},
    {FLG_ATTRIBUTE_ANGLE, 1, "angle"},   {FLG_ATTRIBUTE_STYLE_INDEX, 1, "style_index"},
    {FLG_ATTRIBUTE_WIDTH, 1, "width"},   {FLG_ATTRIBUTE_DISPLACEMENT, 3, "displacement"},
    {FLG_ATTRIBUTE_SPEED, 1, "speed"},
};
constexpr std::string_view user_prefix = "user";
constexpr uint32_t max_components = 16;
constexpr size_t max_columns = 16;

// The attribute of the name `userN` or `userN_0`; none: FLG_ATTRIBUTE_USER - 1.
FlgAttribute user_attribute(std::string_view name) {
    constexpr uint32_t none = FLG_ATTRIBUTE_USER - 1;
    uint32_t number = 0;
    if (!name.starts_with(user_prefix)) return static_cast<FlgAttribute>(none);
    name.remove_prefix(user_prefix.size());
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    const std::string_view rest(stop, static_cast<size_t>(name.data() + name.size() - stop));
    const bool known = error == std::errc{} && (rest.empty() || rest == "_0") &&
                       number < uint32_t{FLG_ATTRIBUTE_FORCE_32BIT} - FLG_ATTRIBUTE_USER;
    return static_cast<FlgAttribute>(known ? FLG_ATTRIBUTE_USER + number : none);
}

// Whether all components are there; an alpha may be missing.
bool has_column(std::span<const std::string_view> names, FlgAttribute attribute, uint32_t components) {
    for (uint32_t k = 0; k < components; ++k) {
        const bool alpha = attribute == FLG_ATTRIBUTE_COLOR && k == 3;
        const auto place = std::find(names.begin(), names.end(), column_name(attribute, components, k));
        if (place == names.end() && !alpha) return false;
    }
    return true;
}

}  // namespace

String column_name(FlgAttribute attribute, uint32_t components, uint32_t component) {
    constexpr const char* positions[] = {"x", "y", "z"};
    constexpr const char* normals[] = {"nx", "ny", "nz"};
    constexpr const char* colors[] = {"red", "green", "blue", "alpha"};
    constexpr const char* uvs[] = {"s", "t"};
    if (attribute == FLG_ATTRIBUTE_POSITION) return positions[component];
    if (attribute == FLG_ATTRIBUTE_NORMAL) return normals[component];
    if (attribute == FLG_ATTRIBUTE_COLOR) return colors[component];
    if (attribute == FLG_ATTRIBUTE_UV) return uvs[component];
    String name(user_prefix);
    if (attribute >= FLG_ATTRIBUTE_USER) name += to_text(attribute - FLG_ATTRIBUTE_USER);
    for (const NamedAttribute& known : named) {
        if (known.attribute == attribute) name = known.name;
    }
    return components == 1 ? name : name + "_" + to_text(component);
}

Vector<VertexColumn> columns_of_names(std::span<const std::string_view> names) {
    Vector<VertexColumn> columns;
    const auto add = [&](FlgAttribute attribute, uint32_t components) {
        const bool known = std::any_of(columns.begin(), columns.end(),
                                       [&](const VertexColumn& column) { return column.attribute == attribute; });
        if (!known && columns.size() + 1 < max_columns) columns.push_back({attribute, components, {}});
    };
    for (const NamedAttribute& known : named) {
        if (has_column(names, known.attribute, known.components)) add(known.attribute, known.components);
    }
    for (const std::string_view name : names) {
        const FlgAttribute attribute = user_attribute(name);
        if (attribute < FLG_ATTRIBUTE_USER) continue;
        uint32_t components = 1;
        if (name.ends_with("_0")) {
            components = max_components;
            while (components > 1 && !has_column(names, attribute, components)) --components;
            // `userN_0` alone is none of our names.
            if (components == 1) continue;
        }
        add(attribute, components);
    }
    return columns;
}

const char* rule_broken_by(FlgAttribute attribute, uint32_t component, float value) {
    switch (attribute) {
        case FLG_ATTRIBUTE_RADIUS:
        case FLG_ATTRIBUTE_WIDTH: return value < 0 ? "must be >= 0" : nullptr;
        case FLG_ATTRIBUTE_RADII: return component < 2 && value < 0 ? "must be >= 0" : nullptr;
        case FLG_ATTRIBUTE_SPEED: return value > 0 ? nullptr : "must be above 0";
        default: return nullptr;
    }
}

}  // namespace flg::io
