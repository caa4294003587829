// SPDX-License-Identifier: MIT
#include "io/gltf_columns.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/failure.h"
#include "io/limits.h"

namespace flg::io {

namespace {

struct NamedAttribute {
    FlgAttribute attribute;
    uint32_t components;
    const char* name;
};
constexpr NamedAttribute named[] = {
    {FLG_ATTRIBUTE_NORMAL, 3, "NORMAL"},
    {FLG_ATTRIBUTE_TIME, 1, "_TIME"},
    {FLG_ATTRIBUTE_PRESSURE, 1, "_PRESSURE"},
    {FLG_ATTRIBUTE_STYLE_INDEX, 1, "_STYLE_INDEX"},
    {FLG_ATTRIBUTE_RADII, 3, "_RADII"},
    {FLG_ATTRIBUTE_ANGLE, 1, "_ANGLE"},
    {FLG_ATTRIBUTE_WIDTH, 1, "_WIDTH"},
    {FLG_ATTRIBUTE_SPEED, 1, "_SPEED"},
    {FLG_ATTRIBUTE_DISPLACEMENT, 3, "_DISPLACEMENT"},
};
constexpr std::string_view user_prefix = "_USER";

bool is_direction(FlgAttribute attribute) {
    return attribute == FLG_ATTRIBUTE_NORMAL || attribute == FLG_ATTRIBUTE_DISPLACEMENT;
}

// The leading components, so many, grow with the node.
uint32_t size_count(FlgAttribute attribute) {
    switch (attribute) {
        case FLG_ATTRIBUTE_WIDTH:
        case FLG_ATTRIBUTE_SPEED: return 1;
        case FLG_ATTRIBUTE_RADII: return 2;
        default: return 0;
    }
}

// The attribute of a name and the components it has to have, 0: any; no attribute: POSITION.
NamedAttribute attribute_of(std::string_view name) {
    for (const NamedAttribute& known : named) {
        if (name == known.name) return known;
    }
    constexpr NamedAttribute none = {FLG_ATTRIBUTE_POSITION, 0, ""};
    if (!name.starts_with(user_prefix)) return none;
    name.remove_prefix(user_prefix.size());
    uint32_t number = 0;
    const auto [stop, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    const bool known = error == std::errc{} && stop == name.data() + name.size() &&
                       number < uint32_t{FLG_ATTRIBUTE_FORCE_32BIT} - FLG_ATTRIBUTE_USER;
    if (!known) return none;
    return {static_cast<FlgAttribute>(FLG_ATTRIBUTE_USER + number), 0, ""};
}

}  // namespace

std::string gltf_column_name(FlgAttribute attribute) {
    if (attribute >= FLG_ATTRIBUTE_USER)
        return std::string(user_prefix) + std::to_string(attribute - FLG_ATTRIBUTE_USER);
    for (const NamedAttribute& known : named) {
        if (known.attribute == attribute) return known.name;
    }
    return "";
}

std::vector<GltfColumn> read_columns(const GltfDocument& document, const GltfPrimitive& primitive,
                                     uint64_t vertex_count) {
    constexpr size_t most_columns = 13;  // beside positions, colours and radii
    std::vector<GltfColumn> columns;
    for (const auto& [name, accessor] : primitive.json.at("attributes").items()) {
        const NamedAttribute known = attribute_of(name);
        if (known.attribute == FLG_ATTRIBUTE_POSITION) continue;
        GltfValues values = *read_attribute(document, primitive, name.c_str());
        const bool fits =
            known.components == 0 ? values.components <= most_gltf_components : values.components == known.components;
        if (!fits || values.count != vertex_count) {
            fail(FLG_ERROR_FORMAT, values.place, "holds no values fit for %llu vertices",
                 static_cast<unsigned long long>(vertex_count));
        }
        const auto same = [&](const GltfColumn& other) { return other.attribute == known.attribute; };
        if (columns.size() == most_columns || std::any_of(columns.begin(), columns.end(), same)) {
            fail(FLG_ERROR_FORMAT, values.place, "is one column too many, or one that is there already");
        }
        columns.push_back({known.attribute, std::move(values)});
    }
    return columns;
}

void append_placed(const GltfColumn& column, uint32_t vertex, const Transform& t, std::vector<float>& out) {
    const uint32_t count = column.values.components;
    double values[most_gltf_components];
    for (uint32_t k = 0; k < count; ++k) values[k] = column.values.number(vertex, k);
    if (is_direction(column.attribute)) {
        double turned[3];
        for (size_t row = 0; row < 3; ++row) {
            turned[row] = t[row] * values[0] + t[3 + row] * values[1] + t[6 + row] * values[2];
        }
        const double length = std::hypot(turned[0], turned[1], turned[2]);
        const bool unit = column.attribute == FLG_ATTRIBUTE_NORMAL && length > 0;
        for (size_t row = 0; row < 3; ++row) values[row] = unit ? turned[row] / length : turned[row];
    }
    const double scale = size_count(column.attribute) > 0 ? std::cbrt(std::abs(determinant(t))) : 1.0;
    for (uint32_t k = 0; k < count; ++k) {
        const auto value = static_cast<float>(k < size_count(column.attribute) ? scale * values[k] : values[k]);
        if (!(std::abs(value) <= max_coordinate)) refuse_value(column.values, vertex, value);
        if (const char* rule = rule_broken_by(column.attribute, k, value)) {
            fail(FLG_ERROR_FORMAT, column.values.place, "vertex %u gives %g: %s", vertex, double{value}, rule);
        }
        out.push_back(value);
    }
}

}  // namespace flg::io
