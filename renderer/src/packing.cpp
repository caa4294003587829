// SPDX-License-Identifier: MIT
#include "packing.h"

#include <algorithm>
#include <cmath>

#include "filigree/filigree_buffers.h"
#include "vk.h"

namespace flg::render {
Column find_column(std::span<const FlgColumn> columns, FlgAttribute attribute, uint32_t components, const char* name) {
    for (const FlgColumn& column : columns) {
        if (column.attribute != attribute) continue;
        if (!column.data) fail("The column %s has no data.", name);
        if (column.components != components)
            fail("The column %s has %u floats a point instead of %u.", name, column.components, components);
        if (column.stride % sizeof(float) != 0)
            fail("The column %s has a stride of %u bytes, which is no multiple of 4.", name, column.stride);
        return {reinterpret_cast<const char*>(column.data), column.stride ? column.stride : components * sizeof(float)};
    }
    return {};
}

bool is_usable(glm::vec3 p) {
    for (int i = 0; i < 3; ++i)
        if (!(std::abs(p[i]) <= largest_coordinate)) return false;
    return true;
}

void check_in(float value, float low, float high, const char* name) {
    if (!(value >= low && value <= high)) fail("The look's %s is %g; it must be in %g to %g.", name, value, low, high);
}

void check_color(glm::vec3 color, const char* name) {
    for (int i = 0; i < 3; ++i) check_in(color[i], 0.0f, 1.0f, name);
}

void write_columns(std::span<const FlgColumn> from, uint32_t rows, std::span<const FlgBufferColumn> to) {
    if (to.empty()) return;
    FlgBufferOutput output = flgBufferOutputDefaults();
    output.columns = to.data();
    output.column_count = static_cast<uint32_t>(to.size());
    output.row_capacity = rows;
    FlgColumnsWriteDesc desc = flgColumnsWriteDefaults();
    desc.columns = from.data();
    desc.column_count = static_cast<uint32_t>(from.size());
    desc.row_count = rows;
    desc.output = &output;
    if (flgColumnsWrite(&desc) != FLG_OK) fail("%s", flgErrorGetMessage());
}

void write_normals(std::span<const glm::vec3> normals, uint32_t* to, uint32_t stride) {
    if (normals.empty()) return;
    const FlgColumn from = {FLG_ATTRIBUTE_NORMAL, 3, &normals[0].x, 0, 0};
    const FlgBufferColumn column = {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_OCTAHEDRAL16, to, stride, 0, {}, 0, 0};
    write_columns({&from, 1}, static_cast<uint32_t>(normals.size()), {&column, 1});
}

void write_colors(std::span<const glm::vec4> colors, uint32_t* to, uint32_t stride) {
    if (colors.empty()) return;
    const FlgColumn from = {FLG_ATTRIBUTE_COLOR, 4, &colors[0].x, 0, 0};
    const FlgBufferColumn column = {FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_SRGB8, to, stride, 0, {}, 0, 0};
    write_columns({&from, 1}, static_cast<uint32_t>(colors.size()), {&column, 1});
}

uint32_t packed_color(glm::vec3 linear) {
    const glm::vec4 color(linear, 1.0f);
    uint32_t packed = 0;
    write_colors({&color, 1}, &packed, sizeof packed);
    return packed;
}

}  // namespace flg::render
