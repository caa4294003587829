// SPDX-License-Identifier: MIT
// filigree stylize: applies the style of one curve to others.
#include <cmath>
#include <map>
#include <memory>

#include "choices.h"
#include "command.h"
#include "failure.h"
#include "report.h"
#include "session.h"
#include "stylize_output.h"
#include "support/curve_source.h"
#include "text_file.h"

namespace flg::cli {
namespace {

using samples::CurveSource;

struct Options {
    std::string style, target, guide, output;
    double sigma = 1.0, tau = 0.0, alpha = flgStyleDefaults().alpha, beta = flgStyleDefaults().beta, scale = 1.0;
    uint32_t patch = 10;
    FlgFrameMethod frame = FLG_FRAME_ROTATION_MINIMIZING;
    FlgStart start = FLG_START_AUTO;
    FlgGeometry as = FLG_GEOMETRY_LINES;
    std::string save_guide, save_matching, save_path;

    // The SDK's defaults are the command's.
    Options() {
        const FlgStyleDesc prepare = flgStyleDefaults();
        const FlgStylizeDesc apply = flgStylizeDefaults();
        sigma = apply.magnitude;
        tau = apply.temperature;
        alpha = prepare.alpha;
        beta = prepare.beta;
        scale = apply.scale;
        patch = prepare.patch;
        frame = apply.frame;
        start = apply.start;
    }
};

const std::map<std::string, FlgFrameMethod> kFrames = {{"rmf", FLG_FRAME_ROTATION_MINIMIZING},
                                                       {"frenet", FLG_FRAME_FRENET}};
const std::map<std::string, FlgStart> kStarts = {
    {"auto", FLG_START_AUTO}, {"style", FLG_START_STYLE}, {"random", FLG_START_RANDOM}};

FlgCurveSet create_set(FlgContext context, const FlgCurveSetView& view, const std::string& name) {
    FlgCurveSet set = {};
    check(flgCurveSetCreate(context, &view, &set), name);
    return set;
}

// A style is one curve: the first, where a file has several.
FlgCurveSet create_style_curve(FlgContext context, const CurveSource& source, const char* role, Report& report) {
    if (source.view().curve_count > 1) {
        report.warn(source.name() + ": " + std::to_string(source.view().curve_count) + " curves; the " + role +
                    " is the first");
    }
    const samples::CurveRange first(source.view(), 0, 1);
    return create_set(context, first.view(), source.name());
}

CurveSource load(const std::string& name, Report& report) {
    CurveSource source(name);
    for (const std::string& warning : source.warnings()) report.warn(source.name() + ": " + warning);
    return source;
}

FlgStyle start_style(FlgContext context, const Options& options, Report& report, FlgJob& job) {
    FlgStyleDesc desc = flgStyleDefaults();
    const CurveSource style = load(options.style, report);
    desc.style = create_style_curve(context, style, "style", report);
    report.counts["style_curve_points"] = style.view().curve_offsets[1];
    if (!options.guide.empty()) {
        desc.guide = create_style_curve(context, load(options.guide, report), "guide", report);
    }
    desc.alpha = options.alpha;
    desc.beta = options.beta;
    desc.patch = options.patch;
    FlgStyle prepared = {};
    check(flgStyleCreate(context, &desc, &prepared, &job), options.style);
    return prepared;
}

void describe(const Options& options, Report& report) {
    report.parameters = {{"style", options.style}, {"target", options.target}};
    if (!options.guide.empty()) report.parameters["guide"] = options.guide;
    report.parameters["sigma"] = as_written(options.sigma);
    report.parameters["tau"] = as_written(options.tau);
    report.parameters["patch"] = options.patch;
    report.parameters["alpha"] = as_written(options.alpha);
    report.parameters["beta"] = as_written(options.beta);
    report.parameters["scale"] = as_written(options.scale);
    report.parameters["frame"] = name_of(kFrames, options.frame);
    report.parameters["start"] = name_of(kStarts, options.start);
    report.parameters["as"] = name_of(geometry_names(), options.as);
}

void run_stylize(const Options& options, const CommonOptions& common) {
    const StylizeOutput output{options.output, options.save_guide, options.save_matching, options.save_path,
                               options.as};
    output.check_paths();
    require_writable(common.report);
    Report report("stylize", common);
    describe(options, report);

    Session session(common);
    FlgContext context = session.context();
    FlgJob style_job = {}, stylize_job = {};
    FlgStylizeDesc desc = flgStylizeDefaults();
    desc.style = start_style(context, options, report, style_job);
    const CurveSource target = load(options.target, report);
    desc.target = create_set(context, target.view(), options.target);
    desc.start = options.start;
    desc.magnitude = options.sigma;
    desc.temperature = options.tau;
    desc.scale = options.scale;
    desc.frame = options.frame;
    desc.seed = common.seed;
    FlgCurveSet result = {};
    check(flgStylize(context, &desc, &result, &stylize_job), options.target);
    const Session::Pending jobs[] = {{style_job, options.style}, {stylize_job, options.target}};
    session.finish(jobs, report);

    report.counts["target_curves"] = target.view().curve_count;
    report.counts["target_points"] = target.point_count();
    output.write(context, desc.style, result, report);
    report.write();
}

}  // namespace

Command add_stylize(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("stylize", "Applies the style of one curve to others");
    const auto o = std::make_shared<Options>();
    app->add_option("--style", o->style, "The example: the first curve of a file, or builtin:NAME")->required();
    app->add_option("--target", o->target, "The curves to stylize: a file, or builtin:NAME")->required();
    app->add_option("--guide", o->guide, "The style's unstyled form; made from the style if not given");
    app->add_option("-o,--output", o->output, "Result: .xyz, .obj or .glb")->required()->type_name("OUT");
    app->add_option("--sigma", o->sigma, "Factor on the displacement; any finite number, 0 = the bare target")
        ->capture_default_str()
        ->check(finite());
    app->add_option(
           "--tau", o->tau,
           "Temperature, >= 0: 0 copies long runs of the style, higher jumps more often; 1 = the median distance "
           "of a patch to the one most like it")
        ->capture_default_str()
        ->check(at_least_zero());
    app->add_option("--patch", o->patch, "p, points each way that are compared before a jump, 1 to 1024")
        ->capture_default_str()
        ->check(CLI::Range(1u, 1024u).description(""));
    app->add_option("--alpha", o->alpha, "Length that the guide keeps, 0 to 1: dL/dt = (alpha - 1) int kappa^2")
        ->capture_default_str()
        ->check(between_including(0.0, 1.0));
    app->add_option("--beta", o->beta, "Closeness against evenness in the matching, between 0 and 1")
        ->capture_default_str()
        ->check(between(0.0, 1.0));
    app->add_option("--scale", o->scale, "Size of the style on the target, > 0; 1 = as drawn")
        ->capture_default_str()
        ->check(above_zero());
    add_choice(*app, "--frame", o->frame, kFrames, "Moving frame: rotation-minimizing or Frenet");
    add_choice(*app, "--start", o->start, kStarts,
               "Where on the style a curve begins: its start, at random, or auto: its start for a lone target");
    add_choice(*app, "--as", o->as, geometry_names(), "What a .glb holds");
    app->add_option("--save-guide", o->save_guide, "Write the guide")->type_name("G.xyz");
    app->add_option("--save-matching", o->save_matching,
                    "Write the matching: one arc length on the style (metres) a guide point")
        ->type_name("M.txt");
    app->add_option("--save-path", o->save_path, "Write the path: one style index a target sample, a curve a line")
        ->type_name("P.txt");
    return {app, [o, &common] { run_stylize(*o, common); }};
}

}  // namespace flg::cli
