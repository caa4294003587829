// SPDX-License-Identifier: MIT
// Meshes that the tests of surfaces are made of.
#pragma once

#include "curves.h"

namespace flg::render::test {

struct Mesh {
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec4> colors;
    std::vector<uint32_t> triangles, regions;
    std::vector<FlgColumn> columns;

    FlgMeshView view() {
        columns = {{FLG_ATTRIBUTE_POSITION, 3, &positions[0].x, 0, 0}};
        if (!normals.empty()) columns.push_back({FLG_ATTRIBUTE_NORMAL, 3, &normals[0].x, 0, 0});
        if (!colors.empty()) columns.push_back({FLG_ATTRIBUTE_COLOR, 4, &colors[0].x, 0, 0});
        FlgMeshView v{};
        v.struct_size = sizeof v;
        v.vertex_count = static_cast<uint32_t>(positions.size());
        v.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
        v.columns = columns.data();
        v.column_count = static_cast<uint32_t>(columns.size());
        v.triangles = triangles.data();
        v.regions = regions.empty() ? nullptr : regions.data();
        return v;
    }
};

// columns x rows squares, two triangles each, centred, facing +z at the height z.
inline Mesh sheet(float width, float height, uint32_t columns, uint32_t rows, float z = 0.0f) {
    Mesh mesh;
    for (uint32_t row = 0; row <= rows; ++row)
        for (uint32_t column = 0; column <= columns; ++column)
            mesh.positions.emplace_back(width * (static_cast<float>(column) / static_cast<float>(columns) - 0.5f),
                                        height * (static_cast<float>(row) / static_cast<float>(rows) - 0.5f), z);
    for (uint32_t row = 0; row < rows; ++row)
        for (uint32_t column = 0; column < columns; ++column) {
            const uint32_t a = row * (columns + 1) + column, b = a + 1, c = b + columns + 1, d = c - 1;
            mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, c, d});
        }
    return mesh;
}

// By longitude and latitude; vertices are repeated at the seam and the poles.
inline Mesh sphere(float radius, uint32_t steps) {
    Mesh mesh;
    for (uint32_t row = 0; row <= steps; ++row)
        for (uint32_t column = 0; column <= 2 * steps; ++column) {
            const float polar = pi * static_cast<float>(row) / static_cast<float>(steps);
            const float angle = pi * static_cast<float>(column) / static_cast<float>(steps);
            const glm::vec3 out(std::sin(polar) * std::sin(angle), std::cos(polar), std::sin(polar) * std::cos(angle));
            mesh.positions.push_back(radius * out);
        }
    for (uint32_t row = 0; row < steps; ++row)
        for (uint32_t column = 0; column < 2 * steps; ++column) {
            const uint32_t a = row * (2 * steps + 1) + column, b = a + 1, d = a + 2 * steps + 1, c = d + 1;
            mesh.triangles.insert(mesh.triangles.end(), {a, d, c, a, c, b});
        }
    return mesh;
}

// Where the picture of front_camera() shows a point of the plane z = 0.
inline glm::ivec2 pixel_of(float x, float y) {
    return {static_cast<int>(std::floor(0.5f * picture_size + x * pixels_per_metre())),
            static_cast<int>(std::floor(0.5f * picture_size - y * pixels_per_metre()))};
}

inline int max_difference(const uint8_t* a, const uint8_t* b) {
    int most = 0;
    for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

inline int brightness(const uint8_t* pixel) {
    return pixel[0] + pixel[1] + pixel[2];
}

}  // namespace flg::render::test
