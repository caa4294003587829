// SPDX-License-Identifier: MIT
// Live strokes, sample by sample, as a host in VR pushes them: the built-in scene drawn by a hand at 90 Hz, with a pool as
// allocator that counts.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/pool.h"
#include "filigree/filigree_live.h"

namespace flg::bench {
namespace {

constexpr double kSamplesPerSecond = 90.0;
constexpr double kHandSpeed = 0.5, kSpeedChange = 0.45;  // metres a second, and how far it goes up and down
constexpr double kTremor = 2e-4;                         // metres
constexpr double kP99BarUs = 20.0, kMaxBarUs = 100.0, kWholeShare = 0.99;
// What the machine does besides only adds to a push: of so many rounds of the same strokes the least counts.
constexpr int kRounds = 7;
constexpr float kScale = 0.25f;

using Samples = std::vector<FlgLiveSample>;

// Pool's blocks, counted.
struct CountedPool {
    Pool pool;
    FlgAllocator inner = pool.hooks();
    uint64_t allocations = 0;

    FlgAllocator hooks() {
        return {this,
                [](void* self, size_t size, size_t alignment) {
                    auto& counted = *static_cast<CountedPool*>(self);
                    ++counted.allocations;
                    return counted.inner.allocate(counted.inner.user_data, size, alignment);
                },
                [](void* self, void* memory, size_t size, size_t alignment) {
                    const FlgAllocator& under = static_cast<CountedPool*>(self)->inner;
                    under.free(under.user_data, memory, size, alignment);
                }};
    }
};

// A hand that follows a curve, slower and faster, trembling a little.
Samples draw(const scenes::Curve& curve) {
    Samples samples;
    double walked = 0.0, length = 0.0, time = 0.0;
    for (size_t i = 1; i < curve.points.size(); ++i) {
        const scenes::Point &p = curve.points[i - 1], &q = curve.points[i];
        const double step = std::hypot(q.x - p.x, q.y - p.y, q.z - p.z);
        while (walked <= length + step && step > 0.0) {
            const double u = (walked - length) / step;
            FlgLiveSample sample = {};
            const double tremor[] = {std::sin(61.0 * time), std::sin(53.0 * time), std::sin(71.0 * time)};
            const float from[] = {p.x, p.y, p.z}, to[] = {q.x, q.y, q.z};
            for (int k = 0; k < 3; ++k) {
                sample.position[k] = static_cast<float>(from[k] + u * (to[k] - from[k]) + kTremor * tremor[k]);
            }
            sample.orientation[3] = 1.0f;
            sample.pressure = static_cast<float>(0.6 + 0.3 * std::sin(5.0 * time));
            sample.time = time;
            samples.push_back(sample);
            time += 1.0 / kSamplesPerSecond;
            walked += (kHandSpeed + kSpeedChange * std::sin(4.0 * time)) / kSamplesPerSecond;
        }
        length += step;
    }
    return samples;
}

std::vector<Samples> scene() {
    std::vector<Samples> strokes;
    for (const scenes::Curve& curve : scenes::make_bouquet()) strokes.push_back(draw(curve));
    for (const char* name : {"s_curve", "spiral", "flourish"}) strokes.push_back(draw(scenes::make_target(name)));
    for (const std::string& name : scenes::style_names()) strokes.push_back(draw(scenes::make_style(name)));
    return strokes;
}

struct Played {
    std::vector<double> push_us;
    uint64_t allocations = 0, points = 0;
};

Played play(Host& host, const CountedPool& pool, const FlgLiveStrokeDesc& desc, const std::vector<Samples>& strokes) {
    Played played;
    for (const Samples& samples : strokes) {
        FlgLiveStroke stroke = {};
        check(flgLiveStrokeBegin(host.context(), &desc, &stroke));
        const uint64_t allocations = pool.allocations;
        for (const FlgLiveSample& sample : samples) {
            FlgCurveSetView added = flgCurveSetViewDefaults();
            const auto before = std::chrono::steady_clock::now();
            check(flgLiveStrokePush(host.context(), stroke, &sample, 1, &added));
            const std::chrono::duration<double, std::micro> wall = std::chrono::steady_clock::now() - before;
            played.push_us.push_back(wall.count());
            if (added.curve_count > 0) played.points += added.curve_offsets[1];
        }
        played.allocations += pool.allocations - allocations;
        check(flgLiveStrokeRelease(host.context(), stroke));
    }
    return played;
}

double share(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(kWholeShare * static_cast<double>(values.size() - 1))];
}

}  // namespace

std::vector<Row> run_live() {
    const std::vector<Samples> strokes = scene();
    CountedPool pool;
    Host host(pool.hooks());
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = host.prepare(host.add(scenes::make_style("loops")), 0);
    desc.scale = kScale;
    check(flgStyleWarm(host.context(), desc.style, desc.temperature, nullptr, nullptr));
    host.run();
    play(host, pool, desc, strokes);  // touches the pool's pages
    std::vector<double> least_us, all_us;
    uint64_t allocations = 0, points = 0;
    for (int round = 0; round < kRounds; ++round) {
        const Played played = play(host, pool, desc, strokes);
        if (least_us.empty()) least_us = played.push_us;
        for (size_t i = 0; i < least_us.size(); ++i) least_us[i] = std::min(least_us[i], played.push_us[i]);
        all_us.insert(all_us.end(), played.push_us.begin(), played.push_us.end());
        allocations += played.allocations;
        points = played.points;
    }
    char note[160];
    std::snprintf(note, sizeof note, "%zu strokes, %zu samples, %.1f points a sample; p50 %.2f us", strokes.size(),
                  least_us.size(), static_cast<double>(points) / static_cast<double>(least_us.size()), median(all_us));
    char rounds[96];
    std::snprintf(rounds, sizeof rounds, "least of %d rounds; longest of all %.0f us", kRounds,
                  *std::max_element(all_us.begin(), all_us.end()));
    return {below("live stroke, a pushed sample, p99", share(all_us), "us", kP99BarUs, note),
            below("live stroke, a pushed sample, longest", *std::max_element(least_us.begin(), least_us.end()), "us",
                  kMaxBarUs, rounds),
            below("live stroke, allocations", static_cast<double>(allocations), "", 0.0)};
}

}  // namespace flg::bench
