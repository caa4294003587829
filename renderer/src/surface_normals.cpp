// SPDX-License-Identifier: MIT
#include "surface_normals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace flg::render {
namespace {

constexpr float half_pi = 1.57079633f;
// Cosines of the angle between a side's normal and that of all sides, about half the angle that the surface bends by:
// up to the first it is smooth, from the second on a crease.
constexpr float cosine_smooth = 0.985f, cosine_creased = 0.940f;

// atan(q) of q in 0 to 1 within 1e-5: Abramowitz, Stegun, Handbook of Mathematical Functions, 4.4.49.
float arc_tangent(float q) {
    const float q2 = q * q;
    return q * (0.9998660f + q2 * (-0.3302995f + q2 * (0.1801410f + q2 * (-0.0851330f + q2 * 0.0208351f))));
}

// The angle, 0 to pi, of a direction (cosine, sine) of any length but zero; sine >= 0.
float angle_of(float cosine, float sine) {
    const float size = std::abs(cosine);
    const float acute = sine <= size ? arc_tangent(sine / size) : half_pi - arc_tangent(size / sine);
    return cosine < 0.0f ? 2.0f * half_pi - acute : acute;
}

}  // namespace

std::vector<glm::vec3> vertex_normals(std::span<const glm::vec3> positions, std::span<const uint32_t> triangles) {
    std::vector<glm::vec3> normals(positions.size(), glm::vec3(0.0f));
    for (size_t at = 0; at < triangles.size(); at += 3) {
        const std::array<uint32_t, 3> corners = {triangles[at], triangles[at + 1], triangles[at + 2]};
        std::array<glm::vec3, 3> edges;  // edge k: from corner k to the next
        float longest = 0.0f;
        for (int k = 0; k < 3; ++k) {
            edges[k] = positions[corners[(k + 1) % 3]] - positions[corners[k]];
            for (int i = 0; i < 3; ++i) longest = std::max(longest, std::abs(edges[k][i]));
        }
        // To its own size first: products of metres near 1e30 or 1e-20 leave the range of floats.
        const float scale = 1.0f / longest;
        if (!(scale < INFINITY)) continue;
        for (glm::vec3& edge : edges) edge *= scale;
        const glm::vec3 cross = glm::cross(edges[0], edges[1]);
        const float area2 = glm::length(cross);
        if (!(area2 > 0.0f)) continue;
        for (int k = 0; k < 3; ++k) {
            const float angle = angle_of(-glm::dot(edges[k], edges[(k + 2) % 3]), area2);
            normals[corners[k]] += cross * (angle / area2);
        }
    }
    return normals;
}

std::vector<glm::vec3> creased_normals(std::span<const glm::vec3> positions, std::span<const uint32_t> triangles,
                                       std::span<const uint32_t> copied) {
    std::vector<glm::vec3> normals = vertex_normals(positions, triangles);
    const size_t first_copy = positions.size() - copied.size();
    // Sums over sides are those over all triangles around.
    std::vector<glm::vec3> sums(normals.begin(), normals.begin() + static_cast<ptrdiff_t>(first_copy));
    std::vector<uint8_t> has_sides(first_copy, 0);
    for (size_t i = 0; i < copied.size(); ++i) {
        sums[copied[i]] += normals[first_copy + i];
        has_sides[copied[i]] = 1;
    }
    for (size_t i = 0; i < normals.size(); ++i) {
        const size_t source = i < first_copy ? i : copied[i - first_copy];
        if (!has_sides[source]) continue;
        const glm::vec3 sum = sums[source];
        const float sizes = glm::length(normals[i]) * glm::length(sum);
        const float cosine = sizes > 0.0f ? glm::dot(normals[i], sum) / sizes : 1.0f;
        const float crease = std::clamp((cosine_smooth - cosine) / (cosine_smooth - cosine_creased), 0.0f, 1.0f);
        if (sizes > 0.0f) {
            normals[i] = glm::mix(glm::normalize(sum), glm::normalize(normals[i]), crease);
        } else {
            normals[i] = sum;
        }
    }
    return normals;
}

}  // namespace flg::render
