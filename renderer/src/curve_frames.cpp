// SPDX-License-Identifier: MIT
// Wang, Juettler, Zheng, Liu: Computation of Rotation Minimizing Frames, ACM TOG 2008, section 4.
#include <cmath>

#include "curve_data.h"

namespace flg::render {
namespace {

glm::vec3 unit(glm::vec3 v) {
    const float size = glm::length(v);
    return size > 0.0f ? v / size : v;
}

glm::vec3 reflect_across(glm::vec3 v, glm::vec3 mirror_normal) {
    const float square = glm::dot(mirror_normal, mirror_normal);
    return square > 0.0f ? v - mirror_normal * (2.0f * glm::dot(v, mirror_normal) / square) : v;
}

glm::vec3 any_normal(glm::vec3 tangent) {
    // The axis that the tangent is least along; y first, so that ribbons of level curves lie flat.
    const glm::vec3 axis = std::abs(tangent.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
    return unit(axis - tangent * glm::dot(axis, tangent));
}

}  // namespace

void carry_normals(const glm::vec3* positions, uint32_t count, bool closed, glm::vec3* out_normals) {
    const auto tangent_at = [&](uint32_t i) {
        const uint32_t before = i > 0 ? i - 1 : closed ? count - 2 : 0;
        const uint32_t after = i + 1 < count ? i + 1 : closed ? 1 : i;
        const glm::vec3 in = i > 0 || closed ? unit(positions[i] - positions[before]) : glm::vec3(0);
        const glm::vec3 out = i + 1 < count || closed ? unit(positions[after] - positions[i]) : glm::vec3(0);
        const glm::vec3 sum = in + out;
        return glm::dot(sum, sum) > 1e-6f ? unit(sum) : in;  // a full turn back keeps the way in
    };
    glm::vec3 tangent = tangent_at(0);
    out_normals[0] = any_normal(tangent);
    for (uint32_t i = 0; i + 1 < count; ++i) {
        const glm::vec3 chord = unit(positions[i + 1] - positions[i]);
        const glm::vec3 normal_left = reflect_across(out_normals[i], chord);
        const glm::vec3 tangent_left = reflect_across(tangent, chord);
        tangent = tangent_at(i + 1);
        const glm::vec3 next = reflect_across(normal_left, tangent - tangent_left);
        const glm::vec3 level = next - tangent * glm::dot(next, tangent);
        out_normals[i + 1] = glm::dot(level, level) > 1e-8f ? unit(level) : any_normal(tangent);
    }
    if (!closed || count < 3) return;
    const glm::vec3 last = out_normals[count - 1];
    const float twist = std::atan2(glm::dot(glm::cross(last, out_normals[0]), tangent), glm::dot(last, out_normals[0]));
    for (uint32_t i = 0; i < count; ++i) {
        const float angle = twist * static_cast<float>(i) / static_cast<float>(count - 1);
        const glm::vec3 across = glm::cross(tangent_at(i), out_normals[i]);
        out_normals[i] = std::cos(angle) * out_normals[i] + std::sin(angle) * across;
    }
}

}  // namespace flg::render
