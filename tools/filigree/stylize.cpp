// SPDX-License-Identifier: MIT
// filigree stylize: applies the style of curves to others.
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "apply_options.h"
#include "choices.h"
#include "chosen_scales.h"
#include "command.h"
#include "corner_options.h"
#include "documents/failure.h"
#include "documents/progress.h"
#include "documents/report.h"
#include "documents/session.h"
#include "documents/text_file.h"
#include "option_names.h"
#include "style_options.h"
#include "stylize_output.h"
#include "support/brush_shape.h"

namespace flg::cli {
namespace {

using samples::CurveSource;

struct Options {
    StyleOptions style;
    ApplyOptions apply;
    CornerOptions corners;
    std::optional<float> displacement;
    std::string target, output;
    uint32_t strokes = flgCurveSetStylizeDefaults().strokes, max_points = flgCurveSetStylizeDefaults().max_points;
    float style_blend = flgCurveSetStylizeDefaults().style_blend;
    float fit = flgCurveSetStylizeDefaults().fit;
    bool closed = false, network = false, columns = false;
    SurfaceOptions surface;
    std::string save_guide, save_matching, save_path;
    const CLI::Option* style_blend_option = nullptr;

    bool whole_motifs() const { return fit > 0.0f || corners.motifs(); }
};

constexpr uint32_t kMaxStrokes = 1024;
constexpr float kStraight = 1e-9f;  // metres: a style with less has no displacement

const std::map<std::string, FlgFrameMethod> kFrames = {{"rmf", FLG_FRAME_METHOD_ROTATION_MINIMIZING},
                                                       {"frenet", FLG_FRAME_METHOD_FRENET},
                                                       {"supplied", FLG_FRAME_METHOD_SUPPLIED}};

void describe(const Options& options, Report& report) {
    options.style.describe(report);
    report.parameters["target"] = options.target;
    options.apply.describe(report);
    if (options.displacement) report.parameters["displacement"] = as_written(*options.displacement);
    report.parameters["closed"] = options.closed;
    report.parameters["network"] = options.network;
    report.parameters["strokes"] = options.strokes;
    if (options.fit > 0.0f) report.parameters["fit"] = as_written(options.fit);
    options.corners.describe(report);
    if (options.style_blend > 0.0f) report.parameters["style_blend"] = as_written(options.style_blend);
    report.parameters["columns"] = options.columns;
    options.surface.describe(report);
}

FlgStyleInfo style_info(FlgContext context, FlgStyle style) {
    FlgStyleInfo info = {};
    info.struct_size = sizeof info;
    check(flgStyleGetInfo(context, style, &info), "style");
    return info;
}

void check_usage(const Options& options) {
    options.style.check_usage();
    options.apply.check_usage(options.style.count(), options.whole_motifs());
    options.corners.check_usage();
    if (options.corners.caps() && !options.style.may_have_caps()) {
        throw UsageError("--corner-caps: --caps says what the style's caps are");
    }
    if (options.whole_motifs() && options.strokes > 1) {
        throw UsageError("--strokes: whole motifs (--fit, --corners motif) leave nothing to chance: all are the same");
    }
    if (options.fit > 0.0f && options.closed && !options.corners.motifs()) {
        throw UsageError("--fit: with --closed no curve has ends to fit motifs to; see --corners motif");
    }
    if (options.style.count() == 1) {
        if (options.style_blend_option->count() > 0) throw UsageError("--style-blend: there is one --style");
        return;
    }
    const std::pair<const char*, const std::string*> files[] = {{"--save-guide", &options.save_guide},
                                                                {"--save-matching", &options.save_matching}};
    for (const auto& [name, file] : files) {
        if (!file->empty()) throw UsageError(std::string(name) + ": is of one style, not of several");
    }
}

// Closed curves have no ends.
void check_fit(const Options& options, const FlgCurveSetView& target, Report& report) {
    if (options.fit == 0.0f || options.corners.motifs()) return;
    uint32_t closed = 0;
    for (uint32_t c = 0; c < target.curve_count; ++c) {
        closed += target.curve_flags != nullptr && (target.curve_flags[c] & FLG_CURVE_CLOSED) != 0;
    }
    if (closed == 0) return;
    const std::string sentence = options.target + ": --fit has no ends to fit motifs to in ";
    if (closed == target.curve_count) throw InputError(sentence + "closed curves; see --corners motif");
    report.warn(sentence + std::to_string(closed) + " closed curves");
}

void run_stylize(const Options& options, const CommonOptions& common) {
    const StylizeOutput output{options.output,    options.save_guide, options.save_matching,
                               options.save_path, options.surface,    options.columns};
    output.check_paths();
    check_usage(options);
    require_writable(common.report);
    Report report("stylize", common);
    describe(options, report);

    Session session(common);
    FlgContext context = session.context();
    FlgJob style_job = {};
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    options.apply.set(desc);
    desc.strokes = options.strokes;
    desc.max_points = options.max_points;
    desc.fit = options.fit;
    options.corners.set(desc);
    desc.style = options.style.start(context, report, style_job);
    std::vector<StyleOptions::Pending> further_jobs;
    const std::vector<FlgStyle> further = options.style.start_further(context, report, further_jobs);
    desc.further_styles = further.empty() ? nullptr : further.data();
    desc.further_style_count = static_cast<uint32_t>(further.size());
    desc.style_blend = options.style_blend;
    say_step("reading " + options.target);
    const CurveSource target(options.target);
    for (const std::string& warning : target.warnings()) report.warn(target.name() + ": " + warning);
    FlgCurveSetView target_view = target.view();
    const std::vector<uint8_t> closed(target_view.curve_count, FLG_CURVE_CLOSED);
    if (options.closed) target_view.curve_flags = closed.data();
    desc.seed = common.seed;
    desc.pin_ends = options.network;
    desc.keep_displacement = options.columns;
    check_fit(options, target_view, report);
    options.apply.check_columns(target_view, options.target, false);
    report.counts["target_curves"] = target_view.curve_count;
    report.counts["target_points"] = target.point_count();

    std::vector<Session::Pending> jobs;
    if (style_job.id != 0) jobs.push_back({style_job, options.style.subject()});
    for (const StyleOptions::Pending& pending : further_jobs) jobs.push_back({pending.job, pending.subject});
    std::vector<FlgCurveGeometry> shapes;
    for (const FlgCurveGeometry shape : samples::shapes_of_strokes(target))
        shapes.insert(shapes.end(), desc.strokes, shape);
    desc.scale = options.apply.scale();
    if (options.displacement) {
        session.finish(jobs, report);
        jobs.clear();
        desc.scale = *options.displacement / std::max(style_info(context, desc.style).displacement_rms, kStraight);
    }
    check(flgCurveSetCreate(context, &target_view, &desc.target), options.target);
    FlgCurveSet result = {};
    FlgJob stylize_job = {};
    check(flgCurveSetStylize(context, &desc, &result, &stylize_job), options.target);
    jobs.push_back({stylize_job, options.target});
    session.finish(jobs, report);
    options.style.save(context, desc.style, report);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(context, result, &view), "result");
    std::optional<float> default_radius;
    if (desc.scale == 0.0f) {
        const ChosenScales chosen = scales_of(context, desc.style, result);
        chosen.describe(report);
        default_radius = chosen.radius_at(chosen.median());
    }
    output.write(context, desc.style, {view, shapes, default_radius}, report);
    options.style.describe_caps(context, desc.style, report);
    report.write();
}

}  // namespace

