// SPDX-License-Identifier: MIT
#include "stylization/prepare_style.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"
#include "stylization/guide_matching.h"
#include "stylization/repetitions.h"
#include "stylization/smooth_style_curve.h"
#include "stylization/style_caps.h"
#include "stylization/style_curves.h"

namespace flg {

namespace {

// The longest step of the matching from one point of the guide to the next, in mean ones: what it passes by faster is
// cut off. Nearer to 1, displacements along the guide grow.
constexpr double matching_step_max = 1.4;

// What matching gives: where on its style curve each node lies.
struct Matched {
    explicit Matched(uint32_t count, Memory* memory) : places(count, memory), points(count, memory) {}

    Buffer<double> places;  // arc lengths
    std::pmr::vector<Vec3> points;
};

// The points of the style that belong to the guide's.
Task<void> match_guides(Pace& pace, const StyleRequest& request, const StyleCurves& curves, Matched& matched) {
    PreparedStyle& prepared = request.style->prepared;
    const CurveSet& guides = *prepared.guide;
    prepared.matching = Buffer<float>(guides.point_count(), pace.memory());
    double energy = 0;
    for (uint32_t c = 0; c < guides.curve_count(); ++c) {
        const uint32_t first = guides.offsets()[c];
        const uint32_t count = guides.offsets()[c + 1] - first;
        std::pmr::vector<Vec3> guide(count, pace.memory());
        const auto load = [from = guides.positions() + size_t{first} * 3, to = guide.data()](uint32_t i) {
            to[i] = load_vec3(from + size_t{i} * 3);
        };
        co_await each(pace, count, Cost::some_ns, load);
        const std::pmr::vector<Vec3>& points = curves[c].points;
        const SmoothStyleCurve style(points.data(), static_cast<uint32_t>(points.size()), curves[c].measure.length);
        // Caps are as they are drawn: evenly along their straight guide.
        const StyleCurve& curve = curves[c];
        const uint32_t start = curve.nodes_of(curve.start_cap), end = curve.nodes_of(curve.end_cap);
        const uint32_t body = count - start - end,
                       body_points = style.count() - curve.start_cap.points - curve.end_cap.points;
        const double start_length = curve.start_cap.points * style.spacing();
        const double end_length = curve.end_cap.points * style.spacing();
        const double body_length = style.length() - start_length - end_length;
        const SmoothStyleCurve between(style.points() + curve.start_cap.points, body_points, body_length);
        const double farthest_step = matching_step_max * body_length / (body - 1);
        const GuideMatch match = co_await match_guide(pace, between, std::span(guide).subspan(start, body),
                                                      request.desc.beta, farthest_step);
        energy += match.energy;
        co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t i) {
            double place = 0;
            if (i < start) {
                place = start_length * i / start;
            } else if (i < start + body) {
                place = start_length + match.places[i - start];
            } else {
                place = style.length() - end_length * (count - 1 - i) / end;
            }
            matched.places[first + i] = place;
            prepared.matching[first + i] = static_cast<float>(place);
            matched.points[first + i] = style.evaluate(place).position;
        });
    }
    prepared.matching_energy = energy / guides.point_count();
}

Task<void> take_attributes(Pace& pace, const StyleRequest& request, const Matched& matched) {
    PreparedStyle& prepared = request.style->prepared;
    const CurveSet& guides = *prepared.guide;
    prepared.attributes.reserve(request.desc.attribute_count);
    for (uint32_t a = 0; a < request.desc.attribute_count; ++a) {
        prepared.attributes.push_back(
            make_attribute(*request.example, request.attributes[a], guides.point_count(), pace.memory()));
    }
    if (prepared.attributes.empty()) co_return;
    for (uint32_t c = 0; c < guides.curve_count(); ++c) {
        const uint32_t first = guides.offsets()[c];
        const std::span<const double> places(matched.places.data() + first, guides.offsets()[c + 1] - first);
        co_await take_values(pace, *request.example, c, places, first, prepared.attributes);
    }
}

// Two patches at least between the caps.
bool has_body(const StyleScene& scene) {
    for (uint32_t c = 0; c < scene.curve_count(); ++c) {
        if (scene.end_patch(c) > scene.first_patch(c) + 1) return true;
    }
    return false;
}

void check_body(const StyleScene& scene, const FlgStyleDesc& desc, double style_length) {
    if (has_body(scene)) return;
    throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                  "desc.start_cap and desc.end_cap are %g and %g m: what they leave of desc.style, %g m long, is too "
                  "short for two patches",
                  static_cast<double>(desc.start_cap), static_cast<double>(desc.end_cap), style_length);
}

// In the place of caps that are to be found: as metres of the example. `scene` has no caps.
Task<FlgStyleDesc> find_marks(Pace& pace, const PreparedStyle& prepared, StyleScene scene, double last_length,
                              FlgStyleDesc desc) {
    const bool finds_start = desc.start_cap < 0, finds_end = desc.end_cap < 0;
    desc.start_cap = std::max(desc.start_cap, 0.0f);
    desc.end_cap = std::max(desc.end_cap, 0.0f);
    StyleCaps found;
    if (scene.curve_count() == 1) found = co_await caps_beside_repetitions(pace, prepared.displacement);
    const Buffer<float>& matching = prepared.matching;
    const StyleCaps marked = marked_caps(scene.boundaries, {matching.data(), matching.size()}, last_length,
                                         double{desc.start_cap}, double{desc.end_cap});
    scene.start_cap = marked.start;
    scene.end_cap = marked.end;
    if (found.start + found.end == 0) {
        const StyleScene wide = wide_scene(scene);
        if (!has_body(wide)) co_return desc;
        const PatchGraph graph = co_await patch_graph(pace, wide);
        found = co_await find_caps(pace, graph, wide, prepared.displacement_rms);
    }
    StyleScene marks = scene;
    if (finds_start) marks.start_cap = found.start;
    if (finds_end) marks.end_cap = found.end;
    if (!has_body(marks)) co_return desc;
    if (finds_start && marks.start_cap > 0) desc.start_cap = matching[marks.start_cap];
    if (finds_end && marks.end_cap > 0) {
        desc.end_cap = static_cast<float>(last_length - double{matching[marks.node_count() - 1 - marks.end_cap]});
    }
    co_return desc;
}

