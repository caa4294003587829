// SPDX-License-Identifier: MIT
// The Thomas attractor as a two-sided ribbon (Fig. 7 of the paper): shape and angle (S1) of a style on 369,400 points.
// The paper's own implementation takes 51 s.
#include <cmath>
#include <cstdio>
#include <numbers>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kTargetPoints = 369'400, kStylePoints = 600;
constexpr double kBarMs = 30.0;
constexpr float kAngleWeight = 0.01f;
// The ribbon of the style sways to and fro around its curve.
constexpr double kSways = 4.0, kSwayRad = 2.0;
constexpr int kRibbonRuns = 7;

FlgStyle prepare(Host& host) {
    const scenes::Curve loops = scenes::make_style("loops");
    std::vector<float> angles;
    for (size_t i = 0; i < loops.points.size(); ++i) {
        const double turn = 2.0 * std::numbers::pi * kSways * static_cast<double>(i);
        angles.push_back(static_cast<float>(kSwayRad * std::sin(turn / static_cast<double>(loops.points.size()))));
    }
    const FlgColumn column = {FLG_ATTRIBUTE_ANGLE, 1, angles.data(), 0, 0};
    const FlgStyleAttribute angle = {FLG_ATTRIBUTE_ANGLE, FLG_METRIC_CIRCLE, kAngleWeight, 0};
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = host.add(std::span(&loops, 1), std::span(&column, 1));
    desc.point_count = kStylePoints;
    desc.attributes = &angle;
    desc.attribute_count = 1;
    FlgStyle style = {};
    check(flgStyleCreate(host.context(), &desc, &style, nullptr));
    host.run();
    return style;
}

}  // namespace

std::vector<Row> run_ribbon() {
    const scenes::Curve target = scenes::make_target("thomas", kTargetPoints);
    const double length = length_of(target);
    Host host;
    const FlgCurveSet target_set = host.add(target);
    const double elapsed_ms = median_ms(kRibbonRuns, [&] {
        // A style of its own each time: no path tree is known yet.
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.style = prepare(host);
        desc.target = target_set;
        desc.scale = scale_for(host.info(desc.style), length, kTargetPoints);
        FlgCurveSet result = {};
        const double one_ms = time_ms([&] {
            check(flgCurveSetStylize(host.context(), &desc, &result, nullptr));
            host.run();
        });
        host.view(result);
        check(flgCurveSetRelease(host.context(), result));
        check(flgStyleRelease(host.context(), desc.style));
        return one_ms;
    });
    return {below("thomas 369,400 points as two-sided ribbon, cold", elapsed_ms, "ms", kBarMs)};
}

}  // namespace flg::bench
