// SPDX-License-Identifier: MIT
// filigree replay: recorded strokes, drawn again through live strokes, sample by sample.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "apply_options.h"
#include "choices.h"
#include "chosen_scales.h"
#include "command.h"
#include "counting_pool.h"
#include "documents/failure.h"
#include "documents/progress.h"
#include "documents/report.h"
#include "documents/session.h"
#include "documents/text_file.h"
#include "filigree/filigree_live.h"
#include "joined_curves.h"
#include "option_names.h"
#include "style_options.h"
#include "stylize_output.h"
#include "support/brush_shape.h"
#include "support/curve_source.h"
#include "support/live_sample.h"

namespace flg::cli {
namespace {

using samples::CurveSource;
using samples::find_column;
using samples::value_at;
using Clock = std::chrono::steady_clock;

// Time between samples of strokes that say nothing of it, or whose times run backwards.
constexpr double kSampleSeconds = 1.0 / 90.0;
// A host's frame in between two strokes.
constexpr uint32_t kTickUs = 2000;
// Share of the full radius that a stroke has at pressure 0, as painting programs have it.
constexpr float kLightest = 0.1f;
// Memory for so many times the points that a stroke's length asks for.
constexpr double kPointsReserve = 2.0;

const std::map<std::string, FlgFrameMethod> kFrames = {{"rmf", FLG_FRAME_METHOD_ROTATION_MINIMIZING},
                                                       {"supplied", FLG_FRAME_METHOD_SUPPLIED}};

struct Options {
    StyleOptions style;
    ApplyOptions apply;
    std::string strokes, output, save_guide;
    bool fast = false;
    FlgLiveStrokeDesc live = flgLiveStrokeDefaults();
    std::optional<float> min_radius, max_radius;
    SurfaceOptions surface;
    const CLI::Option* style_blend_option = nullptr;
};

// One of the recorded strokes, as a hand would draw it.
struct Recording {
    std::vector<samples::LiveSample> samples;
    float scale, min_radius, max_radius;
    std::optional<std::array<float, 4>> color;
};

// Microseconds of each push: on the wall's clock, and of this thread's processor time.
struct Latencies {
    std::vector<float> wall_us, processor_us;
    uint64_t allocations = 0;  // by pushes
};

double processor_us() {
    timespec time = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

std::vector<samples::LiveSample> samples_of(const FlgCurveSetView& view, uint32_t curve, uint64_t& retimed) {
    const FlgColumn& positions = *find_column(view, FLG_ATTRIBUTE_POSITION);
    const FlgColumn* orientations = find_column(view, FLG_ATTRIBUTE_ORIENTATION);
    const FlgColumn* pressures = find_column(view, FLG_ATTRIBUTE_PRESSURE);
    const FlgColumn* times = find_column(view, FLG_ATTRIBUTE_TIME);
    std::vector<samples::LiveSample> out;
    for (uint32_t i = view.curve_offsets[curve]; i < view.curve_offsets[curve + 1]; ++i) {
        samples::LiveSample sample = {};
        std::copy_n(value_at(positions, i), 3, sample.position);
        if (orientations != nullptr) std::copy_n(value_at(*orientations, i), 4, sample.orientation);
        sample.pressure = pressures == nullptr ? 1.0f : std::clamp(*value_at(*pressures, i), 0.0f, 1.0f);
        if (times != nullptr) sample.time = *value_at(*times, i);
        out.push_back(sample);
    }
    const auto earlier = [](const samples::LiveSample& a, const samples::LiveSample& b) { return a.time < b.time; };
    const bool backwards = !std::is_sorted(out.begin(), out.end(), earlier);
    retimed += backwards;
    if (times == nullptr || backwards) {
        for (size_t i = 0; i < out.size(); ++i) out[i].time = kSampleSeconds * static_cast<double>(i);
    }
    return out;
}

// The radius that a recorded stroke has at pressure 1; 0: it has none.
float full_radius(const FlgCurveSetView& view, uint32_t curve) {
    const FlgColumn* radii = find_column(view, FLG_ATTRIBUTE_RADIUS);
    const FlgColumn* pressures = find_column(view, FLG_ATTRIBUTE_PRESSURE);
    float radius = 0.0f;
    for (uint32_t i = view.curve_offsets[curve]; radii != nullptr && i < view.curve_offsets[curve + 1]; ++i) {
        const float pressure = pressures == nullptr ? 1.0f : std::clamp(*value_at(*pressures, i), 0.0f, 1.0f);
        radius = std::max(radius, *value_at(*radii, i) / (kLightest + (1.0f - kLightest) * pressure));
    }
    return radius;
}

// Sizes are the recorded stroke's, whose length is known already, unless --scale gives one; radii likewise, unless they
// are given.
Recording record(const Options& options, const std::optional<ChosenScales>& chosen, const FlgCurveSetView& view,
                 uint32_t curve, uint64_t& retimed) {
    Recording recording = {samples_of(view, curve, retimed), options.apply.scale(), options.live.min_radius,
                           options.live.max_radius, std::nullopt};
    if (chosen) {
        recording.scale = chosen->scales[curve];
        const float radius = full_radius(view, curve), thinned = chosen->radius_at(recording.scale);
        recording.max_radius = radius > 0.0f ? std::min(radius, thinned) : thinned;
        recording.min_radius = kLightest * recording.max_radius;
    }
    if (options.min_radius) recording.min_radius = *options.min_radius;
    if (options.max_radius) recording.max_radius = *options.max_radius;
    if (const FlgColumn* colors = find_column(view, FLG_ATTRIBUTE_COLOR)) {
        const float* c = value_at(*colors, view.curve_offsets[curve]);
        recording.color = {c[0], c[1], c[2], c[3]};
    }
    return recording;
}

class Player {
public:
    Player(FlgContext context, const CountingPool& pool, const FlgLiveStrokeDesc& desc, bool fast)
        : context_(context), pool_(pool), desc_(desc), fast_(fast) {}

    void play(const Recording& recording) {
        const std::vector<samples::LiveSample>& samples = recording.samples;
        const auto start = Clock::now();
        desc_.scale = recording.scale;
        desc_.min_radius = recording.min_radius;
        desc_.max_radius = recording.max_radius;
        begin();
        bool drawn = false;
        for (const samples::LiveSample& sample : samples) {
            if (!fast_) {
                std::this_thread::sleep_until(start +
                                              std::chrono::duration_cast<Clock::duration>(
                                                  std::chrono::duration<double>(sample.time - samples[0].time)));
            }
            FlgResult result = push(sample);
            if (result == FLG_ERROR_LIMIT && drawn) {  // another stroke begins behind a jump, or where memory ends
                ++(is_full() ? filled_ : jumps_);
                end();
                begin();
                drawn = false;
                result = push(sample);
            }
            if (result == FLG_ERROR_INVALID_ARGUMENT) {
                ++refused_;
            } else {
                check(result, "sample");
                drawn = true;
            }
        }
        if (drawn) {
            end();
        } else {
            check(flgLiveStrokeRelease(context_, stroke_), "stroke");
        }
    }

    const std::vector<FlgCurveSet>& results() const { return results_; }
    const Latencies& latencies() const { return latencies_; }
    // Samples that were not taken, and strokes that were broken at a jump or because they were full.
    uint64_t refused() const { return refused_; }
    uint64_t jumps() const { return jumps_; }
    uint64_t filled() const { return filled_; }

private:
    void begin() { check(flgLiveStrokeBegin(context_, &desc_, &stroke_), "stroke"); }

    bool is_full() const {
        FlgLiveStrokeInfo info = {};
        info.struct_size = sizeof info;
        check(flgLiveStrokeGetInfo(context_, stroke_, &info), "stroke");
        return info.cut != 0 || info.sample_count == desc_.max_samples;
    }

    FlgResult push(const samples::LiveSample& sample) {
        FlgCurveSetView added = flgCurveSetViewDefaults();
        const FlgLiveSampleView pushed = samples::view_of(sample);
        const uint64_t allocations = pool_.allocations();
        const double processor_before = processor_us();
        const auto before = Clock::now();
        const FlgResult result = flgLiveStrokePush(context_, stroke_, &pushed, &added);
        const std::chrono::duration<float, std::micro> wall = Clock::now() - before;
        latencies_.processor_us.push_back(static_cast<float>(processor_us() - processor_before));
        latencies_.wall_us.push_back(wall.count());
        latencies_.allocations += pool_.allocations() - allocations;
        return result;
    }

    void end() {
        FlgCurveSet result = {};
        check(flgLiveStrokeEnd(context_, stroke_, nullptr, &result, nullptr, nullptr), "stroke");
        check(flgLiveStrokeRelease(context_, stroke_), "stroke");
        results_.push_back(result);
        ++desc_.seed;
        check(flgContextTick(context_, kTickUs, nullptr), "tick");
    }

    FlgContext context_;
    const CountingPool& pool_;
    FlgLiveStrokeDesc desc_;
    bool fast_;
    FlgLiveStroke stroke_ = {};
    std::vector<FlgCurveSet> results_;
    Latencies latencies_;
    uint64_t refused_ = 0, jumps_ = 0, filled_ = 0;
};

// Enough for the longest stroke; all get the same, so that memory goes from one to the next. `spacing` at scale 1.
void reserve(const FlgCurveSetView& strokes, const std::vector<Recording>& recordings, double spacing,
             FlgLiveStrokeDesc& desc) {
    constexpr double samples_limit = 1 << 20, points_limit = 1 << 24;
    double samples = 1, steps = 0;
    for (uint32_t c = 0; c < strokes.curve_count; ++c) {
        samples = std::max<double>(samples, strokes.curve_offsets[c + 1] - strokes.curve_offsets[c]);
        steps =
            std::max(steps, samples::curve_length(strokes, c) / (spacing * static_cast<double>(recordings[c].scale)));
    }
    desc.max_samples = static_cast<uint32_t>(std::min(samples, samples_limit));
    desc.max_points = static_cast<uint32_t>(std::min(kPointsReserve * (steps + 1.0), points_limit));
}

void add_latencies(const Latencies& latencies, Report& report) {
    report.quality["p50_us"] = percentile(latencies.wall_us, 0.50);
    report.quality["p99_us"] = percentile(latencies.wall_us, 0.99);
    report.quality["max_us"] = percentile(latencies.wall_us, 1.0);
    // Without what else the machine did meanwhile.
    report.quality["processor_p99_us"] = percentile(latencies.processor_us, 0.99);
    report.quality["processor_max_us"] = percentile(latencies.processor_us, 1.0);
    report.quality["allocations"] = latencies.allocations;
}

// Ready, and warm.
std::vector<FlgStyle> prepare_styles(Session& session, const Options& options, Report& report) {
    FlgContext context = session.context();
    std::vector<Session::Pending> jobs;
    FlgJob first_job = {};
    const FlgStyle first = options.style.start(context, report, first_job);
    if (first_job.id != 0) jobs.push_back({first_job, options.style.subject()});
    std::vector<StyleOptions::Pending> further_jobs;
    std::vector<FlgStyle> styles = options.style.start_further(context, report, further_jobs);
    styles.insert(styles.begin(), first);
    for (const StyleOptions::Pending& pending : further_jobs) jobs.push_back({pending.job, pending.subject});
    const auto temperatures = options.apply.temperatures();
    for (const FlgStyle style : styles) {
        for (size_t k = 0; k < (temperatures[0] == temperatures[1] ? 1 : temperatures.size()); ++k) {
            FlgJob warm_job = {};
            check(flgStyleWarm(context, style, temperatures[k], nullptr, &warm_job), options.style.subject());
            jobs.push_back({warm_job, options.style.subject()});
        }
    }
    session.finish(jobs, report);
    options.style.save(context, first, report);
    return styles;
}

// Of the style whose points are closest together, metres at scale 1.
double least_spacing(FlgContext context, const std::vector<FlgStyle>& styles, const Options& options) {
    double spacing = HUGE_VAL;
    for (const FlgStyle style : styles) {
        FlgStyleInfo info = {};
        info.struct_size = sizeof info;
        check(flgStyleGetInfo(context, style, &info), options.style.subject());
        spacing = std::min(spacing, double{info.spacing});
    }
    return spacing;
}

void describe(const Options& options, Report& report) {
    report.parameters = {{"strokes", options.strokes}, {"fast", options.fast}};
    options.style.describe(report);
    options.apply.describe(report);
    report.parameters["smoothing"] = as_written(options.live.smoothing);
    report.parameters["max_jump"] = as_written(options.live.max_jump);
    if (options.live.end_cap != 0) report.parameters["end_cap"] = true;
    if (options.live.style_blend > 0.0f) report.parameters["style_blend"] = as_written(options.live.style_blend);
    options.surface.describe(report);
}

void check_usage(const Options& options) {
    options.style.check_usage();
    options.apply.check_usage(options.style.count(), false);
    if (options.live.end_cap != 0 && !options.style.may_have_end_cap()) {
        throw UsageError("--end-cap: --caps says what the style's end cap is");
    }
    if (options.style.count() == 1 && options.style_blend_option->count() > 0) {
        throw UsageError("--style-blend: there is one --style");
    }
    if (options.style.count() > 1 && !options.save_guide.empty()) {
        throw UsageError("--save-guide: is of one style, not of several");
    }
}

// Hands press by 0 to 1.
void warn_of_pressures(const FlgCurveSetView& view, const std::string& subject, Report& report) {
    const FlgColumn* pressures = find_column(view, FLG_ATTRIBUTE_PRESSURE);
    uint64_t beyond = 0;
    for (uint32_t i = 0; pressures != nullptr && i < view.curve_offsets[view.curve_count]; ++i) {
        const float pressure = *value_at(*pressures, i);
        beyond += !(pressure >= 0.0f && pressure <= 1.0f);
    }
    if (beyond == 0) return;
    report.warn(subject + ": " + std::to_string(beyond) + " pressures below 0 or above 1 count as 0 or 1");
}

void run_replay(Options options, const CommonOptions& common) {
    StylizeOutput output = {};
    output.curves = options.output;
    output.surface = options.surface;
    output.guide = options.save_guide;
    output.check_paths();
    check_usage(options);
    require_writable(common.report);
    Report report("replay", common);
    describe(options, report);
    say_step("reading " + options.strokes);
    const CurveSource strokes(options.strokes);
    for (const std::string& warning : strokes.warnings()) report.warn(options.strokes + ": " + warning);
    options.apply.check_columns(strokes.view(), options.strokes, true);
    warn_of_pressures(strokes.view(), options.strokes, report);

    CountingPool pool;
    Session session(common, pool.hooks());
    FlgContext context = session.context();
    options.apply.set(options.live);
    const std::vector<FlgStyle> styles = prepare_styles(session, options, report);
    options.live.style = styles[0];
    options.live.further_styles = styles.size() > 1 ? &styles[1] : nullptr;
    options.live.further_style_count = static_cast<uint32_t>(styles.size() - 1);
    options.live.seed = common.seed;
    const FlgCurveSetView& view = strokes.view();
    std::copy(std::begin(view.origin), std::end(view.origin), options.live.origin);
    std::optional<ChosenScales> chosen;
    if (options.apply.scale() == 0.0f)
        chosen = choose_scales(session, options.live.style, view, options.strokes, report);
    uint64_t retimed = 0;
    std::vector<Recording> recordings;
    for (uint32_t c = 0; c < view.curve_count; ++c) recordings.push_back(record(options, chosen, view, c, retimed));
    reserve(view, recordings, least_spacing(context, styles, options), options.live);

    const std::vector<FlgCurveGeometry> brushes = samples::shapes_of_strokes(strokes);
    std::vector<uint32_t> drawn;  // the recording of each result
    Player player(context, pool, options.live, options.fast);
    for (uint32_t c = 0; c < recordings.size(); ++c) {
        say_share("drawing stroke " + std::to_string(c + 1) + " of " + std::to_string(recordings.size()),
                  static_cast<double>(c) / static_cast<double>(recordings.size()));
        player.play(recordings[c]);
        drawn.resize(player.results().size(), c);
    }
    FlgFrameReport frame = {};
    frame.struct_size = sizeof frame;
    do {
        check(flgContextTick(context, common.tick_budget_us(), &frame), "tick");
        if (frame.jobs_pending > 0) flgContextWait(context, kTickUs);
    } while (frame.jobs_pending > 0);
    if (player.results().empty()) throw InputError(options.strokes + ": no sample could be taken");

    report.counts["strokes"] = strokes.view().curve_count;
    report.counts["samples"] = strokes.point_count();
    report.counts["drawn_strokes"] = player.results().size();
    report.counts["refused_samples"] = player.refused();
    report.counts["retimed_strokes"] = retimed;
    report.counts["broken_at_jumps"] = player.jumps();
    report.counts["broken_when_full"] = player.filled();
    if (retimed > 0) {
        report.warn(options.strokes + ": " + std::to_string(retimed) +
                    " strokes whose times run backwards were played at 90 Hz");
    }
    if (player.refused() > 0) {
        report.warn(options.strokes + ": " + std::to_string(player.refused()) +
                    " samples could not be taken, such as for a coordinate beyond 1e30");
    }
    if (player.jumps() > 0) {
        report.warn(options.strokes + ": strokes jump at " + std::to_string(player.jumps()) +
                    " places and were broken there");
    }
    if (player.filled() > 0) {
        report.warn(options.strokes + ": strokes come to a live stroke's limits at " + std::to_string(player.filled()) +
                    " places and were broken there");
    }
    add_latencies(player.latencies(), report);
    JoinedCurves joined;
    std::vector<FlgCurveGeometry> shapes;
    for (size_t i = 0; i < drawn.size(); ++i) {
        FlgCurveSetView stroke = flgCurveSetViewDefaults();
        check(flgCurveSetGetView(context, player.results()[i], &stroke), "stroke");
        joined.add(stroke, 0);
        if (recordings[drawn[i]].color) joined.set_color(recordings[drawn[i]].color->data());
        if (!brushes.empty()) shapes.push_back(brushes[drawn[i]]);
    }
    output.write(context, options.live.style, {joined.view(), shapes, std::nullopt}, report);
    options.style.describe_caps(context, options.live.style, report);
    report.write();
}

}  // namespace

Command add_replay(CLI::App& program, const CommonOptions& common) {
    CLI::App* app = program.add_subcommand("replay", "Draws recorded strokes again as live strokes, sample by sample");
    const auto o = std::make_shared<Options>();
    FlgLiveStrokeDesc& live = o->live;
    app->add_option("STROKES", o->strokes, "Recorded strokes: a .tilt sketch, other curves, or builtin:NAME")
        ->required();
    o->style.add_to(*app, "--guide-smoothing");
    app->add_option("-o,--output", o->output, "Result: .xyz, .obj or .glb")->required()->type_name("OUT");
    app->add_flag("--fast", o->fast, "As fast as can be, instead of at the strokes' own times");
    o->apply.add_to(*app, kFrames, "Moving frame: rotation-minimizing, or by the controller's orientation");
    app->add_option("--smoothing", live.smoothing, "Time constant of the input filter, seconds, >= 0; 0 = none")
        ->capture_default_str()
        ->check(at_least_zero());
    app->add_option("--max-jump", live.max_jump, "Strokes are broken where samples are further apart, metres, > 0")
        ->capture_default_str()
        ->check(above_zero());
    app->add_flag_callback(
        "--end-cap", [o] { o->live.end_cap = 1; },
        "Ended strokes get the style's end cap (--caps), which strokes do not have while drawn");
    o->style_blend_option =
        app->add_option("--style-blend", live.style_blend,
                        "Length of the strokes over which one style turns into the next, metres, >= 0; 0 = two patches")
            ->capture_default_str()
            ->check(at_least_zero());
    app->add_option("--radius-min", o->min_radius,
                    "Radius at pressure 0, metres, >= 0. Default: from the recorded stroke; with a --scale given 0.001")
        ->check(at_least_zero());
    app->add_option("--radius-max", o->max_radius,
                    "Radius at pressure 1, metres, >= 0. Default: from the recorded stroke; with a --scale given 0.005")
        ->check(at_least_zero());
    o->surface.add_to(*app);
    app->add_option("--save-guide", o->save_guide, "Write the style's guide")->type_name("G.xyz");
    return {app, [o, &common] { with_option_names(o->apply.drives_said(), [&] { run_replay(*o, common); }); }};
}

}  // namespace flg::cli
