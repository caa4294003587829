// SPDX-License-Identifier: MIT
#include "documents/tangle_shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "documents/failure.h"

namespace flg::cli {

namespace {

// Steeper planes than this have no upwards: there the z axis counts.
constexpr double min_upwards = 1e-3;

FlgFieldView solve(Session& session, FlgSurface surface, std::span<const uint32_t> cells, const std::string& subject,
                   Report& report, FlgField& field) {
    FlgFieldGeodesicDesc desc;
    flgFieldGeodesicDescInit(&desc, sizeof desc);
    desc.surface = surface;
    desc.border_regions = desc.regions = cells.data();
    desc.border_region_count = desc.region_count = static_cast<uint32_t>(cells.size());
    FlgJob job = {};
    check(flgFieldCreateGeodesic(session.context(), &desc, &field, &job), subject);
    session.finish({{{job, subject}}}, report);
    FlgFieldView view;
    flgFieldViewInit(&view, sizeof view);
    check(flgFieldGetView(session.context(), field, &view), subject);
    return view;
}

double signed_area(const SpaceLines& shape, uint32_t line) {
    double sum = 0;
    const uint32_t first = shape.offsets[line], end = shape.offsets[line + 1];
    for (uint32_t i = first; i < end; ++i) sum += cross(shape.point(i), shape.point(i + 1 == end ? first : i + 1))[2];
    return sum / 2;
}

// Whether a closed line encloses a point: a ray to its right crosses it an odd number of times.
bool encloses(const SpaceLines& shape, uint32_t line, const Vector& p) {
    bool inside = false;
    const uint32_t first = shape.offsets[line], end = shape.offsets[line + 1];
    for (uint32_t i = first, last = end - 1; i < end; last = i++) {
        const Vector a = shape.point(last), b = shape.point(i);
        if ((a[1] > p[1]) == (b[1] > p[1])) continue;
        if (p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])) inside = !inside;
    }
    return inside;
}

void reverse(SpaceLines& shape, uint32_t line) {
    for (uint32_t i = shape.offsets[line], j = shape.offsets[line + 1] - 1; i < j; ++i, --j) {
        std::swap_ranges(shape.positions.begin() + 3 * i, shape.positions.begin() + 3 * i + 3,
                         shape.positions.begin() + 3 * j);
    }
}

}  // namespace

std::vector<CellMiddle> find_middles(Session& session, const MeshSurface& surface, std::span<const uint32_t> cells,
                                     const std::string& subject, Report& report) {
    FlgField field = {};
    const FlgFieldView distances = solve(session, surface.handle(), cells, subject, report, field);
    const FlgMeshView& mesh = *surface.view().mesh;
    std::map<uint32_t, size_t> number;
    for (size_t c = 0; c < cells.size(); ++c) number[cells[c]] = c;
    std::vector<CellMiddle> middles(cells.size());
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        const auto found = number.find(mesh.regions[t]);
        if (found == number.end()) continue;
        CellMiddle& middle = middles[found->second];
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t vertex = mesh.triangles[3 * size_t{t} + k];
            const float distance = distances.values[vertex];
            if (!(distance > middle.radius) || !std::isfinite(distance)) continue;
            middle.vertex = vertex;
            middle.radius = distance;
        }
    }
    std::map<uint32_t, Vector> normals;
    for (const CellMiddle& middle : middles) normals[middle.vertex] = {};
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        for (uint32_t k = 0; k < 3; ++k) {
            const auto found = normals.find(mesh.triangles[3 * size_t{t} + k]);
            if (found != normals.end()) found->second = found->second + area_vector(mesh, t);
        }
    }
    for (CellMiddle& middle : middles) middle.normal = unit(normals[middle.vertex]);
    flgFieldRelease(session.context(), field);
    return middles;
}

void prepare_shape(SpaceLines& shape) {
    std::vector<bool> turned(shape.count());
    for (uint32_t line = 0; line < shape.count(); ++line) {
        uint32_t around = 0;
        for (uint32_t other = 0; other < shape.count(); ++other) {
            const bool counts = other != line && shape.flags[other] != 0;
            if (counts && encloses(shape, other, shape.point(shape.offsets[line]))) ++around;
        }
        turned[line] = shape.flags[line] != 0 && (signed_area(shape, line) > 0) != (around % 2 == 0);
    }
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Vector lower = {infinity, infinity, 0}, upper = {-infinity, -infinity, 0};
    for (uint32_t line = 0; line < shape.count(); ++line) {
        if (turned[line]) reverse(shape, line);
        for (uint32_t i = shape.offsets[line]; i < shape.offsets[line + 1]; ++i) {
            for (size_t k = 0; k < 2; ++k) {
                lower[k] = std::min(lower[k], shape.point(i)[k]);
                upper[k] = std::max(upper[k], shape.point(i)[k]);
            }
        }
    }
    const Vector middle = 0.5 * (lower + upper);
    double reach = 0;
    for (uint32_t i = 0; i < shape.offsets.back(); ++i) {
        const Vector from = shape.point(i) - middle;
        reach = std::max(reach, std::hypot(from[0], from[1]));
    }
    for (uint32_t i = 0; i < shape.offsets.back(); ++i) {
        const Vector p = reach > 0 ? (1 / reach) * (shape.point(i) - middle) : Vector{};
        for (size_t k = 0; k < 2; ++k) shape.positions[3 * i + k] = static_cast<float>(p[k]);
    }
}

void place_shape(const SpaceLines& shape, const Vector& at, const Vector& normal, double radius, double turn_rad,
                 SpaceLines& out) {
    const auto in_plane = [&](const Vector& v) { return v - dot(v, normal) * normal; };
    Vector up = in_plane({0, 1, 0});
    if (dot(up, up) < min_upwards * min_upwards) up = in_plane({0, 0, -1});
    up = unit(up);
    const Vector right = cross(up, normal);
    const double cosine = radius * std::cos(turn_rad), sine = radius * std::sin(turn_rad);
    for (uint32_t line = 0; line < shape.count(); ++line) {
        for (uint32_t i = shape.offsets[line]; i < shape.offsets[line + 1]; ++i) {
            const Vector p = shape.point(i);
            out.add(at + (cosine * p[0] - sine * p[1]) * right + (sine * p[0] + cosine * p[1]) * up);
        }
        out.end_line(shape.flags[line] != 0);
    }
}

}  // namespace flg::cli
