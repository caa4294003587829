// SPDX-License-Identifier: MIT
// Curves in space that operations of scripts make, to be laid onto a surface.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "documents/report.h"
#include "documents/session.h"
#include "filigree/filigree_project.h"

namespace flg::cli {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(double t, const Vector& a) {
    return {t * a[0], t * a[1], t * a[2]};
}
inline double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
// 0 where there is no direction.
Vector unit(const Vector& a);

Vector vertex_at(const FlgMeshView& mesh, uint32_t vertex);
inline Vector origin_of(const FlgMeshView& mesh) {
    return {mesh.origin[0], mesh.origin[1], mesh.origin[2]};
}
// Twice the triangle's area, along its normal.
Vector area_vector(const FlgMeshView& mesh, uint32_t triangle);

struct SpaceLines {
    std::vector<float> positions, normals;  // x, y, z a point; normals may be none
    std::vector<uint32_t> offsets = {0};
    std::vector<uint8_t> flags;
    Vector origin = {};  // metres: what positions are relative to

    uint32_t count() const { return static_cast<uint32_t>(flags.size()); }
    Vector point(uint32_t i) const { return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}; }
    void add(const Vector& point);
    void add(const Vector& point, const Vector& normal);
    void end_line(bool closed);
};

// All curves of a file. Throws InputError, as does all below; `subject` is what errors are about.
SpaceLines read_lines(const std::string& file, Report& report);

FlgCurveSet create_set(FlgContext context, const SpaceLines& lines, const std::string& subject);

FlgSurfaceCurves lay_lines(Session& session, FlgSurface surface, FlgCurveSet lines, const std::string& subject,
                           Report& report);

}  // namespace flg::cli
