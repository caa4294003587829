// SPDX-License-Identifier: MIT
// Live strokes, sample by sample, as a host pushes them: the built-in scene drawn by hands as recordings have them,
// evenly, densely, sparsely and with jumps, under the style at several sizes, with a pool as allocator that counts.
// (Recordings themselves: filigree replay --fast.)
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <mutex>
#include <thread>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/pool.h"
#include "filigree/filigree_live.h"
#include "support/live_sample.h"

namespace flg::bench {
namespace {

struct Hand {
    const char* name;
    double samples_per_second;
    size_t samples_between_jumps = 0;  // 0: none
};
constexpr Hand kHands[] = {{"even", 90.0}, {"dense", 500.0}, {"sparse", 9.0}, {"jumps", 90.0, 30}};
constexpr float kScales[] = {1.0f, 0.25f, 0.1f};
constexpr float kJump = 0.9f;                            // metres; longer ones are refused by default
constexpr double kHandSpeed = 0.5, kSpeedChange = 0.45;  // metres a second, and how far it goes up and down
constexpr double kTremor = 2e-4;                         // metres
constexpr double kP99BarUs = 8.0, kSeveralP99BarUs = 20.0, kMaxBarUs = 60.0, kWholeShare = 0.99;
constexpr uint32_t kDensePoints = 64;  // a sample: pushes that make more take longer in proportion
// The same strokes make the same work: for the p99 a push counts with the median of so many rounds, without what the
// machine did besides in some of them. The longest is that of all rounds.
constexpr int kRounds = 7;
constexpr uint32_t kMaxPoints = 1u << 20;
constexpr uint32_t kTickBudgetUs = 2000;
constexpr std::chrono::microseconds kPenPause{100};

using Samples = std::vector<samples::LiveSample>;

// Pool's blocks for several threads, counted for each.
struct CountedPool {
    Pool pool;
    FlgAllocator inner = pool.hooks();
    std::mutex mutex;
    static thread_local uint64_t allocations;

    FlgAllocator hooks() {
        return {sizeof(FlgAllocator), this,
                [](void* self, size_t size, size_t alignment) {
                    auto& counted = *static_cast<CountedPool*>(self);
                    const std::lock_guard lock(counted.mutex);
                    ++allocations;
                    return counted.inner.allocate(counted.inner.user_data, size, alignment);
                },
                [](void* self, void* memory, size_t size, size_t alignment) {
                    auto& counted = *static_cast<CountedPool*>(self);
                    const std::lock_guard lock(counted.mutex);
                    counted.inner.free(counted.inner.user_data, memory, size, alignment);
                }};
    }
};
thread_local uint64_t CountedPool::allocations = 0;

// A hand that follows a curve, slower and faster, trembling a little; it jumps to and fro.
Samples draw(const scenes::Curve& curve, const Hand& hand) {
    Samples samples;
    bool aside = false;
    double walked = 0.0, length = 0.0, time = 0.0;
    for (size_t i = 1; i < curve.points.size(); ++i) {
        const scenes::Point &p = curve.points[i - 1], &q = curve.points[i];
        const double step = std::hypot(q.x - p.x, q.y - p.y, q.z - p.z);
        while (walked <= length + step && step > 0.0) {
            const double u = (walked - length) / step;
            samples::LiveSample sample = {};
            const double tremor[] = {std::sin(61.0 * time), std::sin(53.0 * time), std::sin(71.0 * time)};
            const float from[] = {p.x, p.y, p.z}, to[] = {q.x, q.y, q.z};
            for (int k = 0; k < 3; ++k) {
                sample.position[k] = static_cast<float>(from[k] + u * (to[k] - from[k]) + kTremor * tremor[k]);
            }
            const size_t to_jump = hand.samples_between_jumps;
            if (to_jump != 0 && samples.size() % to_jump == to_jump - 1) aside = !aside;
            if (aside) sample.position[1] += kJump;
            sample.orientation[3] = 1.0f;
            sample.pressure = static_cast<float>(0.6 + 0.3 * std::sin(5.0 * time));
            sample.time = time;
            samples.push_back(sample);
            time += 1.0 / hand.samples_per_second;
            walked += (kHandSpeed + kSpeedChange * std::sin(4.0 * time)) / hand.samples_per_second;
        }
        length += step;
    }
    return samples;
}

std::vector<Samples> scene(const Hand& hand) {
    std::vector<Samples> strokes;
    for (const scenes::Curve& curve : scenes::make_bouquet()) strokes.push_back(draw(curve, hand));
    for (const char* name : {"s_curve", "spiral", "flourish"}) strokes.push_back(draw(scenes::make_target(name), hand));
    for (const std::string& name : scenes::style_names()) strokes.push_back(draw(scenes::make_style(name), hand));
    return strokes;
}

struct Played {
    std::vector<double> push_us;
    std::vector<uint32_t> push_points;
    uint64_t allocations = 0, points = 0;
};

Played play(Host& host, const FlgLiveStrokeDesc& desc, const std::vector<Samples>& strokes) {
    Played played;
    for (const Samples& samples : strokes) {
        FlgLiveStroke stroke = {};
        check(flgLiveStrokeBegin(host.context(), &desc, &stroke));
        const uint64_t allocations = CountedPool::allocations;
        for (const samples::LiveSample& sample : samples) {
            FlgCurveSetView added = flgCurveSetViewDefaults();
            const FlgLiveSampleView pushed = samples::view_of(sample);
            const double before_ms = thread_ms();
            check(flgLiveStrokePush(host.context(), stroke, &pushed, &added));
            played.push_us.push_back(1e3 * (thread_ms() - before_ms));
            played.push_points.push_back(added.curve_count > 0 ? added.curve_offsets[1] : 0);
            played.points += played.push_points.back();
        }
        played.allocations += CountedPool::allocations - allocations;
        check(flgLiveStrokeRelease(host.context(), stroke));
    }
    return played;
}

double share(std::vector<double> values) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(kWholeShare * static_cast<double>(values.size() - 1))];
}

