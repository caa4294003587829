// SPDX-License-Identifier: MIT
#include "gallery/sweep.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gallery/marks.h"
#include "support/curve_source.h"

namespace flg::gallery {
namespace {

// Corners at the same place join sides at a sharp edge.
constexpr uint32_t kNoSide = 0xffffffffu;

}  // namespace

Sweep::Sweep(const FlgCurveSetView& curves, const std::function<Section(uint32_t point)>& section) {
    const std::vector<glm::vec3> points = vectors_of(curves), normals = vectors_of(curves, FLG_ATTRIBUTE_NORMAL);
    for (uint32_t c = 0; c < curves.curve_count; ++c) {
        const uint32_t first = curves.curve_offsets[c], count = curves.curve_offsets[c + 1] - first;
        const bool closed = curves.curve_flags != nullptr && (curves.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
        const auto at = [&](int64_t i) {
            return points[first +
                          static_cast<uint32_t>(closed ? (i + count) % count : std::clamp<int64_t>(i, 0, count - 1))];
        };
        const auto ring = static_cast<uint32_t>(positions_.size());
        uint32_t corners = 0;
        for (uint32_t i = 0; i < count; ++i) {
            const glm::vec3 tangent = glm::normalize(at(int64_t{i} + 1) - at(int64_t{i} - 1)), own = normals[first + i];
            const glm::vec3 normal = glm::normalize(own - glm::dot(own, tangent) * tangent);
            const glm::vec3 binormal = glm::cross(tangent, normal);
            const Section outline = section(first + i);
            corners = static_cast<uint32_t>(outline.size());
            for (const Corner& corner : outline) {
                positions_.push_back(points[first + i] + corner.normal * normal + corner.binormal * binormal);
            }
            if (i + 1 == count && !closed) break;
            const uint32_t here = ring + i * corners, next = ring + (i + 1) % count * corners;
            for (uint32_t k = 0; k < corners; ++k) {
                if (outline[k].region == kNoSide) continue;
                const uint32_t l = (k + 1) % corners;
                triangles_.insert(triangles_.end(), {here + k, here + l, next + l, here + k, next + l, next + k});
                regions_.insert(regions_.end(), 2, outline[k].region);
            }
        }
    }
    column_ = {FLG_ATTRIBUTE_POSITION, 3, &positions_[0].x, 0, 0};
}

Sweep Sweep::ellipses(const FlgCurveSetView& curves) {
    constexpr uint32_t kCorners = 40;
    const std::vector<glm::vec3> radii = vectors_of(curves, FLG_ATTRIBUTE_RADII);
    return Sweep(curves, [&](uint32_t point) {
        const glm::vec3& r = radii[point];
        Section outline;
        for (uint32_t k = 0; k < kCorners; ++k) {
            const float a = 2.0f * std::numbers::pi_v<float> * static_cast<float>(k) / kCorners;
            const float x = r.x * std::cos(a), y = r.y * std::sin(a), c = std::cos(r.z), s = std::sin(r.z);
            outline.push_back({c * x - s * y, s * x + c * y, 0});
        }
        return outline;
    });
}

Sweep Sweep::bands(const FlgCurveSetView& curves, float thickness,
                   const std::function<float(uint32_t point)>& half_width) {
    return Sweep(curves, [=](uint32_t point) {
        const float w = half_width(point), t = 0.5f * thickness;
        return Section{{t, w, 0},   {t, -w, kNoSide}, {t, -w, 2}, {-t, -w, kNoSide},
                       {-t, -w, 1}, {-t, w, kNoSide}, {-t, w, 2}, {t, w, kNoSide}};
    });
}

FlgMeshView Sweep::view() const {
    FlgMeshView view = flgMeshViewDefaults();
    view.vertex_count = static_cast<uint32_t>(positions_.size());
    view.triangle_count = static_cast<uint32_t>(regions_.size());
    view.columns = &column_;
    view.column_count = 1;
    view.triangles = triangles_.data();
    view.regions = regions_.data();
    return view;
}

}  // namespace flg::gallery
