// SPDX-License-Identifier: MIT
#include "strokes/framing.h"

#include <algorithm>
#include <vector>

#include "support/curve_source.h"

namespace flg::samples {
namespace {

constexpr glm::vec3 kSight{-0.45f, -0.22f, -1.0f};  // from the eye into the scene
constexpr float kFilled = 0.85f;                    // of the picture, by the strokes
constexpr float kWidest = static_cast<float>(kWidth) / kHeight, kNarrowest = 0.75f;

// Width over height of what the camera sees of the points.
float seen_aspect(const render::Camera& camera, std::span<const glm::vec3> points) {
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::vec3 right = glm::normalize(glm::cross(forward, camera.up));
    const glm::vec3 up = glm::cross(right, forward);
    glm::vec2 low(1e30f), high(-1e30f);
    for (const glm::vec3& point : points) {
        const glm::vec3 arm = point - camera.eye;
        const glm::vec2 seen = glm::vec2(glm::dot(arm, right), glm::dot(arm, up)) / glm::dot(arm, forward);
        low = glm::min(low, seen);
        high = glm::max(high, seen);
    }
    const glm::vec2 size = high - low;
    return size.y > 0.0f ? size.x / size.y : kWidest;
}

}  // namespace

Framing frame_strokes(std::span<const FlgCurveSetView> views) {
    std::vector<glm::vec3> points;
    for (const FlgCurveSetView& view : views) {
        const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
        for (uint32_t i = 0; i < view.curve_offsets[view.curve_count]; ++i) {
            const float* p = value_at(positions, i);
            points.emplace_back(p[0], p[1], p[2]);
        }
    }
    const render::Camera wide = render::frame_points(points, kSight, kWidest, 1.0f / kFilled);
    const float aspect = std::clamp(seen_aspect(wide, points), kNarrowest, kWidest);
    const auto width = static_cast<uint32_t>(aspect * kHeight + 0.5f);
    return {render::frame_points(points, kSight, static_cast<float>(width) / kHeight, 1.0f / kFilled), width};
}

}  // namespace flg::samples
