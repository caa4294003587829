// SPDX-License-Identifier: MIT
#include "gallery/marks.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "support/curve_source.h"

namespace flg::gallery {

scenes::Curve dot(const glm::vec3& at) {
    constexpr float kLength = 1e-5f;
    scenes::Curve ball;
    ball.points = {to_point(at), {at.x + kLength, at.y, at.z}};
    return ball;
}

std::vector<glm::vec3> vectors_of(const FlgCurveSetView& curves, FlgAttribute attribute) {
    const FlgColumn& column = *samples::find_column(curves, attribute);
    std::vector<glm::vec3> vectors;
    for (uint32_t i = 0; i < curves.curve_offsets[curves.curve_count]; ++i) {
        vectors.push_back(glm::make_vec3(samples::value_at(column, i)));
    }
    return vectors;
}

std::vector<glm::vec3> places_on(const FlgCurveSetView& curve, std::span<const float> lengths) {
    const std::vector<glm::vec3> points = vectors_of(curve);
    std::vector<glm::vec3> places;
    uint32_t i = 0;
    float before = 0.0f;  // length up to point i
    for (const float length : lengths) {
        float step = glm::distance(points[i], points[i + 1]);
        for (; i + 2 < curve.curve_offsets[1] && before + step < length;
             step = glm::distance(points[i], points[i + 1])) {
            before += step;
            ++i;
        }
        places.push_back(glm::mix(points[i], points[i + 1], std::clamp((length - before) / step, 0.0f, 1.0f)));
    }
    return places;
}

std::vector<glm::vec3> around(const glm::vec3& center, float reach) {
    std::vector<glm::vec3> corners;
    for (int i = 0; i < 8; ++i) {
        corners.push_back(center + reach * glm::vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
    }
    return corners;
}

scenes::Curve wave() {
    scenes::Curve curve;
    for (int i = 0; i < 200; ++i) {
        const double u = i / 199.0 - 0.5;
        curve.points.push_back({static_cast<float>(1.6 * u), static_cast<float>(0.25 * std::sin(9.0 * u)), 0.0f});
    }
    return curve;
}

scenes::Curve moved(scenes::Curve curve, const glm::vec3& by) {
    for (scenes::Point& p : curve.points) p = {p.x + by.x, p.y + by.y, p.z + by.z};
    return curve;
}

}  // namespace flg::gallery
