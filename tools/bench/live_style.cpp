// SPDX-License-Identifier: MIT
// A stroke just drawn becomes a style: from the release of the trigger to the first frame that finds the style
// prepared, at 90 Hz with one worker.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <thread>

#include "bench/groups.h"
#include "bench/host.h"
#include "filigree/filigree_live.h"
#include "support/live_sample.h"

namespace flg::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr uint32_t kSamples = 600, kOtherSamples[] = {300, 1200, 2400}, kFrameUs = 11'000;
constexpr int kLiveRuns = 15, kOtherRuns = 5;
constexpr uint32_t kPatienceUs = 100'000;

// Curls of 5 cm, once in 63 samples, on a bend.
std::vector<samples::LiveSample> draw(uint32_t count) {
    std::vector<samples::LiveSample> samples(count);
    for (uint32_t i = 0; i < count; ++i) {
        const double u = static_cast<double>(i) / kSamples;
        samples[i].position[0] = static_cast<float>(2.5 * u);
        samples[i].position[1] = static_cast<float>(0.1 * std::sin(5.0 * u) + 0.05 * std::sin(0.1 * i));
        samples[i].position[2] = static_cast<float>(0.3 * u * u + 0.05 * std::cos(0.1 * i));
        samples[i].pressure = 1;
        samples[i].time = i / 90.0;
    }
    return samples;
}

// A stroke that was drawn up to its last sample.
FlgLiveStroke drawn_stroke(const Host& host, FlgStyle style, uint32_t sample_count = kSamples) {
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = style;
    FlgLiveStroke stroke = {};
    check(flgLiveStrokeBegin(host.context(), &desc, &stroke));
    const std::vector<samples::LiveSample> samples = draw(sample_count);
    const FlgLiveSampleView pushed = samples::view_of(samples);
    check(flgLiveStrokePush(host.context(), stroke, &pushed, nullptr));
    return stroke;
}

// The trigger is released, and the stroke's samples are to be a style.
FlgStyle release(const Host& host, FlgLiveStroke stroke) {
    FlgCurveSet samples = {};
    check(flgLiveStrokeEnd(host.context(), stroke, nullptr, nullptr, &samples, nullptr));
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = samples;
    FlgStyle style = {};
    check(flgStyleCreate(host.context(), &desc, &style, nullptr));
    check(flgCurveSetRelease(host.context(), samples));
    check(flgLiveStrokeRelease(host.context(), stroke));
    return style;
}

bool is_ready(const Host& host, FlgStyle style) {
    FlgStyleInfo info = {};
    info.struct_size = sizeof info;
    const FlgResult result = flgStyleGetInfo(host.context(), style, &info);
    if (result != FLG_NOT_READY) check(result);
    return result == FLG_OK;
}

double frames_until_ready(const Host& host, FlgLiveStroke stroke) {
    auto frame = Clock::now();
    const FlgStyle style = release(host, stroke);
    double frames = 0;
    while (!is_ready(host, style)) {
        std::this_thread::sleep_until(frame += std::chrono::microseconds(kFrameUs));
        check(flgContextTick(host.context(), kFrameUs, nullptr));
        ++frames;
    }
    check(flgStyleRelease(host.context(), style));
    return frames;
}

double ms_until_ready(const Host& host, FlgLiveStroke stroke) {
    const auto before = Clock::now();
    const FlgStyle style = release(host, stroke);
    while (!is_ready(host, style)) {
        flgContextWait(host.context(), kPatienceUs);
        check(flgContextTick(host.context(), kFrameUs, nullptr));
    }
    const double wall_ms = Milliseconds(Clock::now() - before).count();
    check(flgStyleRelease(host.context(), style));
    return wall_ms;
}

}  // namespace

std::vector<Row> run_live_style() {
    Host host(flgAllocatorDefaults(), flgClockDefaults(), 1);
    const FlgStyle pen = host.prepare(host.add(scenes::make_style("loops")), 0);
    check(flgStyleWarm(host.context(), pen, 0, nullptr, nullptr));
    host.run();
    std::vector<double> frames, wall_ms;
    for (int run = 0; run < kLiveRuns; ++run) {
        frames.push_back(frames_until_ready(host, drawn_stroke(host, pen)));
        wall_ms.push_back(ms_until_ready(host, drawn_stroke(host, pen)));
    }
    char note[160];
    std::snprintf(note, sizeof note,
                  "one worker, 90 Hz; most %.0f; %.1f ms of wall time from release to ready, most %.1f",
                  *std::max_element(frames.begin(), frames.end()), median(wall_ms),
                  *std::max_element(wall_ms.begin(), wall_ms.end()));
    std::string sizes = note;
    for (uint32_t samples : kOtherSamples) {
        std::vector<double> others;
        for (int run = 0; run < kOtherRuns; ++run) {
            others.push_back(frames_until_ready(host, drawn_stroke(host, pen, samples)));
        }
        std::snprintf(note, sizeof note, "; of %u samples: %.0f", samples, median(others));
        sizes += note;
    }
    return {below("a stroke of 600 samples becomes a style, frames", median(frames), "", 1.0, sizes)};
}

}  // namespace flg::bench
