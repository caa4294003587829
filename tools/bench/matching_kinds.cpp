// SPDX-License-Identifier: MIT
// Fig. 14 of the paper redrawn: the energy that our semi-discrete matching, through the C ABI, and the paper's discrete
// one, literally, reach and the time they take, for N = 300 and 600 points. Over all built-in styles, the worst counts.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

#include "bench/groups.h"
#include "bench/host.h"
#include "curves/arc_length.h"
#include "curves/even_sampler.h"
#include "reference/literal_matching.h"
#include "runtime/run_now.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStagesMax = 16;
constexpr double kEnergyBar = 1.0, kSpeedBar = 1.0;
constexpr int kKindRuns = 5;

struct Matched {
    double energy_sq_m;  // mean over the points
    double elapsed_ms;
};

// Also copies the guide.
Matched match(Host& host, FlgCurveSet curve, uint32_t points, std::vector<Vec3>& guide) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = curve;
    desc.point_count = points;
    Matched matched = {};
    matched.elapsed_ms = median_ms(kKindRuns, [&] {
        FlgStyle style = {};
        FlgJob job = {};
        check(flgStyleCreate(host.context(), &desc, &style, &job));
        host.run();
        host.check_done(job);
        matched.energy_sq_m = host.info(style).matching_energy;
        FlgCurveSet guide_set = {};
        check(flgStyleGetGuide(host.context(), style, &guide_set));
        const float* positions = host.view(guide_set).columns[0].data;
        guide.resize(points);
        for (uint32_t i = 0; i < points; ++i) guide[i] = load_vec3(positions + size_t{3} * i);
        check(flgCurveSetRelease(host.context(), guide_set));
        std::array<FlgStageTime, kStagesMax> stages;
        uint32_t count = 0;
        check(flgJobGetStages(host.context(), job, stages.data(), kStagesMax, &count));
        double elapsed_ms = 0.0;
        for (uint32_t i = 0; i < count; ++i) {
            if (std::strcmp(stages[i].name, "matching") == 0) elapsed_ms += 1e-3 * stages[i].busy_us;
        }
        check(flgJobRelease(host.context(), job));
        check(flgStyleRelease(host.context(), style));
        return elapsed_ms;
    });
    return matched;
}

// On the points that ours has.
Matched match_literally(const FlgCurveSetView& view, const std::vector<Vec3>& guide) {
    const CurveView curve{view.columns[0].data, view.curve_offsets[1], false};
    const auto points = static_cast<uint32_t>(guide.size());
    const double length =
        run_now(std::pmr::new_delete_resource(), [&](Pace& pace) { return measure_curve(pace, curve); }).length;
    EvenSampler sampler(curve, length, points - 1);
    std::vector<Vec3> style(points);
    CurveSample sample;
    for (Vec3& point : style) {
        uint32_t units = ~0u;
        sampler.next(sample, units);
        point = sample.position;
    }
    const double beta = flgStyleDefaults().beta;
    Matched matched = {};
    matched.elapsed_ms = median_ms(kKindRuns, [&] {
        const double begin_ms = thread_ms();
        matched.energy_sq_m = reference::match_discrete(style, length, guide, beta, false).energy / points;
        return thread_ms() - begin_ms;
    });
    return matched;
}

uint64_t processor_time_ns(void*) {
    return static_cast<uint64_t>(1e6 * thread_ms());
}

}  // namespace

std::vector<Row> run_matching_kinds() {
    Host host(flgAllocatorDefaults(), {sizeof(FlgClock), nullptr, processor_time_ns});
    std::vector<Row> rows;
    for (const uint32_t points : {300U, 600U}) {
        double energy = 0.0, speed = 1e30;
        char energy_note[96] = "", speed_note[96] = "";
        for (const std::string& name : scenes::style_names()) {
            const FlgCurveSet curve = host.add(scenes::make_style(name));
            std::vector<Vec3> guide;
            const Matched semi = match(host, curve, points, guide);
            const Matched discrete = match_literally(host.view(curve), guide);
            if (semi.energy_sq_m / discrete.energy_sq_m > energy) {
                energy = semi.energy_sq_m / discrete.energy_sq_m;
                std::snprintf(energy_note, sizeof energy_note, "%s: %.6g of %.6g", name.c_str(), semi.energy_sq_m,
                              discrete.energy_sq_m);
            }
            if (discrete.elapsed_ms / semi.elapsed_ms < speed) {
                speed = discrete.elapsed_ms / semi.elapsed_ms;
                std::snprintf(speed_note, sizeof speed_note, "%s: %.3g ms against %.3g ms", name.c_str(),
                              semi.elapsed_ms, discrete.elapsed_ms);
            }
        }
        const std::string label = "Fig. 14, N = " + std::to_string(points) + ": ";
        rows.push_back(below(label + "semi-discrete energy over discrete", energy, "", kEnergyBar, energy_note));
        rows.push_back(at_least(label + "semi-discrete speed over discrete", speed, "x", kSpeedBar, speed_note));
    }
    return rows;
}

}  // namespace flg::bench
