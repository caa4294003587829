// SPDX-License-Identifier: MIT
// Source: Khronos, glTF 2.0 specification (3.7.2 primitives). Lines: one LINE_STRIP or LINE_LOOP a curve, all in shared
// buffer views; a curve of one point is a strip of the indices 0 0. Surfaces: one primitive of triangles with 32-bit
// indices.
#include "io/gltf_writer.h"

#include <cmath>
#include <vector>

#include "io/failure.h"
#include "io/glb_builder.h"
#include "io/gltf_columns.h"
#include "io/swept_mesh.h"

namespace flg::io {

namespace {

struct LineColumn {
    std::string name;
    uint32_t components;
    size_t view;
};

// The columns that are written besides positions, colours and radii.
std::vector<LineColumn> line_columns(const CheckedView& view, GlbBuilder& glb) {
    std::vector<LineColumn> columns;
    for (size_t i = 0; i < view.columns().size(); ++i) {
        const FlgColumn& column = view.columns()[i];
        const std::string name = gltf_column_name(column.attribute);
        if (name.empty()) continue;
        if (column.components > most_gltf_components) {
            fail(FLG_ERROR_INVALID_ARGUMENT, "view.columns[" + std::to_string(i) + "].components",
                 "is %u, .glb holds at most 4", column.components);
        }
        const std::vector<float> values = packed(resolved(column), view.point_count(), column.components);
        columns.push_back({name, column.components, glb.add_view(values, column.components)});
    }
    return columns;
}

std::string write_lines(const CheckedView& view, bool all_columns) {
    GlbBuilder glb;
    const std::vector<float> positions = packed(view.position, view.point_count(), 3);
    const size_t position_view = glb.add_view(positions, 3);
    size_t color_view = 0;
    size_t radius_view = 0;
    if (view.color) color_view = glb.add_colors(packed(view.color, view.point_count(), 4));
    if (view.radius) radius_view = glb.add_view(packed(view.radius, view.point_count(), 1), 1);
    std::vector<LineColumn> columns;
    if (all_columns) columns = line_columns(view, glb);
    std::string lone_indices;  // of all curves of one point

    for (uint32_t c = 0; c < view.curve_count(); ++c) {
        const size_t first = view.begin(c);
        const size_t count = view.end(c) - first;
        std::string attributes =
            "\"POSITION\":" + std::to_string(glb.add_positions(position_view, positions, first, count));
        if (view.color) {
            const size_t accessor = glb.add_accessor(color_view, first * 4 * sizeof(float), count, glb_float, "VEC4");
            attributes += ",\"COLOR_0\":" + std::to_string(accessor);
        }
        if (view.radius) {
            const size_t accessor = glb.add_accessor(radius_view, first * sizeof(float), count, glb_float, "SCALAR");
            attributes += ",\"_RADIUS\":" + std::to_string(accessor);
        }
        for (const LineColumn& column : columns) {
            constexpr const char* types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
            const size_t accessor = glb.add_accessor(column.view, first * column.components * sizeof(float), count,
                                                     glb_float, types[column.components - 1]);
            attributes += ",\"" + column.name + "\":" + std::to_string(accessor);
        }
        if (count == 1 && lone_indices.empty()) {
            const uint32_t zeros[] = {0, 0};
            const size_t accessor = glb.add_accessor(glb.add_view(zeros), 0, 2, glb_unsigned, "SCALAR");
            lone_indices = ",\"indices\":" + std::to_string(accessor);
        }
        glb.add_primitive(attributes, view.closed(c) ? glb_line_loop : glb_line_strip, count == 1 ? lone_indices : "");
    }
    return glb.finish("");
}

std::string write_surface(const CheckedView& view, const FlgCurveWriteDesc& desc) {
    SweptMesh mesh = sweep(view, desc);
    if (mesh.indices.empty()) {
        fail(FLG_ERROR_INVALID_ARGUMENT, "view", "has no curve with a length: there is no surface to write");
    }
    // A radius near the limit may carry a vertex beyond it.
    for (float value : mesh.positions) {
        if (!std::isfinite(value)) fail(FLG_ERROR_INVALID_ARGUMENT, "view", "has radii too large for its positions");
    }
    GlbBuilder glb;
    const size_t count = mesh.positions.size() / 3;
    const size_t positions = glb.add_positions(glb.add_view(mesh.positions, 3), mesh.positions, 0, count);
    const size_t normals = glb.add_accessor(glb.add_view(mesh.normals, 3), 0, count, glb_float, "VEC3");
    std::string attributes = "\"POSITION\":" + std::to_string(positions) + ",\"NORMAL\":" + std::to_string(normals);
    if (!mesh.colors.empty()) {
        const size_t colors = glb.add_accessor(glb.add_colors(std::move(mesh.colors)), 0, count, glb_float, "VEC4");
        attributes += ",\"COLOR_0\":" + std::to_string(colors);
    }
    const size_t indices = glb.add_accessor(glb.add_view(mesh.indices), 0, mesh.indices.size(), glb_unsigned, "SCALAR");
    glb.add_primitive(attributes, glb_triangles, ",\"indices\":" + std::to_string(indices) + ",\"material\":0");
    const char* sides = desc.geometry == FLG_GEOMETRY_RIBBON ? "true" : "false";
    return glb.finish(std::string("\"materials\":[{\"doubleSided\":") + sides +
                      ",\"pbrMetallicRoughness\":{\"metallicFactor\":0,\"roughnessFactor\":0.6}}],");
}

}  // namespace

std::string write_glb(const CheckedView& view, const FlgCurveWriteDesc& desc) {
    return desc.geometry == FLG_GEOMETRY_LINES ? write_lines(view, desc.all_columns != 0) : write_surface(view, desc);
}

}  // namespace flg::io