Task<std::pmr::vector<PatchChannel>> channels_of(Pace& pace, const PreparedStyle& prepared) {
    std::pmr::vector<PatchChannel> channels(pace.memory());
    for (const StyleAttribute& attribute : prepared.attributes) {
        if (attribute.weight != 0) co_await add_channels(pace, attribute, channels);
    }
    co_return channels;
}

// Without caps.
StyleScene scene_of(const StyleRequest& request, std::span<const PatchChannel> channels) {
    const PreparedStyle& prepared = request.style->prepared;
    const Buffer<uint32_t>& boundaries = prepared.guide->offsets();
    return {.displacement = &prepared.displacement,
            .boundaries = {boundaries.data(), boundaries.size()},
            .patch = request.largest_patch(),
            .sizes = {request.patch_sizes.data(), request.desc.patch_size_count},
            .channels = channels};
}

Task<void> make_graph(Pace& pace, const StyleRequest& request, double last_length) {
    PreparedStyle& prepared = request.style->prepared;
    const std::pmr::vector<PatchChannel> channels = co_await channels_of(pace, prepared);
    StyleScene scene = scene_of(request, channels);
    const StyleCaps caps = marked_caps(scene.boundaries, {prepared.matching.data(), prepared.matching.size()},
                                       last_length, double{request.desc.start_cap}, double{request.desc.end_cap});
    scene.start_cap = caps.start;
    scene.end_cap = caps.end;
    check_body(scene, request.desc, prepared.style_length);
    prepared.graph = co_await patch_graph(pace, scene);
}

// All but the graph. `parts`: of the progress, for each of three stages.
Task<void> learn(Pace& pace, const StyleRequest& request, StyleCurves& curves, uint32_t count, uint64_t parts) {
    PreparedStyle& prepared = request.style->prepared;
    pace.stage("guide_flow");
    prepared.flow_steps = co_await make_guides(pace, request, curves);
    share_points(curves, count, request.largest_patch(), pace.memory());
    prepared.guide =
        std::allocate_shared<CurveSet>(std::pmr::polymorphic_allocator<CurveSet>(pace.memory()), pace.memory());
    prepared.guide->origin = request.example->origin;
    co_await frame_guides(pace, curves, *prepared.guide);
    prepared.style_length = prepared.guide_length = 0;
    for (const StyleCurve& curve : curves) {
        prepared.style_length += curve.measure.length;
        prepared.guide_length += curve.guide_measure.length;
    }
    pace.advance(parts);

    pace.stage("matching");
    Matched matched(prepared.guide->point_count(), pace.memory());
    co_await match_guides(pace, request, curves, matched);
    prepared.attributes.clear();
    co_await take_attributes(pace, request, matched);
    pace.advance(parts);

    pace.stage("displacement");
    const auto& columns = prepared.guide->columns();
    const GuideAndStyle input{columns[0].values.data(), columns[1].values.data(), columns[2].values.data(),
                              matched.points};
    prepared.displacement = Displacement(prepared.guide->point_count(), pace.memory());
    prepared.displacement_rms = co_await displace(pace, input, prepared.displacement);
    pace.advance(parts);
}

}  // namespace

uint32_t StyleRequest::largest_patch() const {
    uint32_t largest = desc.patch_size_count == 0 ? desc.patch : 0;
    for (uint32_t k = 0; k < desc.patch_size_count; ++k) largest = std::max(largest, patch_sizes[k].patch);
    return largest;
}

Task<void> prepare_style(Pace& pace, StyleRequest request) {
    PreparedStyle& prepared = request.style->prepared;

    pace.stage("resample");
    for (uint32_t a = 0; a < request.desc.attribute_count; ++a) {
        check_attribute_column(*request.example, request.attributes[a], a);
    }
    StyleCurves curves(pace.memory());
    co_await measure_curves(pace, request, curves);
    uint32_t count = request.desc.point_count;
    if (count == 0) count = co_await choose_point_count(pace, curves);
    co_await sample_curves(pace, curves, count);

    constexpr uint64_t progress_parts = 4;
    pace.expect(progress_parts);
    const double last_length = curves.back().measure.length;
    const bool finds_caps = request.desc.start_cap < 0 || request.desc.end_cap < 0;
    if (finds_caps) {
        // What is found bends no guide either: that is made once more.
        co_await learn(pace, request, curves, count, 0);
        const std::pmr::vector<PatchChannel> channels = co_await channels_of(pace, prepared);
        request.desc = co_await find_marks(pace, prepared, scene_of(request, channels), last_length, request.desc);
    }
    co_await learn(pace, request, curves, count, 1);

    pace.stage("patch_graph");
    co_await make_graph(pace, request, last_length);
    double sum = 0;
    co_await each(pace, prepared.point_count(), Cost::some_ns,
                  [&](uint32_t point) { sum += prepared.squared_bend(point); });
    prepared.bend = std::sqrt(sum / prepared.point_count());
    pace.advance(1);
}

}  // namespace flg
