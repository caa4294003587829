// SPDX-License-Identifier: MIT
#include "styled_curves.h"

#include <algorithm>
#include <array>
#include <limits>

#include "documents/failure.h"
#include "support/curve_source.h"

namespace flg::cli {
namespace {

FlgStyleInfo info_of(FlgContext context, FlgStyle style) {
    FlgStyleInfo info = {};
    info.struct_size = sizeof info;
    check(flgStyleGetInfo(context, style, &info), "style");
    return info;
}

// Each group has random choices of its own, the first those of the seed itself.
uint64_t seed_of(uint64_t seed, size_t group) {
    return seed + 0x9e3779b97f4a7c15u * group;
}

// The least and the greatest radius of a curve.
std::array<float, 2> radius_range(const FlgColumn& radii, const FlgCurveSetView& view, uint32_t curve) {
    std::array<float, 2> range = {std::numeric_limits<float>::max(), 0.0f};
    for (uint32_t i = view.curve_offsets[curve]; i < view.curve_offsets[curve + 1]; ++i) {
        const float radius = *samples::value_at(radii, i);
        range = {std::min(range[0], radius), std::max(range[1], radius)};
    }
    return range;
}

// Whether a result's radii are the target's, and not those of the style: these have their size already.
bool has_targets_radii(const FlgCurveSetView& result, uint32_t curve, const FlgCurveSetView& target, uint32_t from) {
    const FlgColumn* radii = samples::find_column(result, FLG_ATTRIBUTE_RADIUS);
    const FlgColumn* target_radii = samples::find_column(target, FLG_ATTRIBUTE_RADIUS);
    if (radii == nullptr || target_radii == nullptr) return false;
    constexpr float rounding = 1e-5f;
    const auto [low, high] = radius_range(*radii, result, curve);
    const auto [least, most] = radius_range(*target_radii, target, from);
    return low >= least * (1.0f - rounding) && high <= most * (1.0f + rounding);
}

}  // namespace

RelativeSize relative_size_of(FlgContext context, FlgStyle style) {
    FlgCurveSet guide = {};
    check(flgStyleGetGuide(context, style, &guide), "guide");
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(context, guide, &view), "guide");
    RelativeSize size(view, info_of(context, style).displacement_rms);
    check(flgCurveSetRelease(context, guide), "guide");
    return size;
}

void describe_scales(const std::vector<CurveSize>& sizes, Report& report) {
    std::vector<float> scales;
    for (const CurveSize& size : sizes) scales.push_back(size.scale);
    std::sort(scales.begin(), scales.end());
    report.quality["scale"] = {{"min", scales.front()}, {"median", scales[scales.size() / 2]}, {"max", scales.back()}};
}

StyledCurves style_by_size(Session& session, FlgCurveSetStylizeDesc desc, const FlgCurveSetView& target,
                           const std::string& target_name, Report& report) {
    FlgContext context = session.context();
    const RelativeSize relative = relative_size_of(context, desc.style);
    std::vector<CurveSize> sizes;
    for (uint32_t c = 0; c < target.curve_count; ++c) sizes.push_back(relative.of(target, c));
    describe_scales(sizes, report);
    const std::vector<ScaleGroup> groups = group_by_scale(sizes);

    // What a lone curve is, the whole target decides, not a group.
    if (desc.start == FLG_STYLE_START_AUTO && target.curve_count > 1) desc.start = FLG_STYLE_START_RANDOM;
    const uint64_t seed = desc.seed;
    std::vector<FlgCurveSet> results(groups.size());
    std::vector<Session::Pending> jobs;
    for (size_t g = 0; g < groups.size(); ++g) {
        JoinedCurves part;
        for (const uint32_t c : groups[g].curves) part.add(target, c);
        const FlgCurveSetView view = part.view();
        check(flgCurveSetCreate(context, &view, &desc.target), target_name);
        desc.scale = groups[g].scale;
        desc.seed = seed_of(seed, g);
        FlgJob job = {};
        check(flgCurveSetStylize(context, &desc, &results[g], &job), target_name);
        jobs.push_back({job, target_name});
    }
    session.finish(jobs, report);

    // Where in which result each target curve is.
    std::vector<std::array<size_t, 2>> places(target.curve_count);
    for (size_t g = 0; g < groups.size(); ++g) {
        for (size_t i = 0; i < groups[g].curves.size(); ++i) places[groups[g].curves[i]] = {g, i};
    }
    StyledCurves styled = {};
    uint64_t points = 0;
    const bool bare = desc.magnitude == 0.0f;
    for (uint32_t c = 0; c < target.curve_count; ++c) {
        const auto [g, i] = places[c];
        FlgCurveSetView view = flgCurveSetViewDefaults();
        check(flgCurveSetGetView(context, results[g], &view), "result");
        for (size_t k = 0; k < desc.strokes; ++k) {
            const uint32_t curve = static_cast<uint32_t>(i * desc.strokes + k);
            points += view.curve_offsets[curve + 1] - view.curve_offsets[curve];
            if (desc.max_points > 0 && points > desc.max_points) {
                throw InputError(target_name + ": --max-points: the result has more than " +
                                 std::to_string(desc.max_points) + " points");
            }
            styled.curves.add(view, curve);
            if (!bare && has_targets_radii(view, curve, target, c)) styled.curves.scale_radii(sizes[c].thickness);
        }
    }
    styled.default_radius = relative.radius_at(groups[groups.size() / 2].scale);
    return styled;
}

}  // namespace flg::cli
