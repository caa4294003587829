// SPDX-License-Identifier: MIT
#include "bench/tube_mesh.h"

#include <cmath>

namespace flg::bench {

TubeMesh::TubeMesh(const std::vector<glm::vec3>& points, float radius, uint32_t sides) {
    glm::vec3 across(0.0f);
    for (size_t i = 0; i < points.size(); ++i) {
        const glm::vec3 tangent =
            glm::normalize(points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0]);
        // The normal before, made perpendicular: turns little.
        across -= tangent * glm::dot(across, tangent);
        if (glm::length(across) < 0.1f)
            across = glm::cross(tangent, std::abs(tangent.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0));
        across = glm::normalize(across);
        const glm::vec3 aside = glm::cross(tangent, across);
        for (uint32_t side = 0; side < sides; ++side) {
            const float angle = 6.2831853f * static_cast<float>(side) / static_cast<float>(sides);
            normals.push_back(std::cos(angle) * across + std::sin(angle) * aside);
            positions.push_back(points[i] + radius * normals.back());
        }
    }
    for (uint32_t ring = 0; ring + 1 < points.size(); ++ring) {
        for (uint32_t side = 0; side < sides; ++side) {
            const uint32_t a = ring * sides + side, b = ring * sides + (side + 1) % sides;
            triangles.insert(triangles.end(), {a, b, a + sides, a + sides, b, b + sides});
        }
    }
}

FlgMeshView TubeMesh::view() {
    columns = {{FLG_ATTRIBUTE_POSITION, 3, &positions[0].x, 0, 0}, {FLG_ATTRIBUTE_NORMAL, 3, &normals[0].x, 0, 0}};
    FlgMeshView view = {};
    view.struct_size = sizeof view;
    view.vertex_count = static_cast<uint32_t>(positions.size());
    view.triangle_count = static_cast<uint32_t>(triangles.size() / 3);
    view.columns = columns.data();
    view.column_count = 2;
    view.triangles = triangles.data();
    return view;
}

}  // namespace flg::bench
