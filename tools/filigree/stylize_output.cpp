// SPDX-License-Identifier: MIT
#include "stylize_output.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "documents/extensions.h"
#include "documents/failure.h"
#include "documents/text_file.h"
#include "support/curve_source.h"

namespace flg::cli {
namespace {

using samples::find_column;
using samples::value_at;

// Radius of curves that bring none: this share of the diagonal of all points' box.
constexpr float kDefaultRadiusShare = 1.0f / 500.0f;
// A displacement below this share of the guide's length cannot be seen.
constexpr float kUnseenShare = 1e-5f;

float diagonal_of(const FlgCurveSetView& view) {
    const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
    const float* first = value_at(positions, 0);
    std::array<float, 3> low = {first[0], first[1], first[2]}, high = low;
    for (uint32_t i = 0; i < view.curve_offsets[view.curve_count]; ++i) {
        const float* p = value_at(positions, i);
        for (size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], p[k]);
            high[k] = std::max(high[k], p[k]);
        }
    }
    return std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
}

// Calls visit(curve, point, style_index) for all points of a result.
template <class Visit>
void for_each_index(const FlgCurveSetView& result, Visit visit) {
    const FlgColumn& indices = *find_column(result, FLG_ATTRIBUTE_STYLE_INDEX);
    for (uint32_t c = 0; c < result.curve_count; ++c) {
        for (uint32_t i = result.curve_offsets[c]; i < result.curve_offsets[c + 1]; ++i) {
            visit(c, i, static_cast<int64_t>(std::lround(*value_at(indices, i))));
        }
    }
}

std::string path_text(const FlgCurveSetView& result) {
    std::string text;
    uint32_t curve = 0;
    for_each_index(result, [&](uint32_t c, uint32_t i, int64_t index) {
        for (; curve < c; ++curve) text += '\n';
        if (i != result.curve_offsets[c]) text += ' ';
        text += std::to_string(index);
    });
    return text + '\n';
}

std::string matching_text(const FlgStyleInfo& info) {
    std::string text;
    char number[32];
    for (uint32_t i = 0; i < info.point_count; ++i) {
        const auto end =
            std::to_chars(number, number + sizeof number, info.matching[i], std::chars_format::general, 9).ptr;
        text.append(number, end).push_back('\n');
    }
    return text;
}

void add_runs(const FlgCurveSetView& result, Report& report) {
    uint64_t runs = 0, jumps = 0, points = 0, longest = 0, run = 0;
    int64_t before = 0;
    for_each_index(result, [&](uint32_t c, uint32_t i, int64_t index) {
        const bool starts = i == result.curve_offsets[c];
        if (starts || index != before + 1) {
            ++runs;
            jumps += !starts;
            run = 0;
        }
        longest = std::max(longest, ++run);
        before = index;
        ++points;
    });
    report.quality["mean_copied_run"] = runs == 0 ? 0.0 : static_cast<double>(points) / static_cast<double>(runs);
    report.quality["max_copied_run"] = longest;
    report.quality["jumps"] = jumps;
}

// How often the style's caps were placed whole.
void add_caps(const FlgCurveSetView& result, const FlgStyleInfo& info, Report& report) {
    uint64_t starts = 0, ends = 0;
    for_each_index(result, [&](uint32_t, uint32_t, int64_t index) {
        starts += index == 0;
        ends += index == int64_t{info.point_count} - 1;
    });
    if (info.start_cap_points > 0) report.counts["start_caps"] = starts;
    if (info.end_cap_points > 0) report.counts["end_caps"] = ends;
}

// The same curves with the points that they need.
FlgCurveSetView simplified(FlgContext context, const FlgCurveSetView& curves, float tolerance) {
    FlgCurveSetSimplifyDesc desc = flgCurveSetSimplifyDefaults();
    desc.tolerances = &tolerance;
    check(flgCurveSetCreate(context, &curves, &desc.curves), "result");
    FlgCurveSet fewer = {};
    FlgJob job = {};
    check(flgCurveSetSimplify(context, &desc, &fewer, &job), "result");
    constexpr double kNoEnd = 1e9;
    check(flgContextRun(context, &job, 1, kNoEnd), "result");
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(context, fewer, &view), "result");
    return view;
}

}  // namespace

void StylizeOutput::check_paths() const {
    if (!ends_with_one_of(curves, {".xyz", ".txt", ".obj", ".glb"})) {
        throw UsageError(curves + ": the result is written as .xyz, .obj or .glb");
    }
    surface.check_usage(curves, all_columns);
    if (all_columns && (surface.is_surface() || curves.ends_with(".obj"))) {
        throw UsageError("--columns: " + curves + " holds no columns; lines in .xyz and .glb do");
    }
    if (!guide.empty() && !ends_with_one_of(guide, {".xyz", ".txt", ".obj", ".glb"})) {
        throw UsageError(guide + ": the guide is written as .xyz, .obj or .glb");
    }
    for (const std::string* file : {&curves, &guide, &matching, &path}) require_writable(*file);
}

void StylizeOutput::write(FlgContext context, FlgStyle style, const StylizedCurves& result, Report& report) const {
    FlgStyleInfo info = {};
    info.struct_size = sizeof info;
    check(flgStyleGetInfo(context, style, &info), "style");

    if (info.displacement_rms < kUnseenShare * info.guide_length) {
        report.warn("the style has nothing to learn: its example is its own guide, straight or without waves");
    }
    report.counts["style_points"] = info.point_count;
    report.counts["patch_graph_edges"] = info.edge_count;
    report.counts["flow_steps"] = info.flow_steps;
    report.counts["result_points"] = result.view.curve_offsets[result.view.curve_count];
    report.quality["style_length"] = info.style_length;
    report.quality["guide_length"] = info.guide_length;
    report.quality["spacing"] = info.spacing;
    report.quality["displacement_rms"] = info.displacement_rms;
    report.quality["matching_energy"] = info.matching_energy;
    report.quality["temperature_unit"] = info.temperature_unit;
    add_runs(result.view, report);
    add_caps(result.view, info, report);

    FlgCurveFileWriteDesc desc = {};
    flgCurveFileWriteDescInit(&desc, sizeof desc);
    desc.all_columns = all_columns;
    const float diagonal = diagonal_of(result.view);
    const float usual = diagonal > 0.0f ? diagonal * kDefaultRadiusShare : kDefaultRadiusShare;
    desc.default_radius = result.default_radius.value_or(usual);
    if (!guide.empty()) {
        FlgCurveSet set = {};
        check(flgStyleGetGuide(context, style, &set), "guide");
        FlgCurveSetView guide_view = flgCurveSetViewDefaults();
        check(flgCurveSetGetView(context, set, &guide_view), "guide");
        if (flgCurveFileWrite(guide.c_str(), &guide_view, &desc) != FLG_OK) throw InputError(flgIoErrorGetMessage());
    }
    const auto tolerance = surface.line_tolerance(curves, all_columns, result.shapes);
    const FlgCurveSetView written = tolerance ? simplified(context, result.view, *tolerance) : result.view;
    report.counts["written_points"] = written.curve_offsets[written.curve_count];
    if (!matching.empty()) write_text_file(matching, matching_text(info));
    if (!path.empty()) write_text_file(path, path_text(result.view));
    surface.write(curves, written, desc, result.shapes, diagonal, report);
}

}  // namespace flg::cli
