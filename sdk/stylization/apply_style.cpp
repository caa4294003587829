// SPDX-License-Identifier: MIT
#include "stylization/apply_style.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/failure.h"
#include "curves/sampling_job.h"
#include "runtime/each.h"
#include "stylization/automatic_scale.h"
#include "stylization/corner_fit.h"
#include "stylization/junctions.h"
#include "stylization/mitre.h"
#include "stylization/repetitions.h"
#include "stylization/stroke_fit.h"
#include "stylization/synthesis.h"

namespace flg {

namespace {

constexpr uint32_t synthesis_chunk = 400;  // units, about 10 us
constexpr double size_per_rms = 1.5;       // of waves: their height

// Of all curves; where each has its own, what that is a factor on.
double common_scale(const FlgCurveSetStylizeDesc& desc) {
    return desc.scale > 0 ? double{desc.scale} : 1.0;
}

// What all branches read, and the columns that they write to beside frames and carried ones; null: not wanted.
struct Application {
    Application(const StylizeRequest& request, Memory* memory)
        : sampling{.in = *request.target,
                   .out = *request.out,
                   .spacing = request.style->prepared.spacing() * common_scale(request.desc),
                   .frame = request.desc.frame,
                   .copies = request.desc.strokes,
                   .max_points = request.desc.max_points,
                   .exact = request.desc.exact_spacing != 0,
                   .step_scales = nullptr,
                   .plans = {},
                   .carried = std::pmr::vector<Sampling::Carried>(memory)},
          attributes(memory) {}

    Steering steering;
    Sampling sampling;
    Buffer<float> across;  // of each target curve; empty: 1
    TargetPieces pieces;   // none if corners are gone through
    CornerFit corner_fit;
    AppliedStyle style;
    ChosenScales chosen;  // empty if the host has given one
    SynthesisInput input;
    bool from_start = false;  // the first stroke along each curve
    Buffer<uint32_t> joints;  // of the style's motifs, if they are to be whole
    bool joins = false;       // curves still change when all are stylized
    double mitred_size = 0;   // of the style as it is drawn, metres, at scale 1 of the curve
    Column* style_index = nullptr;
    Column* displacement = nullptr;
    Column* time = nullptr;
    Column* carried_radius = nullptr;      // if it is driven
    Column* thinned_radius = nullptr;      // the target's, where that is made thinner
    std::pmr::vector<Column*> attributes;  // in the order of the style's

