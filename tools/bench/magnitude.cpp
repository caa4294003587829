// SPDX-License-Identifier: MIT
// A change of magnitude after the fact (sec. 4.5.3) on the paper's largest example: what it costs the host when the
// renderer has the curves, and what the next frame then uploads.
#include <cmath>
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"
#include "filigree_renderer/renderer.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTargetPoints = 369'400, kStylePoints = 600;
constexpr double kCallBarUs = 1.0, kUploadBarBytes = 1.0;
constexpr int kCalls = 10'000, kMagnitudeRuns = 7;
constexpr uint32_t kWidth = 320, kHeight = 180;  // whatever draws fastest: only the host's side counts

FlgCurveSet stylize(Host& host) {
    const scenes::Curve target = scenes::make_target("thomas", kTargetPoints);
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = host.prepare(host.add(scenes::make_style("loops")), kStylePoints);
    host.run();
    desc.target = host.add(target);
    desc.scale = scale_for(host.info(desc.style), length_of(target), kTargetPoints);
    desc.keep_displacement = 1;
    FlgCurveSet result = {};
    check(flgCurveSetStylize(host.context(), &desc, &result, nullptr));
    host.run();
    return result;
}

std::vector<Row> rows(double call_us, double uploaded_bytes, const std::string& note) {
    return {below("change of magnitude, 369,400 points: the call", call_us, "us", kCallBarUs, note),
            below("change of magnitude, 369,400 points: uploaded", uploaded_bytes, "B", kUploadBarBytes)};
}

}  // namespace

std::vector<Row> run_magnitude() {
    Host host;
    const FlgCurveSetView view = host.view(stylize(host));
    try {
        render::Renderer renderer;
        const render::CurvesId id = renderer.upload(view);
        render::Target target(renderer, kWidth, kHeight);
        const render::Camera camera = frame_box(renderer.bounds(), {-1.0f, -1.0f, 1.0f}, target.aspect());
        const auto draw = [&] {
            renderer.draw(target, camera);
            renderer.wait_idle();
            return renderer.stats().cpu_ms;
        };
        draw();  // uploads the curves
        const double still_ms = draw();
        const double call_us = 1e3 * median_ms(kMagnitudeRuns, [&] {
                                   return time_ms([&] {
                                              for (int i = 0; i < kCalls; ++i)
                                                  renderer.set_magnitude_offset(id, i % 2 == 0 ? -0.5f : -1.0f);
                                          }) /
                                          kCalls;
                               });
        const double changed_ms = draw();
        char note[96];
        std::snprintf(note, sizeof note, "host's part of a frame: %.2f ms, after a change %.2f ms", still_ms,
                      changed_ms);
        return rows(call_us, static_cast<double>(renderer.stats().uploaded_bytes), note);
    } catch (const render::Error& error) {
        return rows(std::nan(""), std::nan(""), error.what());
    }
}

}  // namespace flg::bench
