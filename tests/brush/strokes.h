// SPDX-License-Identifier: MIT
// Curves with columns, and what a brush makes of them, with the checks that any surface takes.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <numbers>
#include <set>
#include <vector>

#include "core/vec.h"
#include "filigree/filigree_brush.h"

namespace flg::test {

constexpr double pi = std::numbers::pi;

struct Stroke {
    std::vector<float> positions, radii, colors, normals;
    std::vector<uint32_t> offsets = {0};
    std::vector<uint8_t> flags;
    std::vector<FlgColumn> columns;
    FlgCurveSetView view = flgCurveSetViewDefaults();

    Stroke& add(const Vec3& p) {
        for (int k = 0; k < 3; ++k) positions.push_back(static_cast<float>(p[k]));
        return *this;
    }
    Stroke& add(const Vec3& p, double radius) {
        radii.push_back(static_cast<float>(radius));
        return add(p);
    }
    Stroke& end(bool closed = false) {
        offsets.push_back(static_cast<uint32_t>(positions.size() / 3));
        flags.push_back(closed ? FLG_CURVE_CLOSED : 0);
        columns = {{FLG_ATTRIBUTE_POSITION, 3, positions.data(), 0, 0}};
        if (!radii.empty()) columns.push_back({FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0});
        if (!colors.empty()) columns.push_back({FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0});
        if (!normals.empty()) columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, normals.data(), 0, 0});
        view.curve_count = static_cast<uint32_t>(flags.size());
        view.curve_offsets = offsets.data();
        view.curve_flags = flags.data();
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
        return *this;
    }
    uint32_t size() const { return static_cast<uint32_t>(positions.size() / 3); }
};

inline FlgBrushMeshDesc desc_of(const Stroke& stroke, FlgBrushShape shape = FLG_BRUSH_SHAPE_TUBE) {
    FlgBrushMeshDesc desc = flgBrushMeshDefaults();
    desc.curves = &stroke.view;
    desc.shape = shape;
    return desc;
}

struct Vertex {
    float position[3], normal[3], tangent[4], color[4], uv[2];
};

struct BrushMesh {
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;

    Vec3 position(uint32_t v) const { return load_vec3(vertices[v].position); }
    Vec3 normal(uint32_t v) const { return load_vec3(vertices[v].normal); }
    Vec3 corner(size_t i) const { return position(indices[i]); }

    double volume() const {
        double sum = 0;
        for (size_t i = 0; i < indices.size(); i += 3) sum += corner(i).dot(corner(i + 1).cross(corner(i + 2))) / 6;
        return sum;
    }
    double area() const {
        double sum = 0;
        for (size_t i = 0; i < indices.size(); i += 3)
            sum += (corner(i + 1) - corner(i)).cross(corner(i + 2) - corner(i)).norm() / 2;
        return sum;
    }

    using Place = std::array<float, 3>;
    Place place(uint32_t index) const {
        const float* p = vertices[index].position;
        return {p[0] + 0.0f, p[1] + 0.0f, p[2] + 0.0f};  // no negative zeros
    }
    // By place, without triangles that shrink to a line: every edge once in each direction.
    bool closed() const {
        std::map<std::pair<Place, Place>, int> edges;
        for (size_t i = 0; i < indices.size(); i += 3) {
            for (size_t k = 0; k < 3; ++k) {
                const Place a = place(indices[i + k]), b = place(indices[i + (k + 1) % 3]);
                if (a == b) continue;
                ++edges[{a, b}];
                --edges[{b, a}];
            }
        }
        for (const auto& [edge, count] : edges) {
            if (count != 0) return false;
        }
        return !edges.empty();
    }
    // Vertices - edges + faces, by place.
    int euler() const {
        std::set<Place> places;
        std::set<std::pair<Place, Place>> edges;
        int faces = 0;
        for (size_t i = 0; i < indices.size(); i += 3) {
            const Place t[] = {place(indices[i]), place(indices[i + 1]), place(indices[i + 2])};
            if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
            ++faces;
            for (int k = 0; k < 3; ++k) {
                places.insert(t[k]);
                edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
            }
        }
        return static_cast<int>(places.size()) - static_cast<int>(edges.size()) + faces;
    }
};

