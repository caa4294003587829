// SPDX-License-Identifier: MIT
// The semi-discrete matching of guide and style against the literal discrete one: the energy that each reaches, and in
// what time. Over all built-in styles, the worst counts.
#include <algorithm>

#include "bench/groups.h"
#include "bench/stage_inputs.h"
#include "reference/literal_matching.h"
#include "runtime/run_now.h"
#include "scenes/scenes.h"
#include "stylization/guide_flow.h"
#include "stylization/guide_matching.h"

namespace flg::bench {
namespace {

constexpr uint32_t kPoints = 600;
constexpr double kBeta = 0.2;
constexpr double kSpeedupBar = 20.0, kEnergyBar = 1.0;
constexpr int kMatchingRuns = 9;

}  // namespace

std::vector<Row> run_matching() {
    Memory* memory = std::pmr::new_delete_resource();
    double worst_energy = 0.0, worst_speedup = 1e30;
    std::string energy_note, speedup_note;
    for (const std::string& name : scenes::style_names()) {
        const EvenStyle style = even_style(name, kPoints);
        const FlowedGuide flowed =
            run_now(memory, [&](Pace& pace) { return guide_flow(pace, style.points, GuideFlowParams{}); });
        const std::vector<Vec3> guide(flowed.points.begin(), flowed.points.end());
        const SmoothStyleCurve smooth(style.points.data(), kPoints, style.length);

        double energy = 0.0, literal_energy = 0.0;
        const double fast_ms = median_ms(kMatchingRuns, [&] {
            return time_ms([&] {
                // Steps of any length, as in the paper.
                const auto match = [&](Pace& pace) { return match_guide(pace, smooth, guide, kBeta, style.length); };
                energy = run_now(memory, match).energy;
            });
        });
        const double literal_ms = median_ms(kMatchingRuns, [&] {
            return time_ms([&] {
                literal_energy = reference::match_discrete(style.points, style.length, guide, kBeta, false).energy;
            });
        });
        char note[96];
        if (energy / literal_energy > worst_energy) {
            worst_energy = energy / literal_energy;
            std::snprintf(note, sizeof note, "%s: %.4g of %.4g", name.c_str(), energy, literal_energy);
            energy_note = note;
        }
        if (literal_ms / fast_ms < worst_speedup) {
            worst_speedup = literal_ms / fast_ms;
            std::snprintf(note, sizeof note, "%s: %.3g ms against %.3g ms", name.c_str(), fast_ms, literal_ms);
            speedup_note = note;
        }
    }
    return {
        below("matching 600 points: energy over the paper's discrete one", worst_energy, "", kEnergyBar, energy_note),
        at_least("matching 600 points: speed over the paper's discrete one", worst_speedup, "x", kSpeedupBar,
                 speedup_note)};
}

}  // namespace flg::bench
