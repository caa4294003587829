// SPDX-License-Identifier: MIT
// Meshes for the tests of surfaces behind the C ABI, and what is asked of every surface.
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>

#include "api/host.h"
#include "filigree/filigree_surface.h"

namespace flg::test {

using Point = std::array<double, 3>;

inline double distance(const Point& a, const Point& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

// A mesh of the host, and the view of it.
struct MeshArrays {
    std::vector<float> positions;
    std::vector<uint32_t> triangles;
    std::vector<uint32_t> regions;
    std::vector<FlgColumn> further_columns;
    std::vector<FlgColumn> columns;

    void add_vertex(double x, double y, double z) {
        for (double value : {x, y, z}) positions.push_back(static_cast<float>(value));
    }
    void add_triangle(uint32_t a, uint32_t b, uint32_t c) { triangles.insert(triangles.end(), {a, b, c}); }
    uint32_t vertex_count() const { return static_cast<uint32_t>(positions.size() / 3); }
    uint32_t triangle_count() const { return static_cast<uint32_t>(triangles.size() / 3); }
    Point vertex(uint32_t v) const { return {positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]}; }
    Point centre(uint32_t t) const {
        Point sum{};
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < 3; ++i) sum[i] += vertex(triangles[3 * t + k])[i] / 3;
        }
        return sum;
    }
    void set_regions(const std::function<uint32_t(const Point&)>& region_at) {
        regions.clear();
        for (uint32_t t = 0; t < triangle_count(); ++t) regions.push_back(region_at(centre(t)));
    }
    FlgMeshView view() {
        FlgMeshView view = flgMeshViewDefaults();
        columns = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0}};
        columns.insert(columns.end(), further_columns.begin(), further_columns.end());
        view.vertex_count = vertex_count();
        view.triangle_count = triangle_count();
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        view.triangles = triangles.data();
        view.regions = regions.empty() ? nullptr : regions.data();
        return view;
    }
};

// cells x cells squares of two triangles each, over [0, 1]^2; vertex (i, j) has the number j * (across + 1) + i, or, if
// the last column is joined to the first, j * across + i.
inline MeshArrays grid(uint32_t across, uint32_t up, const std::function<Point(double, double)>& place,
                       bool joined = false) {
    MeshArrays mesh;
    const uint32_t row = joined ? across : across + 1;
    for (uint32_t j = 0; j <= up; ++j) {
        for (uint32_t i = 0; i < row; ++i) {
            const Point p = place(double(i) / across, double(j) / up);
            mesh.add_vertex(p[0], p[1], p[2]);
        }
    }
    for (uint32_t j = 0; j < up; ++j) {
        for (uint32_t i = 0; i < across; ++i) {
            const uint32_t a = j * row + i, b = j * row + (i + 1) % row;
            mesh.add_triangle(a, b, b + row);
            mesh.add_triangle(a, b + row, a + row);
        }
    }
    return mesh;
}

// [0, 1]^2 at z = 0, seen from above.
inline MeshArrays plane(uint32_t cells) {
    return grid(cells, cells, [](double x, double y) { return Point{x, y, 0}; });
}

// About the z axis: radius 1, height 2, open at both ends.
inline MeshArrays cylinder(uint32_t around, uint32_t up) {
    return grid(
        around, up,
        [](double u, double v) {
            return Point{std::cos(2 * M_PI * u), std::sin(2 * M_PI * u), 2 * v};
        },
        true);
}

// [0, 1]^3, each side of cells x cells squares; vertices of the sides are apart.
inline MeshArrays cube(uint32_t cells) {
    MeshArrays mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (int end = 0; end < 2; ++end) {
            const MeshArrays side = grid(cells, cells, [&](double u, double v) {
                Point p;
                p[axis] = end;
                p[(axis + 1) % 3] = end ? u : v;
                p[(axis + 2) % 3] = end ? v : u;
                return p;
            });
            const uint32_t first = mesh.vertex_count();
            mesh.positions.insert(mesh.positions.end(), side.positions.begin(), side.positions.end());
            for (uint32_t v : side.triangles) mesh.triangles.push_back(first + v);
        }
    }
    return mesh;
}

// The unit sphere: the cube's points moved along its radii.
inline MeshArrays sphere(uint32_t cells) {
    MeshArrays mesh = cube(cells);
    for (uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        Point p = mesh.vertex(v);
        for (double& x : p) x = std::tan(M_PI / 4 * (2 * x - 1));
        const double size = distance(p, {});
        for (int i = 0; i < 3; ++i) mesh.positions[3 * v + i] = static_cast<float>(p[i] / size);
    }
    return mesh;
}

