// SPDX-License-Identifier: MIT
// The points that curves need: the Thomas attractor in loops, at three tolerances at once.
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kPoints = 369'400;
constexpr double kBarNs = 200;
constexpr int kSimplifyRuns = 9;

}  // namespace

std::vector<Row> run_simplify() {
    Host host;
    const scenes::Curve target = scenes::make_target("thomas", 20'000);
    FlgCurveSetStylizeDesc stylize = flgCurveSetStylizeDefaults();
    stylize.style = host.prepare(host.add(scenes::make_style("loops")), 600);
    stylize.target = host.add(target);
    host.run();
    stylize.scale = scale_for(host.info(stylize.style), length_of(target), kPoints);
    FlgCurveSet curves = {};
    check(flgCurveSetStylize(host.context(), &stylize, &curves, nullptr));
    host.run();
    const uint32_t count = host.view(curves).curve_offsets[1];

    // Shares of the loops' swing.
    const float swing = stylize.scale * host.info(stylize.style).displacement_rms;
    const float tolerances[] = {0.003f * swing, 0.03f * swing, 0.3f * swing};
    FlgCurveSetSimplifyDesc desc = flgCurveSetSimplifyDefaults();
    desc.curves = curves;
    desc.tolerances = tolerances;
    desc.level_count = 3;
    FlgCurveSet fewer = {};
    const double ms = median_ms(kSimplifyRuns, [&] {
        if (fewer.id != 0) check(flgCurveSetRelease(host.context(), fewer));
        check(flgCurveSetSimplify(host.context(), &desc, &fewer, nullptr));
        return time_ms([&] { host.run(); });
    });
    const uint32_t* const offsets = host.view(fewer).curve_offsets;
    const auto share = [&](uint32_t level) { return 100.0 * (offsets[level + 1] - offsets[level]) / count; };
    char note[128];
    std::snprintf(note, sizeof note, "%.1f, %.1f and %.1f %% stay within 0.3, 3 and 30 %% of the swing; %.1f ms in all",
                  share(0), share(1), share(2), ms);
    return {below("a stylized point at three levels of detail", 1e6 * ms / count, "ns", kBarNs, note)};
}

}  // namespace flg::bench