Command add_stylize(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("stylize", "Draws curves in the style of an example");
    const auto o = std::make_shared<Options>();
    o->style.add_to(*app);
    app->add_option("--target", o->target, "The curves to stylize: a file, or builtin:NAME")->required();
    app->add_option("-o,--output", o->output, "Result: .xyz, .obj or .glb")->required()->type_name("OUT");
    o->apply.add_to(
        *app, kFrames,
        "Moving frame: rotation-minimizing, Frenet, or the target's own normals (columns nx ny nz of an .xyz file, "
        "NORMAL of a .glb)");
    app->add_option("--displacement", o->displacement,
                    "In place of --scale: the size at which the style's displacement (root mean square) is D metres, "
                    "> 0; of several styles style 0's, and the others have the same --scale")
        ->type_name("D")
        ->excludes("--scale")
        ->check(above_zero());
    app->add_flag("--closed", o->closed, "Take all target curves as closed, their last point joined to the first");
    app->add_flag("--network", o->network, "Ends stay where they are, so that curves that meet still meet");
    app->add_option("--strokes", o->strokes, "Stylized copies of each curve, 1 to 1024")
        ->capture_default_str()
        ->check(CLI::Range(1u, kMaxStrokes).description(""));
    app->add_option("--fit", o->fit,
                    "Whole motifs, as many as come nearest to a curve's length; 0 to 1: near 0 they are skipped or "
                    "repeated in part to fit, at 1 only stretched; 0 = copies, cut off where the curve ends")
        ->capture_default_str()
        ->check(between_including(0.0, 1.0));
    o->corners.add_to(*app);
    o->style_blend_option =
        app->add_option("--style-blend", o->style_blend,
                        "Length of the curves over which one style turns into the next, metres, >= 0; 0 = two patches")
            ->capture_default_str()
            ->check(at_least_zero());
    app->add_option("--max-points", o->max_points, "Maximum points of the result; 0 = 2^31")
        ->capture_default_str()
        ->check(CLI::Range(0u, 1u << 31).description(""));
    o->surface.add_to(*app);
    app->add_flag("--columns", o->columns,
                  "Write all columns of the result (.xyz: behind a line `# columns x y z ...`; .glb: lines with "
                  "_ATTRIBUTES): frames, style index, displacement at --sigma 1, attributes; else radii alone");
    app->add_option("--save-guide", o->save_guide, "Write the guide")->type_name("G.xyz");
    app->add_option("--save-matching", o->save_matching,
                    "Write the matching: one arc length on the style (metres) a guide point")
        ->type_name("M.txt");
    app->add_option("--save-path", o->save_path, "Write the path: one style index a target sample, a curve a line")
        ->type_name("P.txt");
    return {app, [o, &common] { with_option_names(o->apply.drives_said(), [&] { run_stylize(*o, common); }); }};
}

}  // namespace flg::cli