// Triangles with nothing in common, in a row along x.
inline MeshArrays loose_triangles(uint32_t count) {
    MeshArrays mesh;
    for (uint32_t i = 0; i < count; ++i) {
        mesh.add_vertex(2.0 * i, 0, 0);
        mesh.add_vertex(2.0 * i + 1, 0, 0);
        mesh.add_vertex(2.0 * i, 1, 0);
        mesh.add_triangle(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return mesh;
}

inline Point vertex_at(const FlgSurfaceView& view, uint32_t vertex) {
    const float* p = view.mesh->columns[0].data + 3 * size_t{vertex};
    return {p[0], p[1], p[2]};
}

inline Point point_at(const FlgSurfaceView& view, const FlgSurfacePoint& point) {
    const double weights[] = {1.0 - point.u - point.v, point.u, point.v};
    Point sum{};
    for (int k = 0; k < 3; ++k) {
        const Point corner = vertex_at(view, view.mesh->triangles[3 * size_t{point.triangle} + k]);
        for (int i = 0; i < 3; ++i) sum[i] += weights[k] * corner[i];
    }
    return sum;
}

inline double area_of(const FlgSurfaceView& view, uint32_t triangle) {
    const uint32_t* t = view.mesh->triangles + 3 * size_t{triangle};
    const Point a = vertex_at(view, t[0]), b = vertex_at(view, t[1]), c = vertex_at(view, t[2]);
    const Point u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    return 0.5 * distance({u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]}, {});
}

// The areas of the regions, by label.
inline std::map<uint32_t, double> areas(const FlgSurfaceView& view) {
    std::map<uint32_t, double> areas;
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) areas[view.mesh->regions[t]] += area_of(view, t);
    return areas;
}

// Indices exist, edges have one or two triangles of one winding and are what the neighbours say, values are finite.
inline void expect_valid(const FlgSurfaceView& view) {
    const FlgMeshView& mesh = *view.mesh;
    ASSERT_GT(mesh.triangle_count, 0u);
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> triangle_at;
    std::vector<bool> is_used(mesh.vertex_count);
    for (uint32_t t = 0; t < mesh.triangle_count; ++t) {
        EXPECT_LE(mesh.regions[t], FLG_REGION_MAX);
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t a = mesh.triangles[3 * t + k], b = mesh.triangles[3 * t + (k + 1) % 3];
            ASSERT_LT(a, mesh.vertex_count);
            ASSERT_NE(a, b) << "triangle " << t;
            is_used[a] = true;
            EXPECT_TRUE(triangle_at.insert({{a, b}, t}).second) << "edge " << a << "-" << b;
        }
    }
    for (const auto& [edge, t] : triangle_at) {
        const uint32_t* corners = mesh.triangles + 3 * size_t{t};
        const uint32_t k = corners[0] == edge.first ? 0 : corners[1] == edge.first ? 1 : 2;
        const auto across = triangle_at.find({edge.second, edge.first});
        EXPECT_EQ(view.neighbours[3 * t + k], across == triangle_at.end() ? FLG_NO_INDEX : across->second);
    }
    EXPECT_EQ(std::count(is_used.begin(), is_used.end(), false), 0);
    for (uint32_t c = 0; c < mesh.column_count; ++c) {
        for (size_t i = 0; i < size_t{mesh.vertex_count} * mesh.columns[c].components; ++i) {
            ASSERT_TRUE(std::isfinite(mesh.columns[c].data[i])) << "column " << c << ", value " << i;
        }
    }
}

template <class T>
void append(std::string& all, const T* values, size_t count) {
    if (values) all.append(reinterpret_cast<const char*>(values), count * sizeof(T));
}

// All bits, to compare.
inline std::string bits(const FlgSurfaceView& view) {
    std::string all;
    append(all, view.mesh->triangles, size_t{3} * view.mesh->triangle_count);
    append(all, view.neighbours, size_t{3} * view.mesh->triangle_count);
    append(all, view.mesh->regions, view.mesh->triangle_count);
    for (uint32_t c = 0; c < view.mesh->column_count; ++c) {
        append(all, view.mesh->columns[c].data, size_t{view.mesh->vertex_count} * view.mesh->columns[c].components);
    }
    return all;
}
inline std::string bits(const FlgFieldView& view) {
    std::string all;
    append(all, view.values, view.vertex_count);
    append(all, view.labels, view.vertex_count);
    append(all, view.samples, view.sample_count);
    return all;
}
inline std::string bits(const FlgSurfaceCurvesView& view) {
    std::string all;
    append(all, view.curve_offsets, view.curve_count + 1);
    append(all, view.curve_flags, view.curve_count);
    append(all, view.curve_values, view.curve_count);
    append(all, view.points, view.curve_offsets[view.curve_count]);
    return all;
}

// A host with surfaces: what succeeds is asked for in one line.
class SurfaceHost : public Host {
public:
    using Host::Host;

