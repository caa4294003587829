// SPDX-License-Identifier: MIT
#include "stylization/stroke_fit.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

// Targets have at most so many points.
constexpr double steps_max = 0x1.0p31;

StrokeFit caps_alone(StrokeCaps caps, double wanted, uint32_t steps) {
    // Without a start cap the first sample is the style's.
    const double cap_steps = caps.end + std::max(caps.start, 1U) - 1.0;
    if (steps > cap_steps || caps.start + caps.end == 0) return {steps, 1};
    const double needed = cap_steps + 1;
    return {static_cast<uint32_t>(needed), static_cast<float>(std::min(wanted / needed, 1.0))};
}

// Steps of so many repetitions that come nearest.
struct Repetitions {
    double steps = 0;
    bool single = false;

    Repetitions(std::span<const uint32_t> joints, double room) {
        const double all = joints.back() - joints.front();
        const double rounds = std::floor(room / all), rest = room - rounds * all;
        const auto behind = [&](size_t k) { return static_cast<double>(joints[k] - joints.front()); };
        size_t k = 0;
        while (k + 1 < joints.size() && rest >= 0.5 * (behind(k) + behind(k + 1))) ++k;
        if (rounds == 0) k = std::max<size_t>(k, 1);
        steps = rounds * all + behind(k);
        single = steps == behind(1);
    }
};

}  // namespace

StrokeFit fit_stroke(const PatchGraph& graph, StrokeCaps caps, StrokeMotifs motifs, double wanted, uint32_t steps) {
    const std::span<const uint32_t> joints = motifs.joints;
    if (joints.empty()) return caps_alone(caps, wanted, steps);
    // Between a start cap and the first joint, and behind the last one, the style is as it is.
    const uint32_t lead_in = caps.start > 0 ? joints.front() - graph.start() : 0;
    const double fixed = caps.start + lead_in + (caps.end > 0 ? steps_behind(graph, joints) : 0);
    const double room = std::max(wanted - fixed, 0.0);
    const Repetitions whole(joints, room);
    double body = whole.steps;
    if (!motifs.repeat()) {
        const bool shorter_than_a_patch = wanted < 2 * graph.patch + 1;
        // Where the caps leave no room, everything shrinks.
        const double stretch = std::max(room, 1.0) / body;
        if (!shorter_than_a_patch && room >= 1) body *= std::pow(stretch, 1 - motifs.fit);
        body = std::max(std::floor(body + 0.5), 1.0);
    }
    const double all = fixed + body;
    const double across = whole.single ? std::min(wanted / all, 1.0) : 1.0;
    return {static_cast<uint32_t>(std::min(all, steps_max)), static_cast<float>(across)};
}

}  // namespace flg