    double scale_of(uint32_t curve) const { return sampling.scales.empty() ? 1.0 : double{sampling.scales[curve]}; }
};

// The columns that the result gets from the style.
std::pmr::vector<CurveSet::ColumnLayout> style_columns(const StylizeRequest& request, Memory* memory) {
    std::pmr::vector<CurveSet::ColumnLayout> columns({{FLG_ATTRIBUTE_STYLE_INDEX, 1}}, memory);
    if (request.desc.keep_displacement != 0) columns.push_back({FLG_ATTRIBUTE_DISPLACEMENT, 3});
    for (const StyleAttribute& attribute : request.style->prepared.attributes) {
        columns.push_back({attribute.attribute, attribute.components});
        if (attribute.attribute == FLG_ATTRIBUTE_SPEED) columns.push_back({FLG_ATTRIBUTE_TIME, 1});
    }
    return columns;
}

void find_columns(const StylizeRequest& request, Application& application) {
    CurveSet& out = *request.out;
    application.style_index = out.find(FLG_ATTRIBUTE_STYLE_INDEX);
    if (request.desc.keep_displacement != 0) application.displacement = out.find(FLG_ATTRIBUTE_DISPLACEMENT);
    for (const StyleAttribute& attribute : application.style.attributes) {
        application.attributes.push_back(out.find(attribute.attribute));
        if (attribute.attribute == FLG_ATTRIBUTE_SPEED) application.time = out.find(FLG_ATTRIBUTE_TIME);
    }
    const bool own_radius = application.style.find(FLG_ATTRIBUTE_RADIUS) < application.style.attributes.size();
    if (own_radius) return;
    Column* const radius = out.find(FLG_ATTRIBUTE_RADIUS);
    if (request.desc.scale == 0 && request.desc.magnitude != 0) application.thinned_radius = radius;
    if (!request.drives.drive(FLG_STYLE_DRIVEN_RADIUS)) return;
    application.carried_radius = radius;
    if (!radius) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.drives drive the radius, but neither desc.target nor desc.style has a RADIUS");
    }
}

// For the host to read.
Task<void> keep_scales(Pace& pace, const StylizeRequest& request, const Application& application) {
    const uint32_t copies = application.sampling.copies;
    Buffer<float>& scales = request.out->allocate_scales();
    const float common = request.desc.scale;
    co_await each(pace, scales.size(), Cost::some_ns,
                  [&](uint32_t c) { scales[c] = common > 0 ? common : application.chosen.scale[c / copies]; });
}

Task<void> thin_radius(Pace& pace, const Application& application, uint32_t curve, uint32_t out_curve) {
    if (application.thinned_radius == nullptr) co_return;
    const Buffer<uint32_t>& offsets = application.sampling.out.offsets();
    float* const radius = application.thinned_radius->values.data() + offsets[out_curve];
    const float thinning = application.chosen.thinning[curve];
    co_await each(pace, offsets[out_curve + 1] - offsets[out_curve], Cost::some_ns,
                  [=](uint32_t i) { radius[i] *= thinning; });
}

Task<void> mitre(Pace& pace, const Application& application, uint32_t curve, uint32_t out_curve) {
    const SamplingPlan& plan = application.sampling.plans[curve];
    if (plan.pieces.empty()) co_return;
    const size_t first = size_t{3} * application.sampling.out.offsets()[out_curve];
    Column* const displacement = application.displacement;
    co_await mitre_corners(pace, {.plan = plan,
                                  .magnitude = application.input.magnitude,
                                  .size = application.mitred_size * application.scale_of(curve),
                                  .across = application.pieces.across_of(curve),
                                  .positions = frame_columns(application.sampling, out_curve).positions,
                                  .displacement = displacement ? displacement->values.data() + first : nullptr});
    const Sampling& sampling = application.sampling;
    if (application.time) co_await time_motion(pace, sampling.in, curve, sampling.out, out_curve);
}

StylizedColumns stylized_columns(const Application& application, uint32_t out_curve,
                                 std::pmr::vector<float*>& attributes) {
    const size_t first = application.sampling.out.offsets()[out_curve];
    const auto begin = [first](Column* column) {
        return column ? column->values.data() + first * column->components : nullptr;
    };
    attributes.clear();
    for (Column* column : application.attributes) attributes.push_back(begin(column));
    return {.frames = frame_columns(application.sampling, out_curve),
            .style_index = begin(application.style_index),
            .displacement = begin(application.displacement),
            .time = begin(application.time),
            .attributes = attributes,
            .carried_radius = begin(application.carried_radius)};
}

// When the curve begins.
double start_time(const CurveSet& target, uint32_t curve) {
    const Column* time = target.find(FLG_ATTRIBUTE_TIME);
    return time ? time->values[target.offsets()[curve]] : 0.0;
}

// Open curves get as many steps as caps and motifs ask for.
Task<void> fit_strokes(Pace& pace, const PatchGraph& graph, Application& application) {
    Sampling& sampling = application.sampling;
    const bool by_corner = application.corner_fit.motifs && !application.pieces.empty();
    application.across = Buffer<float>(sampling.in.curve_count(), pace.memory());
    co_await each(pace, sampling.in.curve_count(), Cost::tens_of_ns, [&](uint32_t c) {
        SamplingPlan& plan = sampling.plans[c];
        StrokeFit stroke{plan.steps};
        const bool by_piece = by_corner && !application.pieces.of(c).empty();
        if (plan.steps > 0 && !plan.curve.closed && !by_piece) {
            const StrokeCaps caps{graph.start_cap, graph.end_cap};
            stroke = fit_stroke(graph, caps, application.corner_fit.stroke, plan.scaled_length / sampling.spacing_of(c),
                                plan.steps);
        }
        // Exact steps of another length are none.
        if (stroke.steps != plan.steps) plan.exact_step = 0;
        plan.steps = stroke.steps;
        application.across[c] = stroke.across;
    });
}

// The same from corner to corner. Where sizes differ from piece to piece, samples are steered by nothing else.
Task<void> fit_corners(Pace& pace, Application& application) {
    Sampling& sampling = application.sampling;
    TargetPieces& pieces = application.pieces;
    if (application.corner_fit.motifs) pieces.across = Buffer<float>(pieces.pieces.size(), pace.memory());
    for (uint32_t c = 0; c < sampling.in.curve_count(); ++c) {
        if (pieces.of(c).empty()) continue;
        co_await fit_pieces(pace, application.corner_fit, sampling.spacing_of(c), pieces.of(c), pieces.across_of(c),
                            sampling.plans[c]);
        co_await pace;
    }
    bool even = true;
    co_await each(pace, pieces.across.size(), Cost::some_ns, [&](uint32_t p) { even &= pieces.across[p] == 1; });
    if (even) pieces.across = {};
    if (even || !application.steering.points.empty()) co_return;
    Buffer<Steered>& points = application.steering.points;
    points = Buffer<Steered>(sampling.in.point_count(), pace.memory());
    co_await each(pace, points.size(), Cost::some_ns, [&](uint32_t i) { std::construct_at(&points[i]); });
}

// At the curve's first point; null if nothing is steered.
const Steered* steered_points(const Application& application, uint32_t curve) {
    if (application.steering.points.empty()) return nullptr;
    return application.steering.points.data() + application.sampling.in.offsets()[curve];
}

// One stroke along each curve of a batch.
Task<void> stylize_batch(Pace& pace, Application& application, uint32_t index) {
    const Sampling& sampling = application.sampling;
    const CurveRange range = curves_of_batch(sampling.in, index / sampling.copies);
    const uint32_t stroke = index % sampling.copies;
    std::pmr::vector<ColumnPair> pairs(pace.memory());
    std::pmr::vector<float*> attributes(pace.memory());
    SynthesisKernel kernel(application.input, pace.memory());
    for (uint32_t c = range.first; c < range.last; ++c) {
        const uint32_t out_curve = c * sampling.copies + stroke;
        column_pairs(sampling, out_curve, pairs);
        kernel.begin({.plan = sampling.plans[c],
                      .scale = application.scale_of(c),
                      .key = stroke_key(c, stroke),
                      .from_start = application.from_start && stroke == 0,
                      .start_time = start_time(sampling.in, c),
                      .out = stylized_columns(application, out_curve, attributes),
                      .carried = pairs,
                      .steered = steered_points(application, c),
                      .across = application.across.empty() ? 1.0f : application.across[c],
                      .joints = {application.joints.data(), application.joints.size()},
                      .motifs_by_piece = application.corner_fit.motifs,
                      .corner_caps = application.corner_fit.caps,
                      .across_pieces = application.pieces.across_of(c)});
        uint32_t written = 0;
        while (!kernel.run(synthesis_chunk)) {
            pace.advance(kernel.written() - written);
            written = kernel.written();
            co_await pace;
        }
        pace.advance(kernel.written() - written);
        co_await mitre(pace, application, c, out_curve);
        co_await thin_radius(pace, application, c, out_curve);
        if (!application.joins) sampling.out.complete_curve(out_curve);
        co_await pace;
    }
}

Task<void> join_results(Pace& pace, const StylizeRequest& request, const Application& application) {
    if (request.desc.smooth_junctions == 0) co_return;
    co_await smooth_junctions(pace, {.target = *request.target,
                                     .out = *request.out,
                                     .copies = application.sampling.copies,
                                     .patch = request.style->prepared.graph.patch,
                                     .magnitude = request.desc.magnitude,
                                     .bend = application.style.bend,
                                     .scales = application.sampling.scales});
    for (uint32_t c = 0; application.time && c < request.out->curve_count(); ++c) {
        co_await time_motion(pace, *request.target, c / application.sampling.copies, *request.out, c);
        co_await pace;
    }
    co_await each(pace, request.out->curve_count(), Cost::some_ns, [&](uint32_t c) { request.out->complete_curve(c); });
}

// Junctions are left as they are.
Task<void> stylize(Pace& pace, const StylizeRequest& request, Application& application) {
    const PreparedStyle& prepared = request.style->prepared;
    const FlgCurveSetStylizeDesc& desc = request.desc;
    if (!request.drives.empty()) pace.stage("steering");
    application.steering = co_await steer(pace, *request.target, request.drives);
    application.sampling.step_scales = application.steering.scales.data();
    const double largest_driven = request.drives.largest(FLG_STYLE_DRIVEN_SCALE);
    if (desc.scale == 0) {
        application.chosen = co_await choose_scales(pace, prepared, *request.target);
        const Buffer<float>& scales = application.chosen.scale;
        application.sampling.scales = {scales.data(), scales.size()};
        co_await each(pace, scales.size(), Cost::tens_of_ns, [&](uint32_t c) {
            check_attribute_sizes(prepared, double{scales[c]}, scales[c] * largest_driven);
        });
    }
    co_await measure_sampling(pace, application.sampling);
    const bool motifs_by_corner = desc.corners == FLG_STYLE_CORNERS_MOTIFS;
    const double fit = motifs_by_corner && desc.fit == 0 ? 1.0 : double{desc.fit};
    if (fit > 0) application.joints = co_await find_joints(pace, prepared.graph, prepared.displacement);
    const std::span<const uint32_t> joints(application.joints.data(), application.joints.size());
    application.corner_fit = {&prepared.graph, {joints, fit}, motifs_by_corner, desc.corner_caps != 0};
    if (prepared.graph.caps() > 0 || fit > 0) co_await fit_strokes(pace, prepared.graph, application);
    if (!application.pieces.empty()) {
        co_await measure_pieces(pace, *request.target, application.sampling.step_scales, application.pieces);
        co_await fit_corners(pace, application);
    }
    co_await lay_out_sampling(pace, application.sampling, style_columns(request, pace.memory()));

    pace.stage("synthesis");
    std::array<double, 9> basis;
    std::copy_n(desc.basis, basis.size(), basis.begin());
    const double scale = common_scale(desc);
    application.style = co_await fit_style(pace, prepared, scale, basis, scale * largest_driven);
    find_columns(request, application);
    co_await keep_scales(pace, request, application);
    const auto [cold, hot] = request.drives.temperatures(desc.temperature);
    const std::shared_ptr<PathTrees> trees = request.style->trees(prepared.temperature(cold));
    const std::shared_ptr<PathTrees> hot_trees = request.style->trees(prepared.temperature(hot));
    const bool lone = request.target->curve_count() == 1;
    application.from_start = desc.start == FLG_STYLE_START_STYLE || (desc.start == FLG_STYLE_START_AUTO && lone);
    application.input = {.style = &application.style,
                         .trees = trees.get(),
                         .magnitude = desc.magnitude,
                         .pin_ends = desc.pin_ends != 0,
                         .seed = desc.seed,
                         .hot_trees = request.drives.drive(FLG_STYLE_DRIVEN_TEMPERATURE) ? hot_trees.get() : nullptr,
                         .steered = !application.steering.points.empty()};
    if (!application.pieces.empty()) {
        const double driven = largest_driven * request.drives.largest(FLG_STYLE_DRIVEN_MAGNITUDE);
        const double scaled = scaled_basis(scale, basis).norm() / std::sqrt(3.0);
        const double applied = std::abs(double{desc.magnitude}) * scaled * driven;
        application.mitred_size = size_per_rms * applied * prepared.displacement_rms;
    }
    application.joins = desc.smooth_junctions != 0;
    co_await fork(pace, batch_count(*request.target) * desc.strokes, &stylize_batch, application);
}

// None if corners are gone through. A bend is a corner to the style within a patch, since it compares no less, and as
// a quarter turn that is as narrow as the style is high, which would fold on its inside.
Task<TargetPieces> find_pieces_of(Pace& pace, const StylizeRequest& request, std::shared_ptr<const CurveSet>& target) {
    if (request.desc.corners == FLG_STYLE_CORNERS_THROUGH) co_return TargetPieces();
    constexpr double quarter_turn = 1.5707963267948966;
    const PreparedStyle& style = request.style->prepared;
    const double patch = (2.0 * style.graph.patch + 1) * style.spacing();
    const double fold = quarter_turn * size_per_rms * style.displacement_rms;
    TargetCorners corners{request.desc.corner_angle, std::max(patch, fold) * common_scale(request.desc)};
    ChosenScales chosen;
    if (request.desc.scale == 0) {
        chosen = co_await choose_scales(pace, style, *target);
        corners.scales = {chosen.scale.data(), chosen.scale.size()};
    }
    co_return co_await find_pieces(pace, target, corners);
}

// Each style by itself, then all of them mixed.
Task<void> stylize_mixed(Pace& pace, const StylizeRequest& request, const TargetPieces& pieces) {
    const uint32_t count = request.further_style_count + 1;
    const auto style = [&](uint32_t i) { return i == 0 ? request.style : request.further_styles[i - 1]; };
    for (uint32_t i = 1; i < count; ++i) {
        check_same_attributes(request.style->prepared, style(i)->prepared, i - 1);
    }
    const Steering chosen = co_await steer(pace, *request.target, request.drives);
    MixInput mix{.count = count,
                 .target = *request.target,
                 .chosen = chosen.styles,
                 .blend = request.desc.style_blend,
                 .out = *request.out,
                 .unfinished = request.desc.smooth_junctions != 0};
    std::array<std::optional<Application>, styles_max> applications;
    std::array<StylizeRequest, styles_max> requests;
    for (uint32_t i = 0; i < count; ++i) {
        StylizeRequest& one = requests[i] = request;
        one.style = style(i);
        one.drives = request.drives.without(FLG_STYLE_DRIVEN_STYLE);
        one.out = std::allocate_shared<CurveSet>(std::pmr::polymorphic_allocator<>(pace.memory()), pace.memory());
        Application& application = applications[i].emplace(one, pace.memory());
        application.pieces = co_await copy_pieces(pace, pieces);
        co_await stylize(pace, one, application);
        mix.styles[i] = {&one.style->prepared, one.out.get(), &application.sampling};
    }
    co_await mix_styles(pace, mix);
    const FlgCurveSetScales scales = requests[0].out->scales();
    Buffer<float>& kept = request.out->allocate_scales();
    co_await each(pace, kept.size(), Cost::some_ns, [&](uint32_t c) { kept[c] = scales.scales[c]; });
    co_await join_results(pace, request, *applications[0]);
}

}  // namespace

Task<void> apply_style(Pace& pace, StylizeRequest request) {
    TargetPieces pieces = co_await find_pieces_of(pace, request, request.target);
    if (request.further_style_count > 0) {
        co_await stylize_mixed(pace, request, pieces);
        co_return;
    }
    Application application(request, pace.memory());
    application.pieces = std::move(pieces);
    co_await stylize(pace, request, application);
    co_await join_results(pace, request, application);
}

}  // namespace flg
