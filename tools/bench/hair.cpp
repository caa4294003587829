// SPDX-License-Identifier: MIT
// A head of hair (Fig. 8 of the paper): 2,000 strands of 100 points get the shape and the radius of a style.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <mutex>
#include <thread>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStrands = 2000, kStrandPoints = 100;
constexpr double kBarMs = 15.0, kRatioBar = 1.9;
constexpr float kRadiusWeight = 1.0f;
constexpr int kHairRuns = 9;

std::vector<float> radii_of(std::span<const scenes::Curve> curves) {
    std::vector<float> radii;
    for (const scenes::Curve& curve : curves) radii.insert(radii.end(), curve.radii.begin(), curve.radii.end());
    return radii;
}

FlgCurveSet add_with_radii(Host& host, std::span<const scenes::Curve> curves) {
    const std::vector<float> radii = radii_of(curves);
    const FlgColumn column = {FLG_ATTRIBUTE_RADIUS, 1, radii.data(), 0, 0};
    return host.add(curves, std::span(&column, 1));
}

struct Hair {
    FlgStyle style;
    FlgCurveSet strands;
    float scale;  // at which the strands of the result have kStrandPoints, as a mean
};

// A style of its own: its path trees are not known yet.
Hair prepare(Host& host) {
    const scenes::Curve curls = scenes::make_style("curls");
    const std::vector<scenes::Curve> strands = scenes::make_scene("hair", kStrands).curves;
    const FlgStyleAttribute radius = {FLG_ATTRIBUTE_RADIUS, FLG_METRIC_AUTO, kRadiusWeight, 0};
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = add_with_radii(host, std::span(&curls, 1));
    desc.attributes = &radius;
    desc.attribute_count = 1;
    Hair hair = {};
    check(flgStyleCreate(host.context(), &desc, &hair.style, nullptr));
    hair.strands = add_with_radii(host, strands);
    host.run();
    double length = 0.0;
    for (const scenes::Curve& strand : strands) length += length_of(strand);
    hair.scale = scale_for(host.info(hair.style), length / kStrands, kStrandPoints);
    return hair;
}

FlgCurveSet stylize(Host& host, const Hair& hair) {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = hair.style;
    desc.target = hair.strands;
    desc.scale = hair.scale;
    FlgCurveSet result = {};
    check(flgCurveSetStylize(host.context(), &desc, &result, nullptr));
    host.run();
    return result;
}

// A clock that notes how much processor time each thread has had whenever it looks: the share of each worker, however
// many other programs want the cores.
class WorkerTimes {
public:
    FlgClock hooks() { return {sizeof(FlgClock), this, now_ns}; }

    void clear() {
        const std::lock_guard lock(mutex_);
        spans_.clear();
    }

    // Of the thread that worked most since then, this one aside.
    double max_ms() {
        const std::lock_guard lock(mutex_);
        double most = 0.0;
        for (const auto& [thread, span] : spans_) {
            if (thread != std::this_thread::get_id()) most = std::max(most, span.second - span.first);
        }
        return most;
    }

private:
    static uint64_t now_ns(void* data) {
        WorkerTimes& self = *static_cast<WorkerTimes*>(data);
        const double own_ms = thread_ms();
        {
            const std::lock_guard lock(self.mutex_);
            self.spans_.try_emplace(std::this_thread::get_id(), own_ms, own_ms).first->second.second = own_ms;
        }
        using namespace std::chrono;
        return static_cast<uint64_t>(duration_cast<nanoseconds>(steady_clock::now().time_since_epoch()).count());
    }

    std::mutex mutex_;
    std::map<std::thread::id, std::pair<double, double>> spans_;  // first and last look
};

// What the busiest worker has to do, at best: other programs only make the shares less even.
double busiest_ms(uint32_t workers) {
    WorkerTimes times;
    Host host(flgAllocatorDefaults(), times.hooks(), workers);
    const Hair hair = prepare(host);
    double min_ms = 1e30;
    for (int i = 0; i < kHairRuns; ++i) {
        times.clear();
        check(flgCurveSetRelease(host.context(), stylize(host, hair)));
        min_ms = std::min(min_ms, times.max_ms());
    }
    return min_ms;
}

}  // namespace

std::vector<Row> run_hair() {
    char note[96];
    const double whole_ms = median_ms(kHairRuns, [&] {
        Host host;
        const Hair hair = prepare(host);
        FlgCurveSet result = {};
        const double elapsed_ms = time_ms([&] { result = stylize(host, hair); });
        std::snprintf(note, sizeof note, "%u points", host.view(result).curve_offsets[kStrands]);
        return elapsed_ms;
    });
    const double one_ms = busiest_ms(1), two_ms = busiest_ms(2);
    char ratio_note[96];
    std::snprintf(ratio_note, sizeof ratio_note, "the busier one works %.3g ms, one alone %.3g ms", two_ms, one_ms);
    return {below("hair, 2,000 strands: shape and radius", whole_ms, "ms", kBarMs, note),
            at_least("hair: speed of two workers over one's", one_ms / two_ms, "x", kRatioBar, ratio_note)};
}

}  // namespace flg::bench
