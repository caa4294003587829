// SPDX-License-Identifier: MIT
#include "live_strokes/recording.h"

#include <algorithm>
#include <cmath>

#include "support/curve_source.h"

namespace flg::samples {
namespace {

constexpr double kPauseS = 0.4;          // from stroke to stroke
constexpr double kSampleS = 1.0 / 90.0;  // of the session made here
constexpr float kEvenSpeed = 0.8f;       // m/s, of strokes without TIME
constexpr float kReach = 1.3f;           // metres: the largest side of a drawing
constexpr float kMinTrigger = 0.02f;     // on a stroke, however light its pressure
const glm::vec3 kMiddle(0.0f, 1.15f, -0.35f);

glm::vec3 position_of(const LiveSample& sample) {
    return {sample.position[0], sample.position[1], sample.position[2]};
}

glm::quat orientation_of(const LiveSample& sample) {
    const float* q = sample.orientation;
    const glm::quat turned(q[3], q[0], q[1], q[2]);
    return glm::length(turned) > 0.0f ? glm::normalize(turned) : glm::quat(1, 0, 0, 0);
}

void set(LiveSample& sample, glm::vec3 position, glm::quat orientation) {
    for (int i = 0; i < 3; ++i) sample.position[i] = position[i];
    sample.orientation[0] = orientation.x;
    sample.orientation[1] = orientation.y;
    sample.orientation[2] = orientation.z;
    sample.orientation[3] = orientation.w;
}

}  // namespace

Recording::Recording(const std::string& name) {
    if (name == "builtin:session") {
        draw_session();
    } else {
        load(name);
        bring_near();
    }
}

// Petals around a stem: each rises, opens outwards and comes back, the hand turning with it.
void Recording::draw_session() {
    constexpr int petals = 7;
    constexpr double petal_s = 2.6;
    double begin_s = 0.3;
    for (int petal = 0; petal < petals; ++petal) {
        const float aside = 6.2831853f * static_cast<float>(petal) * 3.0f / petals;
        Stroke stroke;
        for (double t = 0.0; t <= petal_s; t += kSampleS) {
            const auto s = static_cast<float>(t / petal_s);
            const float out = 0.04f + 0.42f * std::sin(3.1415927f * s) * (0.6f + 0.4f * s);
            const float turn = aside + 1.3f * std::sin(2.6f * s) - 0.9f * s;
            const float up = 0.72f + 0.95f * s - 0.75f * s * s * s;
            LiveSample sample = {};
            set(sample, {out * std::sin(turn), up, kMiddle.z + out * std::cos(turn)},
                glm::angleAxis(turn, glm::vec3(0, 1, 0)) * glm::angleAxis(1.2f * s - 0.4f, glm::vec3(1, 0, 0)));
            sample.pressure = std::sqrt(std::sin(3.1415927f * std::min(s + 0.01f, 0.999f)));
            sample.time = begin_s + t;
            stroke.push_back(sample);
        }
        begin_s = stroke.back().time + kPauseS;
        strokes_.push_back(std::move(stroke));
    }
}

void Recording::load(const std::string& name) {
    const CurveSource source(name);
    const FlgCurveSetView& view = source.view();
    const FlgColumn* positions = find_column(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn* orientations = find_column(view, FLG_ATTRIBUTE_ORIENTATION);
    const FlgColumn* pressures = find_column(view, FLG_ATTRIBUTE_PRESSURE);
    const FlgColumn* times = find_column(view, FLG_ATTRIBUTE_TIME);
    double begin_s = kPauseS;
    for (uint32_t c = 0; c < view.curve_count; ++c) {
        const uint32_t first = view.curve_offsets[c], last = view.curve_offsets[c + 1];
        if (last - first < 2) continue;
        Stroke stroke;
        double even_s = 0.0, time_s = 0.0;
        for (uint32_t i = first; i < last; ++i) {
            LiveSample sample = {};
            std::copy_n(value_at(*positions, i), 3, sample.position);
            if (orientations) std::copy_n(value_at(*orientations, i), 4, sample.orientation);
            sample.pressure = pressures ? std::clamp(*value_at(*pressures, i), 0.0f, 1.0f) : 1.0f;
            if (!stroke.empty())
                even_s +=
                    static_cast<double>(glm::distance(position_of(stroke.back()), position_of(sample)) / kEvenSpeed);
            // Times that run backwards stand still.
            time_s = times ? std::max<double>(time_s, *value_at(*times, i) - *value_at(*times, first)) : even_s;
            sample.time = begin_s + time_s;
            stroke.push_back(sample);
        }
        begin_s = stroke.back().time + kPauseS;
        strokes_.push_back(std::move(stroke));
    }
    if (strokes_.empty()) throw SourceError(name + ": has no stroke of two points or more");
}

void Recording::bring_near() {
    glm::vec3 low(1e30f), high(-1e30f);
    for (const Stroke& stroke : strokes_) {
        for (const LiveSample& sample : stroke) {
            low = glm::min(low, position_of(sample));
            high = glm::max(high, position_of(sample));
        }
    }
    const glm::vec3 size = high - low;
    const float scale = std::min(1.0f, kReach / std::max({size.x, size.y, size.z, 1e-6f}));
    for (Stroke& stroke : strokes_)
        for (LiveSample& sample : stroke)
            set(sample, kMiddle + scale * (position_of(sample) - 0.5f * (low + high)), orientation_of(sample));
}

XrController Recording::at(double time_s) const {
    time_s = std::fmod(time_s, end_s() + kPauseS);
    const auto next = std::find_if(strokes_.begin(), strokes_.end(),
                                   [&](const Stroke& stroke) { return stroke.back().time >= time_s; });
    if (next == strokes_.end()) return {{position_of(strokes_.back().back()), orientation_of(strokes_.back().back())}};
    const auto after =
        std::find_if(next->begin(), next->end(), [&](const LiveSample& sample) { return sample.time >= time_s; });
    const bool on_its_way = after == next->begin();
    const LiveSample& from = !on_its_way                ? *(after - 1)
                             : next == strokes_.begin() ? strokes_.back().back()
                                                        : (next - 1)->back();
    const double from_s = !on_its_way ? from.time : std::max(0.0, after->time - kPauseS);
    const double span_s = after->time - from_s;
    const auto along = static_cast<float>(span_s > 0.0 ? std::clamp((time_s - from_s) / span_s, 0.0, 1.0) : 1.0);
    XrController controller;
    controller.pose = {glm::mix(position_of(from), position_of(*after), along),
                       glm::slerp(orientation_of(from), orientation_of(*after), along)};
    if (!on_its_way) controller.trigger = std::max(glm::mix(from.pressure, after->pressure, along), kMinTrigger);
    return controller;
}

}  // namespace flg::samples
