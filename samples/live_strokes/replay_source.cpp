// SPDX-License-Identifier: MIT
#include "live_strokes/replay_source.h"

#include <cmath>
#include <thread>

namespace flg::samples {
namespace {

using Clock = std::chrono::steady_clock;

constexpr float kHalfPupils = 0.032f;  // metres
// As headsets have it: wider outwards than towards the nose, wider down than up.
constexpr float kOutwards = 0.66f, kInwards = 0.54f, kUp = 0.60f, kDown = 0.68f;

// Somebody who stands in front of what is drawn and shifts weight.
XrPose head_at(float t) {
    XrPose head;
    head.position = {0.16f * std::sin(0.45f * t), 1.52f + 0.02f * std::sin(0.8f * t),
                     0.55f + 0.08f * std::cos(0.31f * t)};
    const glm::vec3 looked_at(0.05f * std::sin(0.2f * t), 1.02f, -0.35f);
    head.orientation = glm::quatLookAt(glm::normalize(looked_at - head.position), glm::vec3(0, 1, 0));
    return head;
}

}  // namespace

ReplaySource::ReplaySource(const Recording& recording, double seconds, double hertz, bool paced)
    : recording_(recording), seconds_(seconds), period_s_(1.0 / hertz), paced_(paced) {}

bool ReplaySource::wait_frame(XrFrame& out_frame) {
    // A frame is begun a period before its display.
    uint64_t next = display_ + 1;
    if (paced_ && display_ > 0) {
        const std::chrono::duration<double> passed = Clock::now() - start_;
        next = std::max(next, static_cast<uint64_t>(passed.count() / period_s_) + 1);
        std::this_thread::sleep_until(start_ +
                                      std::chrono::duration_cast<Clock::duration>(
                                          std::chrono::duration<double>(period_s_ * static_cast<double>(next - 1))));
    } else if (display_ == 0) {
        start_ = Clock::now();
    }
    out_frame.missed = static_cast<uint32_t>(next - display_ - 1);
    display_ = next;
    out_frame.display_s = period_s_ * static_cast<double>(display_);
    if (out_frame.display_s > seconds_) return false;

    const auto t = static_cast<float>(out_frame.display_s);
    const XrPose head = head_at(t);
    for (int i = 0; i < 2; ++i) {
        const float side = i == 0 ? -1.0f : 1.0f;
        out_frame.eyes[i].pose = {head.position + head.orientation * glm::vec3(side * kHalfPupils, 0, 0),
                                  head.orientation};
        out_frame.eyes[i].field = i == 0 ? render::FieldOfView{-kOutwards, kInwards, kUp, -kDown}
                                         : render::FieldOfView{-kInwards, kOutwards, kUp, -kDown};
    }
    out_frame.drawing = recording_.at(out_frame.display_s);
    out_frame.other.pose = {glm::vec3(-0.30f, 1.02f + 0.02f * std::sin(1.1f * t), 0.02f),
                            glm::angleAxis(0.5f + 0.1f * std::sin(0.7f * t), glm::vec3(0, 1, 0))};
    return true;
}

}  // namespace flg::samples
