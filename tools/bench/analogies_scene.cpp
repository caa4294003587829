// SPDX-License-Identifier: MIT
#include "bench/analogies_scene.h"

#include <algorithm>

#include "bench/bench.h"
#include "bench/host.h"

namespace flg::bench {
namespace {

constexpr uint32_t kStylePoints = 600;
// As many points around one as a patch of ours has at its default, p = 10.
constexpr uint32_t kNeighbourhood = 10;

const float* column_of(const FlgCurveSetView& view, FlgAttribute attribute) {
    const FlgColumn* const end = view.columns + view.column_count;
    const FlgColumn* const found =
        std::find_if(view.columns, end, [=](const FlgColumn& column) { return column.attribute == attribute; });
    return found == end ? nullptr : found->data;
}

std::vector<Vec3> vectors_of(Host& host, FlgCurveSet set, FlgAttribute attribute) {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(host.context(), set, &view));
    const float* const data = column_of(view, attribute);
    std::vector<Vec3> vectors;
    for (uint32_t i = 0; i < view.curve_offsets[view.curve_count]; ++i) vectors.push_back(load_vec3(data + 3 * i));
    return vectors;
}

Analogy result_of(Host& host, FlgCurveSet set) {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(host.context(), set, &view));
    const float* const matches = column_of(view, FLG_ATTRIBUTE_STYLE_INDEX);
    Analogy result = {vectors_of(host, set, FLG_ATTRIBUTE_POSITION), {}};
    for (size_t i = 0; i < result.points.size(); ++i) result.matches.push_back(static_cast<uint32_t>(matches[i]));
    return result;
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
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = style;
    desc.target = target;
    desc.scale = scale;
    desc.magnitude = magnitude;
    FlgCurveSet result = {};
    check(flgCurveSetStylize(host.context(), &desc, &result, nullptr));
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
        scene.ours = result_of(host, result);
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
    scene.target = vectors_of(host, plain, FLG_ATTRIBUTE_POSITION);
    scene.target_tangents = vectors_of(host, plain, FLG_ATTRIBUTE_TANGENT);
    const FlgCurveSet used_guide = guide_of(host, style);
    scene.guide = vectors_of(host, used_guide, FLG_ATTRIBUTE_POSITION);
    scene.guide_tangents = vectors_of(host, used_guide, FLG_ATTRIBUTE_TANGENT);
    // The guide gets the style once, whole: what its points are matched with.
    const FlgCurveSet whole = stylize(host, style, used_guide, 1.0f, 1.0f);
    host.run();
    scene.style = vectors_of(host, whole, FLG_ATTRIBUTE_POSITION);
    for (Vec3& p : scene.guide) p *= scale;
    for (Vec3& p : scene.style) p *= scale;
    scene.theirs_ms = median_ms(runs, [&] {
        return time_ms([&] { scene.theirs = curve_analogies(scene.guide, scene.style, scene.target, kNeighbourhood); });
    });
    return scene;
}

}  // namespace flg::bench
