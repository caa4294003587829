// SPDX-License-Identifier: MIT
// The paper's largest example (Fig. 7): the Thomas attractor with 369,400 points, stylized on one core. The paper's own
// implementation takes 51 s.
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"
#include "bench/thomas_literal.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTargetPoints = 369'400, kStylePoints = 600;
constexpr double kColdBarMs = 25.0, kWarmBarMs = 12.0;
[[maybe_unused]] constexpr double kLiteralBar = 20.0;
constexpr int kThomasRuns = 7;

// From submission to published result.
double stylize_ms(Host& host, FlgStyle style, FlgCurveSet target, float scale, uint64_t seed) {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style;
    desc.target = target;
    desc.scale = scale;
    desc.seed = seed;
    FlgCurveSet result = {};
    const double elapsed_ms = time_ms([&] {
        check(flgCurveSetStylize(host.context(), &desc, &result, nullptr));
        host.run();
    });
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(host.context(), result, &view));
    check(flgCurveSetRelease(host.context(), result));
    return elapsed_ms;
}

}  // namespace

std::vector<Row> run_thomas() {
    const scenes::Curve target = scenes::make_target("thomas", kTargetPoints);
    const double length = length_of(target);
    Host host;
    const FlgCurveSet target_set = host.add(target);
    const FlgCurveSet loops = host.add(scenes::make_style("loops"));
    std::vector<double> cold, warm;
    for (int i = 0; i < kThomasRuns; ++i) {
        // A style of its own each time: no path tree is known yet.
        const FlgStyle style = host.prepare(loops, kStylePoints);
        host.run();
        const float scale = scale_for(host.info(style), length, kTargetPoints);
        cold.push_back(stylize_ms(host, style, target_set, scale, 1));
        // Other random choices, the same trees.
        warm.push_back(stylize_ms(host, style, target_set, scale, 2));
        check(flgStyleRelease(host.context(), style));
    }
    std::vector<Row> rows = {below("thomas 369,400 points, cold", median(cold), "ms", kColdBarMs),
                             below("thomas 369,400 points, warm", median(warm), "ms", kWarmBarMs)};
#if defined(FLG_WITH_REFERENCE)
    const FlgStyle style = host.prepare(loops, kStylePoints);
    host.run();
    const LiteralTimes literal = literal_stylize(host, style, "loops", target, kTargetPoints);
    char note[96];
    std::snprintf(note, sizeof note, "literal: %.0f ms, of it paths %.0f ms", literal.all_ms, literal.paths_ms);
    rows.push_back(at_least("thomas, cold: speed over the literal version's", literal.all_ms / median(cold), "x",
                            kLiteralBar, note));
    rows.push_back(at_least("thomas, cold: speed over the literal paths' alone", literal.paths_ms / median(cold), "x",
                            kLiteralBar));
#endif
    return rows;
}

}  // namespace flg::bench
