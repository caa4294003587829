// SPDX-License-Identifier: MIT
#include "bench/analogies_scene.h"

#include "bench/bench.h"
#include "bench/curve_analogies.h"
#include "bench/stage_inputs.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStylePoints = 600;
// The style is looked up among so many points for each of its own.
constexpr uint32_t kFinePerPoint = 16;
// As many points around one as a patch of ours has at its default, p = 10.
constexpr uint32_t kNeighbourhood = 10;

std::vector<Vec3> points_of(Host& host, FlgCurveSet set) {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(host.context(), set, &view));
    std::vector<Vec3> points;
    for (uint32_t c = 0; c < view.column_count; ++c) {
        if (view.columns[c].attribute != FLG_ATTRIBUTE_POSITION) continue;
        for (uint32_t i = 0; i < view.curve_offsets[view.curve_count]; ++i) {
            points.push_back(load_vec3(view.columns[c].data + 3 * i));
        }
    }
    return points;
}

FlgCurveSet guide_of(Host& host, FlgStyle style) {
    FlgCurveSet guide = {};
    check(flgStyleGetGuide(host.context(), style, &guide));
    return guide;
}

FlgStyle prepare(Host& host, FlgCurveSet curve, FlgCurveSet guide) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = curve;
    desc.guide = guide;
    desc.point_count = kStylePoints;
    FlgStyle style = {};
    check(flgStyleCreate(host.context(), &desc, &style, nullptr));
    return style;
}

FlgCurveSet stylize(Host& host, FlgStyle style, FlgCurveSet target, float scale, float magnitude) {
    FlgStylizeDesc desc = flgStylizeDefaults();
    desc.style = style;
    desc.target = target;
    desc.scale = scale;
    desc.magnitude = magnitude;
    FlgCurveSet result = {};
    check(flgStylize(host.context(), &desc, &result, nullptr));
    return result;
}

}  // namespace

AnalogiesScene make_analogies_scene(const std::string& style_name, const std::string& target_name, float scale,
                                    int runs) {
    Host host;
    const FlgCurveSet curve = host.add(scenes::make_style(style_name));
    const FlgCurveSet target = host.add(scenes::make_target(target_name));
    const FlgStyle by_flow = host.prepare(curve, kStylePoints);
    host.run();
    const FlgCurveSet guide = guide_of(host, by_flow);

    AnalogiesScene scene = {};
    std::vector<double> cold, warm;
    FlgStyle style = {};
    for (int i = 0; i < runs; ++i) {
        FlgCurveSet result = {};
        cold.push_back(time_ms([&] {
            style = prepare(host, curve, guide);
            result = stylize(host, style, target, scale, 1.0f);
            host.run();
        }));
        scene.ours = points_of(host, result);
        check(flgCurveSetRelease(host.context(), result));
        warm.push_back(time_ms([&] {
            result = stylize(host, style, target, scale, 1.0f);
            host.run();
        }));
        check(flgCurveSetRelease(host.context(), result));
    }
    scene.cold_ms = median(cold);
    scene.warm_ms = median(warm);

    const FlgCurveSet plain = stylize(host, style, target, scale, 0.0f);
    host.run();
    scene.target = points_of(host, plain);
    scene.guide = points_of(host, guide_of(host, style));
    const FlgStyleInfo info = host.info(style);
    const EvenStyle example = even_style(style_name, kFinePerPoint * kStylePoints);
    for (uint32_t i = 0; i < info.point_count; ++i) {
        const double share = std::min(1.0, static_cast<double>(info.matching[i] / info.style_length));
        const double place = share * static_cast<double>(example.points.size() - 1);
        scene.style.push_back(scale * example.points[static_cast<size_t>(place + 0.5)]);
        scene.guide[i] *= scale;
    }
    scene.theirs_ms = median_ms(runs, [&] {
        return time_ms([&] { scene.theirs = curve_analogies(scene.guide, scene.style, scene.target, kNeighbourhood); });
    });
    return scene;
}

}  // namespace flg::bench
