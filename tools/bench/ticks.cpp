// SPDX-License-Identifier: MIT
// Frames under load: flgTick with a budget of 2 ms and no workers, while styles are prepared, curves resampled and attractors
// stylized. What a game sees of Filigree.
#include <algorithm>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kBudgetUs = 2000;
constexpr double kTickBarUs = 2100.0, kChunkBarUs = 100.0, kWholeShare = 0.99;
constexpr uint32_t kTargetPoints = 369'400, kLargeStylePoints = 4096;

void submit(Host& host) {
    const FlgCurveSet thomas = host.add(scenes::make_target("thomas", kTargetPoints));
    const FlgCurveSet lorenz = host.add(scenes::make_target("lorenz", kTargetPoints));
    FlgResampleDesc resample = flgResampleDefaults();
    resample.curves = lorenz;
    resample.spacing = 0.002f;
    FlgCurveSet resampled = {};
    check(flgResample(host.context(), &resample, &resampled, nullptr));
    for (const std::string& name : scenes::style_names()) {
        FlgStylizeDesc stylize = flgStylizeDefaults();
        stylize.style = host.prepare(host.add(scenes::make_style(name)), 0);
        stylize.target = name.size() % 2 == 0 ? thomas : lorenz;
        stylize.temperature = 0.5f;
        stylize.frame = name.size() % 2 == 0 ? FLG_FRAME_ROTATION_MINIMIZING : FLG_FRAME_FRENET;
        FlgCurveSet result = {};
        check(flgStylize(host.context(), &stylize, &result, nullptr));
    }
    host.prepare(host.add(scenes::make_style("loops")), kLargeStylePoints);
}

// What 99 % of the values don't pass.
double share(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(kWholeShare * static_cast<double>(values.size() - 1))];
}

}  // namespace

std::vector<Row> run_ticks() {
    Host host;
    submit(host);
    std::vector<double> ticks_us, own_us;
    double longest_us = 0.0;
    std::string longest_stage;
    FlgFrameReport report = {};
    report.struct_size = sizeof report;
    do {
        own_us.push_back(1000.0 * time_ms([&] { check(flgTick(host.context(), kBudgetUs, &report)); }));
        ticks_us.push_back(report.tick_us);
        if (report.longest_chunk_us > longest_us) {
            longest_us = report.longest_chunk_us;
            longest_stage = report.longest_chunk_stage;
        }
    } while (report.jobs_pending > 0);
    char note[96];
    std::snprintf(note, sizeof note, "%zu ticks, longest %.0f us; p99 of processor time %.0f us", ticks_us.size(),
                  *std::max_element(ticks_us.begin(), ticks_us.end()), share(own_us));
    return {below("flgTick at 2 ms under load, p99", share(ticks_us), "us", kTickBarUs, note),
            below("longest kernel chunk under load", longest_us, "us", kChunkBarUs, longest_stage)};
}

}  // namespace flg::bench