inline std::vector<FlgBufferColumn> columns_of(std::vector<Vertex>& vertices, bool uv) {
    Vertex* const first = vertices.data();
    std::vector<FlgBufferColumn> columns = {
        {FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, first->position, sizeof(Vertex), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_NORMAL, FLG_NUMBER_FORMAT_FLOAT32, first->normal, sizeof(Vertex), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_TANGENT, FLG_NUMBER_FORMAT_FLOAT32, first->tangent, sizeof(Vertex), 0, {}, 0, 0},
        {FLG_ATTRIBUTE_COLOR, FLG_NUMBER_FORMAT_FLOAT32, first->color, sizeof(Vertex), 0, {}, 0, 0}};
    if (uv) columns.push_back({FLG_ATTRIBUTE_UV, FLG_NUMBER_FORMAT_FLOAT32, first->uv, sizeof(Vertex), 0, {}, 0, 0});
    return columns;
}

// Checks what holds for every mesh: the sizes, unit normals, tangents across them.
inline BrushMesh mesh_of(const FlgBrushMeshDesc& desc) {
    FlgBrushMeshSizes sizes = flgBrushMeshSizesDefaults();
    EXPECT_EQ(flgBrushMeshGetSizes(&desc, nullptr, &sizes), FLG_OK) << flgErrorGetMessage();
    BrushMesh mesh;
    // One more of each, which nothing may touch.
    Vertex untouched;
    std::memset(&untouched, 0x5a, sizeof untouched);
    mesh.vertices.assign(sizes.vertex_count + 1, untouched);
    mesh.indices.assign(sizes.index_count + 1, 0x5a5a5a5a);
    const auto columns = columns_of(mesh.vertices, desc.uv != 0);
    FlgBrushMeshOutput output = flgBrushMeshOutputDefaults();
    output.columns = columns.data();
    output.column_count = static_cast<uint32_t>(columns.size());
    output.vertex_capacity = sizes.vertex_count;
    output.indices = mesh.indices.data();
    output.index_capacity = sizes.index_count;
    FlgBrushMeshSizes written = flgBrushMeshSizesDefaults();
    EXPECT_EQ(flgBrushMeshWrite(&desc, nullptr, &output, &written), FLG_OK) << flgErrorGetMessage();
    EXPECT_EQ(written.vertex_count, sizes.vertex_count);
    EXPECT_EQ(written.index_count, sizes.index_count);
    EXPECT_EQ(std::memcmp(&mesh.vertices.back(), &untouched, sizeof untouched), 0);
    EXPECT_EQ(mesh.indices.back(), 0x5a5a5a5au);
    mesh.vertices.pop_back();
    mesh.indices.pop_back();
    for (const uint32_t index : mesh.indices) EXPECT_LT(index, sizes.vertex_count);
    for (const Vertex& v : mesh.vertices) {
        const Vec3 normal = load_vec3(v.normal), tangent = load_vec3(v.tangent);
        EXPECT_NEAR(normal.norm(), 1, 1e-5);
        EXPECT_NEAR(tangent.norm(), 1, 1e-5);
        EXPECT_NEAR(normal.dot(tangent), 0, desc.hard_normals ? 1 : 1e-5);
        EXPECT_EQ(std::abs(v.tangent[3]), 1);
        EXPECT_TRUE(load_vec3(v.position).allFinite());
    }
    return mesh;
}

// A bent curve that lies in no plane, with radii that change.
inline Vec3 bent(double u) {
    return Vec3(std::cos(4 * u) + 0.3 * u, std::sin(5 * u), 0.8 * u * u + 0.2 * std::sin(9 * u));
}
inline Stroke bent_stroke(uint32_t count = 60) {
    Stroke stroke;
    for (uint32_t i = 0; i < count; ++i) {
        const double u = 2.0 * i / count;
        stroke.add(bent(u), 0.02 + 0.01 * std::sin(7 * u));
        for (const double c : {0.5 + 0.5 * std::sin(u), 0.25, 0.1 * u, 1.0})
            stroke.colors.push_back(static_cast<float>(c));
    }
    stroke.end();
    return stroke;
}

}  // namespace flg::test