// One hand under one size of the style.
struct Figures {
    double p99_us = 0;        // of pushes of up to kDensePoints
    double dense_p99_us = 0;  // of the others
    double median_max_us = 0, max_us = 0, points_a_sample = 0;
    uint64_t allocations = 0;
};

Figures measure(Host& host, const FlgLiveStrokeDesc& desc, const std::vector<Samples>& strokes) {
    play(host, desc, strokes);  // touches the pool's pages
    Figures figures;
    std::vector<std::vector<double>> rounds_us;  // by push
    std::vector<uint32_t> points;                // likewise
    for (int round = 0; round < kRounds; ++round) {
        const Played played = play(host, desc, strokes);
        rounds_us.resize(played.push_us.size());
        points = played.push_points;
        for (size_t i = 0; i < rounds_us.size(); ++i) rounds_us[i].push_back(played.push_us[i]);
        figures.max_us = std::max(figures.max_us, *std::max_element(played.push_us.begin(), played.push_us.end()));
        figures.allocations += played.allocations;
        figures.points_a_sample = static_cast<double>(played.points) / static_cast<double>(rounds_us.size());
    }
    std::vector<double> push_us, dense_us;
    for (size_t i = 0; i < rounds_us.size(); ++i) {
        (points[i] > kDensePoints ? dense_us : push_us).push_back(median(rounds_us[i]));
        figures.median_max_us = std::max(figures.median_max_us, median(rounds_us[i]));
    }
    figures.p99_us = share(push_us);
    figures.dense_p99_us = share(dense_us);
    return figures;
}

