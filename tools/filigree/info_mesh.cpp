// SPDX-License-Identifier: MIT
// What `filigree info` says of a mesh.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <sstream>

#include "info.h"
#include "support/curve_source.h"

namespace flg::cli {
namespace {

struct Measures {
    double area = 0.0;
    double shortest_edge = std::numeric_limits<double>::max(), max_edge = 0.0;
    uint64_t without_area = 0;
};

Measures measure(const FlgMeshView& view) {
    Measures m;
    const FlgColumn& positions = positions_of(view);
    for (size_t t = 0; t < view.triangle_count; ++t) {
        double edges[3][3];
        for (size_t k = 0; k < 3; ++k) {
            const float* from = samples::value_at(positions, view.triangles[3 * t + k]);
            const float* to = samples::value_at(positions, view.triangles[3 * t + (k + 1) % 3]);
            for (size_t i = 0; i < 3; ++i) edges[k][i] = static_cast<double>(to[i]) - from[i];
            const double length = std::hypot(edges[k][0], edges[k][1], edges[k][2]);
            m.shortest_edge = std::min(m.shortest_edge, length);
            m.max_edge = std::max(m.max_edge, length);
        }
        const double *u = edges[0], *v = edges[1];
        const double area =
            0.5 * std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
        m.without_area += area == 0.0;
        m.area += area;
    }
    return m;
}

}  // namespace

void describe_origin(const double (&origin)[3], Report& report) {
    if (origin[0] == 0 && origin[1] == 0 && origin[2] == 0) return;
    std::ostringstream text;
    text.precision(17);
    text << origin[0] << " " << origin[1] << " " << origin[2];
    std::cout << "origin: " << text.str() << " m; the box is relative to it\n";
    report.quality["origin"] = {origin[0], origin[1], origin[2]};
}

void describe_mesh(const MeshFile& mesh, Report& report) {
    const FlgMeshView& view = mesh.view();
    const FlgMeshFileInfo& info = mesh.info();
    const Measures m = measure(view);
    const float *low = info.box_min, *high = info.box_max;
    std::cout << mesh.name() << ": " << info.format << ", units as given\n"
              << "vertices: " << info.vertex_count << ", faces: " << info.polygon_count
              << ", triangles: " << info.triangle_count << ", regions: " << info.region_count << "\n"
              << "area: " << m.area << " m2; edges: " << m.shortest_edge << " to " << m.max_edge << " m\n"
              << "box: " << low[0] << " " << low[1] << " " << low[2] << " to " << high[0] << " " << high[1] << " "
              << high[2] << " m\n";
    describe_origin(view.origin, report);
    std::cout << "columns:";
    nlohmann::ordered_json columns = nlohmann::ordered_json::array(), face_columns = nlohmann::ordered_json::array();
    for (uint32_t i = 0; i < view.column_count; ++i) {
        std::cout << " " << attribute_name(view.columns[i].attribute);
        columns.push_back(attribute_name(view.columns[i].attribute));
    }
    std::cout << "\n";
    if (view.regions != nullptr) face_columns.push_back("region");
    for (const FlgMeshFaceColumn& column : mesh.face_columns()) face_columns.push_back(column.name);
    if (!face_columns.empty()) {
        std::cout << "columns of faces:";
        for (const auto& name : face_columns) std::cout << " " << name.get<std::string>();
        std::cout << "\n";
    }
    for (uint32_t i = 0; i < info.warning_count; ++i) {
        std::cout << "odd: " << info.warnings[i] << "\n";
        report.note(mesh.name() + ": " + info.warnings[i]);
    }
    if (m.without_area != 0) std::cout << "odd: " << m.without_area << " triangles without area\n";

    report.parameters["format"] = info.format;
    report.parameters["columns"] = columns;
    report.parameters["face_columns"] = face_columns;
    report.counts["vertices"] = info.vertex_count;
    report.counts["faces"] = info.polygon_count;
    report.counts["triangles"] = info.triangle_count;
    report.counts["regions"] = info.region_count;
    report.counts["without_area"] = m.without_area;
    report.quality["area"] = m.area;
    report.quality["edge_length"] = {{"min", m.shortest_edge}, {"max", m.max_edge}};
    report.quality["box"] = {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

}  // namespace flg::cli
