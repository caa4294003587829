// SPDX-License-Identifier: MIT
// Frames under load: flgContextTick with a budget of 2 ms and no workers, while styles are prepared, curves resampled
// and attractors stylized. What a game sees of Filigree, with a pool as allocator.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/pool.h"

namespace flg::bench {
namespace {

constexpr uint32_t kBudgetUs = 2000;
constexpr double kTickBarUs = 2100.0, kChunkBarUs = 100.0, kWholeShare = 0.99;
constexpr int kRounds = 5;
constexpr size_t kMaxLooks = 4'000'000;
constexpr uint32_t kTargetPoints = 369'400, kLargeStylePoints = 4096;

void submit(Host& host) {
    const FlgCurveSet thomas = host.add(scenes::make_target("thomas", kTargetPoints));
    const FlgCurveSet lorenz = host.add(scenes::make_target("lorenz", kTargetPoints));
    FlgCurveSetResampleDesc resample = flgCurveSetResampleDefaults();
    resample.curves = lorenz;
    resample.spacing = 0.002f;
    FlgCurveSet resampled = {};
    check(flgCurveSetResample(host.context(), &resample, &resampled, nullptr));
    for (const std::string& name : scenes::style_names()) {
        FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
        stylize.style = host.prepare(host.add(scenes::make_style(name)), 0);
        stylize.target = name.size() % 2 == 0 ? thomas : lorenz;
        stylize.temperature = 0.5f;
        stylize.frame = name.size() % 2 == 0 ? FLG_FRAME_METHOD_ROTATION_MINIMIZING : FLG_FRAME_METHOD_FRENET;
        FlgCurveSet result = {};
        check(flgCurveSetStylize(host.context(), &stylize, &result, nullptr));
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
    double max_slice_us = 0.0;
    std::string max_slice_stage;
};

Frames play(Pool& pool, const FlgClock& clock) {
    Host host(pool.hooks(), clock);
    submit(host);
    Frames frames;
    FlgFrameReport report = {};
    report.struct_size = sizeof report;
    do {
        check(flgContextTick(host.context(), kBudgetUs, &report));
        frames.ticks_us.push_back(report.tick_us);
        if (report.max_slice_us > frames.max_slice_us) {
            frames.max_slice_us = report.max_slice_us;
            frames.max_slice_stage = report.max_slice_stage;
        }
    } while (report.jobs_pending > 0);
    return frames;
}

// Remembers every look at the clock: without a budget the same ones each time, a chunk between each and the next.
struct Looks {
    std::vector<uint64_t> times_ns;

    FlgClock hook() {
        return {sizeof(FlgClock), this, [](void* self) {
                    const auto now = std::chrono::steady_clock::now().time_since_epoch();
                    const auto now_ns = static_cast<uint64_t>(std::chrono::nanoseconds(now).count());
                    static_cast<Looks*>(self)->times_ns.push_back(now_ns);
                    return now_ns;
                }};
    }
};

// Each chunk's least time over the rounds, microseconds. What the machine does besides falls into another chunk each
// round (a spinning loop sees gaps of 60 to 500 us here); what a chunk itself takes is there in all of them.
std::vector<double> min_chunks_us(Pool& pool) {
    std::vector<double> min_us;
    for (int round = 0; round < kRounds; ++round) {
        Looks looks;
        looks.times_ns.reserve(kMaxLooks);
        {
            Host host(pool.hooks(), looks.hook());
            submit(host);
            check(flgContextTick(host.context(), FLG_UNLIMITED, nullptr));
        }
        const size_t count = looks.times_ns.size() - 1;
        if (round == 0) min_us.assign(count, HUGE_VAL);
        if (count != min_us.size())
            throw std::runtime_error("rounds of the same work looked at the clock differently often");
        for (size_t i = 0; i < count; ++i) {
            const auto chunk_ns = static_cast<double>(looks.times_ns[i + 1] - looks.times_ns[i]);
            min_us[i] = std::min(min_us[i], 1e-3 * chunk_ns);
        }
    }
    return min_us;
}

uint64_t processor_time_ns(void*) {
    return static_cast<uint64_t>(1e6 * thread_ms());
}

}  // namespace

std::vector<Row> run_ticks() {
    Pool pool;
    play(pool, flgClockDefaults());  // fills the pool
    std::vector<double> ticks_us, own_ticks_us, chunks_us;
    std::string stage;
    for (int round = 0; round < kRounds; ++round) {
        const Frames wall = play(pool, flgClockDefaults());
        ticks_us.insert(ticks_us.end(), wall.ticks_us.begin(), wall.ticks_us.end());
        if (chunks_us.empty() || wall.max_slice_us < *std::min_element(chunks_us.begin(), chunks_us.end())) {
            stage = wall.max_slice_stage;
        }
        chunks_us.push_back(wall.max_slice_us);
        // Once more by the thread's own time, in which the machine's other work does not show.
        const Frames own = play(pool, {sizeof(FlgClock), nullptr, processor_time_ns});
        own_ticks_us.insert(own_ticks_us.end(), own.ticks_us.begin(), own.ticks_us.end());
    }
    char note[160];
    std::snprintf(note, sizeof note, "%zu ticks, longest %.0f us; in processor time p99 %.0f us, longest %.0f us",
                  ticks_us.size(), *std::max_element(ticks_us.begin(), ticks_us.end()), share(own_ticks_us),
                  *std::max_element(own_ticks_us.begin(), own_ticks_us.end()));
    const std::vector<double> min_us = min_chunks_us(pool);
    char rounds[160];
    std::snprintf(rounds, sizeof rounds,
                  "%zu chunks, each the least of %d rounds; longest of a round of frames: %s, median %.0f us",
                  min_us.size(), kRounds, stage.c_str(), median(chunks_us));
    return {below("flgContextTick at 2 ms under load, p99", share(ticks_us), "us", kTickBarUs, note),
            below("longest kernel chunk under load", *std::max_element(min_us.begin(), min_us.end()), "us", kChunkBarUs,
                  rounds)};
}

}  // namespace flg::bench
