// SPDX-License-Identifier: MIT
// Frames under load: flgTick with a budget of 2 ms and no workers, while styles are prepared, curves resampled and attractors
// stylized. What a game sees of Filigree, with a
// pool as allocator.
#include <algorithm>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/pool.h"

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

struct Frames {
    std::vector<double> ticks_us;
    double longest_chunk_us = 0.0;
    std::string longest_chunk_stage;
};

Frames play(Pool& pool, const FlgClock& clock) {
    Host host(pool.hooks(), clock);
    submit(host);
    Frames frames;
    FlgFrameReport report = {};
    report.struct_size = sizeof report;
    do {
        check(flgTick(host.context(), kBudgetUs, &report));
        frames.ticks_us.push_back(report.tick_us);
        if (report.longest_chunk_us > frames.longest_chunk_us) {
            frames.longest_chunk_us = report.longest_chunk_us;
            frames.longest_chunk_stage = report.longest_chunk_stage;
        }
    } while (report.jobs_pending > 0);
    return frames;
}

uint64_t processor_time_ns(void*) {
    return static_cast<uint64_t>(1e6 * thread_ms());
}

std::string describe(const Frames& frames) {
    char text[128];
    std::snprintf(text, sizeof text, "%zu ticks, longest %.0f us; longest chunk %.0f us", frames.ticks_us.size(),
                  *std::max_element(frames.ticks_us.begin(), frames.ticks_us.end()), frames.longest_chunk_us);
    return text;
}

}  // namespace

std::vector<Row> run_ticks() {
    Pool pool;
    play(pool, {});  // fills the pool
    const Frames wall = play(pool, {});
    // Once more by the thread's own time, in which the machine's other work does not show.
    const Frames own = play(pool, {nullptr, processor_time_ns});
    return {below("flgTick at 2 ms under load, p99", share(wall.ticks_us), "us", kTickBarUs, describe(wall)),
            below("the same in processor time", share(own.ticks_us), "us", kTickBarUs, describe(own)),
            below("longest kernel chunk in processor time", own.longest_chunk_us, "us", kChunkBarUs,
                  own.longest_chunk_stage)};
}

}  // namespace flg::bench
