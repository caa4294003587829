// SPDX-License-Identifier: MIT
#include "strokes/stroke_arrays.h"

#include <algorithm>
#include <cmath>

namespace flg::studio {
namespace {

constexpr float kLightest = 0.35f;  // the radius without pressure, of that with
constexpr float kAnyJump_m = 1e6f;
constexpr uint32_t kMaxPoints = 1u << 17;

// Turns the y axis to `normal`.
glm::vec4 orientation_of(const glm::vec3& normal) {
    const float length = glm::length(normal);
    if (!(length > 0.0f)) return {0.0f, 0.0f, 0.0f, 1.0f};
    const glm::vec3 n = normal / length;
    if (n.y < -0.9999f) return {1.0f, 0.0f, 0.0f, 0.0f};
    const glm::vec4 q(n.z, 0.0f, -n.x, 1.0f + n.y);
    return q / glm::length(q);
}

}  // namespace

StrokeArrays::StrokeArrays(std::span<const Stroke> strokes) : view_(flgCurveSetViewDefaults()) {
    for (const Stroke& stroke : strokes) {
        for (const StrokeSample& s : stroke.drawn->samples) {
            const glm::vec4 q = orientation_of(s.normal);
            positions_.insert(positions_.end(), {s.position.x, s.position.y, s.position.z});
            orientations_.insert(orientations_.end(), {q.x, q.y, q.z, q.w});
            pressures_.push_back(s.pressure);
            times_.push_back(s.time);
        }
        offsets_.push_back(static_cast<uint32_t>(pressures_.size()));
    }
    columns_ = {{FLG_ATTRIBUTE_POSITION, 3, positions_.data(), 0, 0},
                {FLG_ATTRIBUTE_ORIENTATION, 4, orientations_.data(), 0, 0},
                {FLG_ATTRIBUTE_PRESSURE, 1, pressures_.data(), 0, 0},
                {FLG_ATTRIBUTE_TIME, 1, times_.data(), 0, 0}};
    view_.curve_count = static_cast<uint32_t>(strokes.size());
    view_.curve_offsets = offsets_.data();
    view_.columns = columns_.data();
    view_.column_count = static_cast<uint32_t>(columns_.size());
}

samples::LiveSample live_sample(const StrokeSample& sample) {
    samples::LiveSample live{};
    const glm::vec4 q = orientation_of(sample.normal);
    for (int i = 0; i < 3; ++i) live.position[i] = sample.position[i];
    for (int i = 0; i < 4; ++i) live.orientation[i] = q[i];
    live.pressure = sample.pressure;
    live.time = static_cast<double>(sample.time);
    return live;
}

float swing_m(const StrokeSettings& settings) {
    constexpr float kRadiusPerSwing = 0.14f;  // as FlgLiveStrokeDesc::scale has it
    const float mean_radius = 0.5f * (1.0f + kLightest) * 0.001f * settings.radius_mm;
    return settings.scale_cm > 0.0f ? 0.01f * settings.scale_cm : mean_radius / kRadiusPerSwing;
}

FlgLiveStrokeDesc live_desc(const StrokeSettings& settings, float rms, float size) {
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    const float larger = size > 0.0f ? size : 1.0f;
    desc.magnitude = settings.styled ? settings.magnitude : 0.0f;
    desc.temperature = settings.temperature;
    desc.scale = rms > 0.0f ? 0.01f * larger * settings.scale_cm / rms : 1.0f;
    if (settings.scale_cm == 0.0f) desc.scale = 0.0f;
    desc.max_radius = 0.001f * larger * settings.radius_mm * (size > 0.0f && !settings.styled ? kThickness : 1.0f);
    desc.min_radius = size > 0.0f ? 0.0f : kLightest * desc.max_radius;
    desc.smoothing = kHandSmoothing_s;
    desc.max_jump = kAnyJump_m;
    desc.max_points = kMaxPoints;
    desc.frame = FLG_FRAME_METHOD_SUPPLIED;
    if (!settings.upright) {
        // The style's first normal becomes the second one, which lies in the surface.
        constexpr float kLying[] = {1.0f, 0.0f, 0.0f, 0.0f, 0.0f, -1.0f, 0.0f, 1.0f, 0.0f};
        std::copy(std::begin(kLying), std::end(kLying), desc.basis);
    }
    desc.seed = static_cast<uint64_t>(std::max(settings.seed, 0));
    return desc;
}

}  // namespace flg::studio
