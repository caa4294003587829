// SPDX-License-Identifier: MIT
// A head of hair (Fig. 8 of the paper): 2,000 strands of 100 points get the shape and the radius of a style.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "bench/groups.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStrands = 2000, kStrandPoints = 100;
constexpr double kBarMs = 60.0, kRatioBar = 1.5;
constexpr float kRadiusWeight = 1.0f;
constexpr int kRuns = 9, kRatioRuns = 40;

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
    FlgStylizeDesc desc = flgStylizeDefaults();
    desc.style = hair.style;
    desc.target = hair.strands;
    desc.scale = hair.scale;
    FlgCurveSet result = {};
    check(flgStylize(host.context(), &desc, &result, nullptr));
    host.run();
    return result;
}

double wall_ms(Host& host, const Hair& hair) {
    using namespace std::chrono;
    const auto start = steady_clock::now();
    const FlgCurveSet result = stylize(host, hair);
    const double elapsed_ms = duration<double, std::milli>(steady_clock::now() - start).count();
    check(flgCurveSetRelease(host.context(), result));
    return elapsed_ms;
}

}  // namespace

std::vector<Row> run_hair() {
    char note[96];
    const double whole_ms = median_ms(kRuns, [&] {
        Host host;
        const Hair hair = prepare(host);
        FlgCurveSet result = {};
        const double elapsed_ms = time_ms([&] { result = stylize(host, hair); });
        std::snprintf(note, sizeof note, "%u points", host.view(result).curve_offsets[kStrands]);
        return elapsed_ms;
    });
    // In turns, the fastest of several runs of each: what else the machine does only adds.
    Host one({}, {}, 1), two({}, {}, 2);
    const Hair hair_of_one = prepare(one), hair_of_two = prepare(two);
    double one_ms = 1e30, two_ms = 1e30;
    for (int i = 0; i < kRatioRuns; ++i) {
        one_ms = std::min(one_ms, wall_ms(one, hair_of_one));
        two_ms = std::min(two_ms, wall_ms(two, hair_of_two));
    }
    char ratio_note[96];
    std::snprintf(ratio_note, sizeof ratio_note, "in wall time: %.3g ms against %.3g ms", two_ms, one_ms);
    return {below("hair, 2,000 strands: shape and radius", whole_ms, "ms", kBarMs, note),
            at_least("hair: speed of two workers over one's", one_ms / two_ms, "x", kRatioBar, ratio_note)};
}

}  // namespace flg::bench
