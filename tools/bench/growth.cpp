// SPDX-License-Identifier: MIT
// How the time of synthesis grows with the target: a power law fitted over four decades.
#include <cmath>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr double kExponent = 1.0, kTolerance = 0.05;
constexpr uint32_t kStylePoints = 600;
constexpr uint32_t kCounts[] = {1'000, 10'000, 100'000, 1'000'000, 10'000'000};

// Runs enough for a steady median, fewer where one takes long.
int runs_for(uint32_t count) {
    return count <= 10'000 ? 101 : (count <= 100'000 ? 21 : (count <= 1'000'000 ? 5 : 3));
}

double stylize_us(Host& host, FlgStyle style, FlgCurveSet target, float scale) {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style;
    desc.target = target;
    desc.scale = scale;
    FlgCurveSet result = {};
    FlgJob job = {};
    const double us = 1000.0 * time_ms([&] {
                          check(flgCurveSetStylize(host.context(), &desc, &result, &job));
                          host.run();
                      });
    host.check_done(job);
    check(flgJobRelease(host.context(), job));
    check(flgCurveSetRelease(host.context(), result));
    return us;
}

}  // namespace

std::vector<Row> run_growth() {
    Host host;
    const FlgStyle style = host.prepare(host.add(scenes::make_style("loops")), kStylePoints);
    host.run();
    std::vector<double> counts, times;
    std::string note;
    for (uint32_t count : kCounts) {
        const scenes::Curve target = scenes::make_target("thomas", count);
        const float scale = scale_for(host.info(style), length_of(target), count);
        const FlgCurveSet set = host.add(target);
        if (counts.empty()) {
            // Fill the style's path trees first: they are paid once, whatever the target.
            const scenes::Curve filler = scenes::make_target("thomas", 400'000);
            stylize_us(host, style, host.add(filler), scale_for(host.info(style), length_of(filler), 400'000));
        }
        const double us = median_ms(runs_for(count), [&] { return stylize_us(host, style, set, scale); });
        check(flgCurveSetRelease(host.context(), set));
        counts.push_back(count);
        times.push_back(us);
        char text[48];
        std::snprintf(text, sizeof text, "%s1e%.0f: %.4g ms", note.empty() ? "" : ", ", std::log10(count), us / 1000.0);
        note += text;
    }
    return {within("growth of synthesis, 1e3 to 1e7 points", growth_exponent(counts, times), "", kExponent, kTolerance,
                   note)};
}

}  // namespace flg::bench
