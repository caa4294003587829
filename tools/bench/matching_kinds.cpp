// SPDX-License-Identifier: MIT
// Fig. 14 of the paper redrawn: the energy that semi-discrete and discrete matching reach and the time they take, through the
// C ABI, for N = 300 and 600 points. Over all built-in styles, the worst counts.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStagesMax = 16;
constexpr double kEnergyBar = 1.0, kSpeedBar = 1.0;
constexpr int kRuns = 5;

struct Matched {
    double energy_sq_m;  // mean over the points
    double elapsed_ms;
};

Matched match(Host& host, FlgCurveSet curve, uint32_t points, FlgMatching kind) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = curve;
    desc.point_count = points;
    desc.matching = kind;
    Matched matched = {};
    matched.elapsed_ms = median_ms(kRuns, [&] {
        FlgStyle style = {};
        FlgJob job = {};
        check(flgStyleCreate(host.context(), &desc, &style, &job));
        host.run();
        host.check_done(job);
        matched.energy_sq_m = host.info(style).matching_energy;
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

uint64_t processor_time_ns(void*) {
    return static_cast<uint64_t>(1e6 * thread_ms());
}

}  // namespace

std::vector<Row> run_matching_kinds() {
    Host host({}, {nullptr, processor_time_ns});
    std::vector<Row> rows;
    for (const uint32_t points : {300U, 600U}) {
        double energy = 0.0, speed = 1e30;
        char energy_note[96] = "", speed_note[96] = "";
        for (const std::string& name : scenes::style_names()) {
            const FlgCurveSet curve = host.add(scenes::make_style(name));
            const Matched semi = match(host, curve, points, FLG_MATCHING_SEMI_DISCRETE);
            const Matched discrete = match(host, curve, points, FLG_MATCHING_DISCRETE);
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