    FlgSurface start_surface(MeshArrays mesh, float weld_distance = 0) const {
        FlgSurfaceDesc desc = flgSurfaceDefaults();
        desc.weld_distance = weld_distance;
        const FlgMeshView input = mesh.view();
        desc.mesh = &input;
        FlgSurface surface{};
        EXPECT_EQ(flgSurfaceCreate(context, &desc, &surface, nullptr), FLG_OK) << flgErrorGetMessage();
        return surface;
    }
    FlgSurface surface(MeshArrays mesh, float weld_distance = 0) const {
        const FlgSurface surface = start_surface(std::move(mesh), weld_distance);
        finish();
        return surface;
    }
    FlgField field(FlgSurface surface, const std::function<double(const Point&)>& value_at) const {
        const FlgSurfaceView shown = view(surface);
        std::vector<float> values;
        for (uint32_t v = 0; v < shown.mesh->vertex_count; ++v) {
            values.push_back(static_cast<float>(value_at(vertex_at(shown, v))));
        }
        FlgField field{};
        EXPECT_EQ(flgFieldCreate(context, surface, values.data(), shown.mesh->vertex_count, &field), FLG_OK)
            << flgErrorGetMessage();
        return field;
    }
    FlgField start_distances(FlgSurface surface, uint32_t vertex) const {
        FlgFieldGeodesicDesc desc = flgFieldGeodesicDefaults();
        desc.surface = surface;
        desc.vertices = &vertex;
        desc.vertex_count = 1;
        return start(desc);
    }
    FlgField start(const FlgFieldGeodesicDesc& desc, FlgJob* job = nullptr) const {
        FlgField field{};
        EXPECT_EQ(flgFieldCreateGeodesic(context, &desc, &field, job), FLG_OK) << flgErrorGetMessage();
        return field;
    }
    FlgField solve(const FlgFieldGeodesicDesc& desc) const {
        const FlgField field = start(desc);
        finish();
        return field;
    }
    FlgSurfaceCurves start_isolines(FlgField field, const std::vector<float>& levels) const {
        FlgFieldTraceIsolinesDesc desc = flgFieldTraceIsolinesDefaults();
        desc.field = field;
        desc.levels = levels.data();
        desc.level_count = static_cast<uint32_t>(levels.size());
        FlgSurfaceCurves curves{};
        EXPECT_EQ(flgFieldTraceIsolines(context, &desc, &curves, nullptr), FLG_OK) << flgErrorGetMessage();
        return curves;
    }
    FlgSurfaceCurves isolines(FlgField field, const std::vector<float>& levels) const {
        const FlgSurfaceCurves curves = start_isolines(field, levels);
        finish();
        return curves;
    }
    FlgSurfaceView view(FlgSurface surface) const {
        FlgSurfaceView view = flgSurfaceViewDefaults();
        EXPECT_EQ(flgSurfaceGetView(context, surface, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
    FlgFieldView view(FlgField field) const {
        FlgFieldView view = flgFieldViewDefaults();
        EXPECT_EQ(flgFieldGetView(context, field, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
    FlgSurfaceCurvesView view(FlgSurfaceCurves curves) const {
        FlgSurfaceCurvesView view = flgSurfaceCurvesViewDefaults();
        EXPECT_EQ(flgSurfaceCurvesGetView(context, curves, &view), FLG_OK) << flgErrorGetMessage();
        return view;
    }
    FlgSurfaceReport report(FlgSurface surface) const {
        FlgSurfaceReport report{};
        report.struct_size = sizeof report;
        EXPECT_EQ(flgSurfaceGetReport(context, surface, &report), FLG_OK) << flgErrorGetMessage();
        return report;
    }
    std::vector<uint32_t> changes(FlgSurface surface, uint32_t since) const {
        uint32_t count = 0;
        EXPECT_EQ(flgSurfaceGetChanges(context, surface, since, nullptr, 0, &count), FLG_OK) << flgErrorGetMessage();
        std::vector<uint32_t> triangles(count);
        EXPECT_EQ(flgSurfaceGetChanges(context, surface, since, triangles.data(), count, &count), FLG_OK);
        return triangles;
    }
};

// Root of the mean square of the relative errors of the distances, where they are not 0.
inline double relative_error(const FlgSurfaceView& surface, const FlgFieldView& field,
                             const std::function<double(const Point&)>& exact) {
    double sum = 0;
    uint32_t count = 0;
    for (uint32_t v = 0; v < field.vertex_count; ++v) {
        const double expected = exact(vertex_at(surface, v));
        if (expected == 0) continue;
        const double error = field.values[v] / expected - 1;
        sum += error * error;
        ++count;
    }
    return std::sqrt(sum / count);
}

// The triangle of the surface, of those seen from above, that holds (x, y), and where in it.
inline FlgSurfacePoint point_above(const FlgSurfaceView& view, double x, double y) {
    for (uint32_t t = 0; t < view.mesh->triangle_count; ++t) {
        const uint32_t* corners = view.mesh->triangles + 3 * size_t{t};
        const Point a = vertex_at(view, corners[0]), b = vertex_at(view, corners[1]), c = vertex_at(view, corners[2]);
        const double whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        const double u = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / whole;
        const double v = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / whole;
        if (u >= -1e-9 && v >= -1e-9 && u + v <= 1 + 1e-9) return {t, static_cast<float>(u), static_cast<float>(v)};
    }
    ADD_FAILURE() << "no triangle at " << x << ", " << y;
    return {};
}

}  // namespace flg::test
