// SPDX-License-Identifier: MIT
#include "documents/space_lines.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "documents/failure.h"
#include "filigree/filigree_io.h"

namespace flg::cli {

Vector unit(const Vector& a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? (1 / length) * a : Vector{};
}

Vector vertex_at(const FlgMeshView& mesh, uint32_t vertex) {
    const float* const at = mesh.columns[0].data + size_t{3} * vertex;
    return {at[0], at[1], at[2]};
}

Vector area_vector(const FlgMeshView& mesh, uint32_t triangle) {
    const uint32_t* const corners = mesh.triangles + size_t{3} * triangle;
    const Vector origin = vertex_at(mesh, corners[0]);
    return cross(vertex_at(mesh, corners[1]) - origin, vertex_at(mesh, corners[2]) - origin);
}

void SpaceLines::add(const Vector& point) {
    for (const double value : point) positions.push_back(static_cast<float>(value));
}

void SpaceLines::add(const Vector& point, const Vector& normal) {
    add(point);
    for (const double value : normal) normals.push_back(static_cast<float>(value));
}

void SpaceLines::end_line(bool closed) {
    offsets.push_back(static_cast<uint32_t>(positions.size() / 3));
    flags.push_back(closed ? FLG_CURVE_CLOSED : 0);
}

SpaceLines read_lines(const std::string& file, Report& report) {
    FlgCurveFile curves = nullptr;
    if (flgCurveFileRead(file.c_str(), nullptr, &curves) != FLG_OK) throw InputError(flgIoErrorGetMessage());
    FlgCurveSetView view = flgCurveSetViewDefaults();
    flgCurveFileGetView(curves, &view);
    FlgCurveFileInfo info = {};
    info.struct_size = sizeof info;
    flgCurveFileGetInfo(curves, &info);
    for (uint32_t i = 0; i < info.warning_count; ++i) report.warn(file + ": " + info.warnings[i]);
    SpaceLines lines;
    lines.offsets.assign(view.curve_offsets, view.curve_offsets + view.curve_count + 1);
    lines.flags.assign(view.curve_flags, view.curve_flags + view.curve_count);
    lines.positions.assign(view.columns[0].data, view.columns[0].data + size_t{3} * lines.offsets.back());
    std::copy(std::begin(view.origin), std::end(view.origin), lines.origin.begin());
    flgCurveFileRelease(curves);
    return lines;
}

FlgCurveSet create_set(FlgContext context, const SpaceLines& lines, const std::string& subject) {
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, lines.positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_NORMAL, 3, lines.normals.data(), 0, 0}};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = lines.count();
    view.curve_offsets = lines.offsets.data();
    view.curve_flags = lines.flags.data();
    view.columns = columns;
    view.column_count = lines.normals.empty() ? 1 : 2;
    std::copy(lines.origin.begin(), lines.origin.end(), view.origin);
    FlgCurveSet set = {};
    check(flgCurveSetCreate(context, &view, &set), subject);
    return set;
}

FlgSurfaceCurves lay_lines(Session& session, FlgSurface surface, FlgCurveSet lines, const std::string& subject,
                           Report& report) {
    FlgCurveSetProjectDesc desc;
    flgCurveSetProjectDescInit(&desc, sizeof desc);
    desc.surface = surface;
    desc.curves = lines;
    FlgSurfaceCurves laid = {};
    FlgJob job = {};
    check(flgCurveSetProject(session.context(), &desc, &laid, &job), subject);
    session.finish({{{job, subject}}}, report);
    return laid;
}

}  // namespace flg::cli