// A pen on a thread of its own while the host's thread ticks at full load: by the wall's clock, since a push that waits
// takes no processor time. Samples come one at a time, so that they meet all that a tick does, with caches gone cold.
std::vector<Row> beside_ticks() {
    CountedPool pool;
    Host host(pool.hooks());
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = host.prepare(host.add(scenes::make_style("loops")), 0);
    desc.max_points = kMaxPoints;
    check(flgStyleWarm(host.context(), desc.style, desc.temperature, nullptr, nullptr));
    host.run();
    FlgCurveSetResampleDesc load = flgCurveSetResampleDefaults();
    load.curves = host.add(scenes::make_target("thomas", 40'000));
    load.spacing = 0.001f;
    const std::vector<Samples> strokes = scene(kHands[0]);
    play(host, desc, strokes);

    std::vector<double> push_us;
    uint64_t ticks = 0, allocations = 0;
    for (const Samples& samples : strokes) {
        FlgLiveStroke stroke = {};
        check(flgLiveStrokeBegin(host.context(), &desc, &stroke));
        std::atomic<bool> done{false};
        std::thread pen([&] {
            for (const samples::LiveSample& sample : samples) {
                FlgCurveSetView added = flgCurveSetViewDefaults();
                const FlgLiveSampleView pushed = samples::view_of(sample);
                std::this_thread::sleep_for(kPenPause);
                const auto start = std::chrono::steady_clock::now();
                check(flgLiveStrokePush(host.context(), stroke, &pushed, &added));
                const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - start;
                push_us.push_back(taken.count());
            }
            allocations += CountedPool::allocations;
            done = true;
        });
        for (; !done; ++ticks) {
            FlgFrameReport report = flgFrameReportDefaults();
            check(flgContextTick(host.context(), kTickBudgetUs, &report));
            if (report.jobs_pending > 0) continue;
            FlgCurveSet out = {};
            check(flgCurveSetResample(host.context(), &load, &out, nullptr));
            check(flgCurveSetRelease(host.context(), out));
        }
        pen.join();
        check(flgLiveStrokeRelease(host.context(), stroke));
    }
    char note[96];
    std::snprintf(note, sizeof note, "%zu pushes during %llu ticks of %u us; longest %.0f us", push_us.size(),
                  static_cast<unsigned long long>(ticks), kTickBudgetUs,
                  *std::max_element(push_us.begin(), push_us.end()));
    return {below("live stroke beside ticks at full load, a push, p99", share(push_us), "us", kP99BarUs, note),
            within("live stroke beside ticks, allocations of pushes", static_cast<double>(allocations), "", 0.0, 0.0)};
}

// Pressure goes through all of so many styles. Jumps excepted, which make as many points as a push may.
Row several_styles(uint32_t count) {
    CountedPool pool;
    Host host(pool.hooks());
    std::vector<FlgStyle> styles;
    for (const std::string& name : scenes::style_names()) {
        if (styles.size() < count) styles.push_back(host.prepare(host.add(scenes::make_style(name)), 0));
    }
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = styles[0];
    desc.further_styles = &styles[1];
    desc.further_style_count = count - 1;
    const FlgStyleDrive choice = {FLG_ATTRIBUTE_PRESSURE,       FLG_STYLE_DRIVEN_STYLE, 0.3f, 0.9f, 0.0f,
                                  static_cast<float>(count - 1)};
    desc.drives = &choice;
    desc.drive_count = 1;
    desc.max_points = kMaxPoints;
    for (const FlgStyle style : styles) {
        check(flgStyleWarm(host.context(), style, desc.temperature, nullptr, nullptr));
    }
    host.run();
    const Figures even = measure(host, desc, scene(kHands[0])), jumps = measure(host, desc, scene(kHands[3]));
    char name[96], note[128];
    std::snprintf(name, sizeof name, "live stroke of %u styles, a push of up to %u points, p99", count, kDensePoints);
    std::snprintf(note, sizeof note,
                  "%.0f points a sample; longest %.1f us, with jumps %.1f us (medians %.1f and %.1f)",
                  even.points_a_sample, even.max_us, jumps.max_us, even.median_max_us, jumps.median_max_us);
    return below(name, even.p99_us, "us", kSeveralP99BarUs, note);
}

}  // namespace

std::vector<Row> run_live() {
    CountedPool pool;
    Host host(pool.hooks());
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = host.prepare(host.add(scenes::make_style("loops")), 0);
    desc.max_points = kMaxPoints;
    check(flgStyleWarm(host.context(), desc.style, desc.temperature, nullptr, nullptr));
    host.run();
    std::vector<Row> rows;
    uint64_t allocations = 0;
    for (float scale : kScales) {
        desc.scale = scale;
        Figures worst;
        std::string p99s;
        for (const Hand& hand : kHands) {
            const Figures figures = measure(host, desc, scene(hand));
            char text[128];
            std::snprintf(text, sizeof text, "%s%s %.1f and %.1f of denser ones (%.0f points a sample)",
                          p99s.empty() ? "" : ", ", hand.name, figures.p99_us, figures.dense_p99_us,
                          figures.points_a_sample);
            p99s += text;
            worst.p99_us = std::max(worst.p99_us, figures.p99_us);
            worst.max_us = std::max(worst.max_us, figures.max_us);
            worst.median_max_us = std::max(worst.median_max_us, figures.median_max_us);
            allocations += figures.allocations;
        }
        char name[96], rounds[96];
        std::snprintf(rounds, sizeof rounds, "of %d rounds; of their medians %.1f us", kRounds, worst.median_max_us);
        std::snprintf(name, sizeof name, "live stroke at scale %g, a push of up to %u points, p99",
                      static_cast<double>(scale), kDensePoints);
        rows.push_back(below(name, worst.p99_us, "us", kP99BarUs, p99s));
        std::snprintf(name, sizeof name, "live stroke at scale %g, a push, longest", static_cast<double>(scale));
        rows.push_back(below(name, worst.max_us, "us", kMaxBarUs, rounds));
    }
    rows.push_back(within("live stroke, allocations", static_cast<double>(allocations), "", 0.0, 0.0));
    for (const uint32_t count : {2u, 4u, 8u}) rows.push_back(several_styles(count));
    for (Row& row : beside_ticks()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace flg::bench
