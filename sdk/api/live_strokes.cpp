// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>

#include "api/context.h"
#include "api/descriptors.h"
#include "api/error.h"
#include "api/host_buffers.h"
#include "api/inputs.h"
#include "api/style_drives.h"
#include "core/number_text.h"
#include "stylization/live_jobs.h"

namespace flg {

namespace {

constexpr uint32_t samples_limit = 1u << 20;
constexpr uint32_t points_limit = 1u << 24;

FlgLiveStrokeDesc default_live_stroke_desc() {
    const LiveSettings settings;
    auto desc = sized<FlgLiveStrokeDesc>();
    desc.start = FLG_STYLE_START_AUTO;
    desc.magnitude = static_cast<float>(settings.magnitude);
    desc.scale = static_cast<float>(settings.styles[0].scale);
    desc.min_radius = 0.001f;
    desc.max_radius = 0.005f;
    desc.max_jump = 1.0f;
    desc.max_samples = 16'384;
    desc.max_points = 65'536;
    desc.frame = settings.frame;
    desc.seed = settings.seed;
    std::copy(settings.basis.begin(), settings.basis.end(), desc.basis);
    return desc;
}

void check(const FlgLiveStrokeDesc& desc) {
    check_enum(desc.start, FLG_STYLE_START_AUTO, FLG_STYLE_START_RANDOM, "desc.start", "FLG_STYLE_START_");
    check_range(std::isfinite(desc.magnitude), "desc.magnitude", desc.magnitude, "finite");
    check_range(desc.temperature >= 0 && std::isfinite(desc.temperature), "desc.temperature", desc.temperature,
                "finite and at least 0");
    check_range(desc.scale >= 0 && std::isfinite(desc.scale), "desc.scale", desc.scale, "finite and at least 0");
    check_range(desc.min_radius >= 0 && std::isfinite(desc.min_radius), "desc.min_radius", desc.min_radius,
                "finite and at least 0");
    check_range(desc.max_radius >= 0 && std::isfinite(desc.max_radius), "desc.max_radius", desc.max_radius,
                "finite and at least 0");
    check_range(desc.smoothing >= 0 && std::isfinite(desc.smoothing), "desc.smoothing", desc.smoothing,
                "finite and at least 0");
    check_range(desc.max_jump > 0 && std::isfinite(desc.max_jump), "desc.max_jump", desc.max_jump,
                "finite and above 0");
    check_range(desc.max_samples >= 1 && desc.max_samples <= samples_limit, "desc.max_samples", desc.max_samples,
                "1 to 2^20");
    check_range(desc.max_points >= 1 && desc.max_points <= points_limit, "desc.max_points", desc.max_points,
                "1 to 2^24");
    check_frame(desc.frame, "desc.frame");
    if (desc.frame == FLG_FRAME_METHOD_FRENET) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.frame is FLG_FRAME_METHOD_FRENET, whose normals depend on points that are not drawn yet; "
                      "live strokes "
                      "take FLG_FRAME_METHOD_ROTATION_MINIMIZING or FLG_FRAME_METHOD_SUPPLIED");
    }
    check_basis(desc.basis);
    check_further_styles(desc);
}

StyleDrives read_hand_drives(const FlgLiveStrokeDesc& desc) {
    const StyleDrives drives = read_drives(desc.drives, desc.drive_count);
    for (uint32_t k = 0; k < desc.drive_count; ++k) {
        const FlgAttribute attribute = drives.list()[k].attribute;
        if (attribute == FLG_ATTRIBUTE_PRESSURE || attribute == FLG_ATTRIBUTE_SPEED) continue;
        throw Failure(FLG_ERROR_INVALID_ARGUMENT,
                      "desc.drives[%u].attribute is %d, a hand has FLG_ATTRIBUTE_PRESSURE and FLG_ATTRIBUTE_SPEED", k,
                      number_of(attribute));
    }
    check_style_drive(drives, desc.further_style_count);
    return drives;
}

// desc.style, then desc.further_styles: visit(style, what it is called).
template <class Visit>
void each_style(Context& context, const FlgLiveStrokeDesc& desc, LiveStyleRequests& styles, const Visit& visit) {
    for (uint32_t k = 0; k <= desc.further_style_count; ++k) {
        const StyleArgument argument(k);
        const FlgStyle style = k == 0 ? desc.style : desc.further_styles[k - 1];
        styles[k].style = context.styles.get(style.id, argument.name);
        visit(styles[k], argument.name);
    }
}

void check_prepared(const Style& style, const char* name) {
    const FlgResult result = style.visible_result();
    if (result < 0) throw Failure(result, "%s", style.error());
    if (result == FLG_NOT_READY) {
        throw Failure(result, "%s is not prepared yet; tick until its job is done", name);
    }
}

// Throws FLG_NOT_READY if a tree is missing.
std::shared_ptr<PathTrees> warm_trees(Style& style, const char* name, float temperature, const char* whose) {
    std::shared_ptr<PathTrees> trees = style.trees(style.prepared.temperature(temperature));
    if (all_trees_made(*trees)) return trees;
    throw Failure(FLG_NOT_READY, "%s is not warm at %s, %s; call flgStyleWarm with it, and tick until its job is done",
                  name, whose, NumberText(temperature).c_str());
}

// The columns; what is in them: LiveStroke::push().
void check_samples(const FlgLiveSampleView& samples) {
    if (samples.sample_count > 0) require(samples.positions, "samples.positions");
    const bool fits = samples.stride >= 3 * sizeof(float) && samples.stride % alignof(float) == 0 &&
                      (!samples.orientations || samples.stride >= 4 * sizeof(float)) &&
                      (!samples.times || samples.stride % alignof(double) == 0);
    check_range(samples.stride == 0 || fits, "samples.stride", samples.stride,
                "0, or a multiple of 4 (with times of 8) of at least 12 (with orientations 16)");
    const auto check = [](const void* column, uint32_t alignment, const char* name) {
        if (column) check_aligned(column, alignment, name);
    };
    check(samples.positions, alignof(float), "samples.positions");
    check(samples.orientations, alignof(float), "samples.orientations");
    check(samples.pressures, alignof(float), "samples.pressures");
    check(samples.times, alignof(double), "samples.times");
}

FlgCurveSetView empty_view() {
    auto view = sized<FlgCurveSetView>();
    return view;
}

// Handles of the sets that a job is about to make: all of them are given out, or none.
class NewSets {
public:
    explicit NewSets(Context& context) : context_(context) {}
    // NOLINTNEXTLINE(bugprone-exception-escape): the table knows the handles that add() made.
    ~NewSets() {
        for (uint32_t i = 0; i < count_; ++i) context_.curve_sets.remove(out_[i]->id, "set");
        for (uint32_t i = 0; i < count_; ++i) *out_[i] = {};
    }
    NewSets(const NewSets&) = delete;
    NewSets& operator=(const NewSets&) = delete;

    // Null if it isn't wanted.
    std::shared_ptr<CurveSet> add(FlgCurveSet* out, const Origin& origin, Job& producer) {
        if (!out) return nullptr;
        Memory* const memory = context_.memory[MemoryKind::curves];
        auto set = make_object<CurveSet>(memory, memory);
        set->origin = origin;
        set->producer = producer.shared_from_this();
        *out = {context_.curve_sets.add(set)};
        out_[count_++] = out;
        return set;
    }
    void keep() { count_ = 0; }

private:
    Context& context_;
    FlgCurveSet* out_[2] = {};
    uint32_t count_ = 0;
};

}  // namespace

}  // namespace flg

using namespace flg;

extern "C" {

FlgResult flgStyleWarm(FlgContext context, FlgStyle style, float temperature, const FlgJobOptions* job,
                       FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        const std::shared_ptr<Style> warmed = self.styles.get(style.id, "style");
        check_range(temperature >= 0 && std::isfinite(temperature), "temperature", temperature,
                    "finite and at least 0");
        Submission submission(self, job);
        submission.read(*warmed, "style");
        submission.job().strand.start(warm_style(submission.pace(), warmed, temperature));
        submission.commit(nullptr, MemoryKind::caches, out_job);
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeDescInit(FlgLiveStrokeDesc* desc, uint32_t struct_size) {
    return init(desc, struct_size, default_live_stroke_desc());
}

FlgResult flgLiveStrokeBegin(FlgContext context, const FlgLiveStrokeDesc* desc, FlgLiveStroke* out_stroke) {
    return guarded([&] {
        require(out_stroke, "out_stroke") = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::curves];
        const FlgLiveStrokeDesc read = read_struct(desc, default_live_stroke_desc(), "desc");
        check(read);
        LiveStrokeRequest request;
        each_style(self, read, request.styles,
                   [](const LiveStyleRequest& one, const char* name) { check_prepared(*one.style, name); });
        request.style_count = read.further_style_count + 1;
        request.drives = read_hand_drives(read);
        const auto temperatures = request.drives.temperatures(read.temperature);
        const bool driven = request.drives.drive(FLG_STYLE_DRIVEN_TEMPERATURE);
        const char* const whose = driven ? "a temperature of desc.drives" : "desc.temperature";
        each_style(self, read, request.styles, [&](LiveStyleRequest& one, const char* name) {
            one.trees = warm_trees(*one.style, name, temperatures[0], whose);
            one.hot_trees = warm_trees(*one.style, name, temperatures[1], whose);
        });
        request.desc = read;
        request.origin = read_origin(read.origin, "desc.origin");
        *out_stroke = {self.live_strokes.add(make_object<LiveStroke>(memory, request, memory))};
        return FLG_OK;
    });
}

FlgResult flgLiveSampleViewInit(FlgLiveSampleView* view, uint32_t struct_size) {
    return init(view, struct_size, sized<FlgLiveSampleView>(), "view");
}

FlgResult flgLiveStrokePush(FlgContext context, FlgLiveStroke stroke, const FlgLiveSampleView* samples,
                            FlgCurveSetView* out_new) {
    return guarded([&] {
        if (out_new) write_struct(out_new, empty_view(), "out_new");
        LiveStroke& self = *get_context(context).live_strokes.get(stroke.id, "stroke");
        const FlgLiveSampleView read = read_struct(samples, sized<FlgLiveSampleView>(), "samples");
        check_samples(read);
        const uint32_t before = self.point_count();
        self.push(read);
        if (out_new) write_struct(out_new, self.view_from(before), "out_new");
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeGetPoints(FlgContext context, FlgLiveStroke stroke, FlgCurveSetView* out_view) {
    return guarded([&] {
        write_struct(out_view, empty_view(), "out_view");
        LiveStroke& self = *get_context(context).live_strokes.get(stroke.id, "stroke");
        write_struct(out_view, self.view_from(0), "out_view");
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeInfoInit(FlgLiveStrokeInfo* info, uint32_t struct_size) {
    return init(info, struct_size, sized<FlgLiveStrokeInfo>(), "info");
}

FlgResult flgLiveStrokeGetTip(FlgContext context, FlgLiveStroke stroke, FlgCurveSetView* out_tip) {
    return guarded([&] {
        write_struct(out_tip, empty_view(), "out_tip");
        LiveStroke& self = *get_context(context).live_strokes.get(stroke.id, "stroke");
        write_struct(out_tip, self.tip(), "out_tip");
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeGetInfo(FlgContext context, FlgLiveStroke stroke, FlgLiveStrokeInfo* out_info) {
    return guarded([&] {
        auto info = sized<FlgLiveStrokeInfo>();
        write_struct(out_info, info, "out_info");
        const LiveStroke& self = *get_context(context).live_strokes.get(stroke.id, "stroke");
        info.sample_count = self.sample_count();
        info.point_count = self.point_count();
        info.waiting_samples = self.waiting_samples();
        info.ended = self.phase() != LiveStroke::Phase::drawing;
        info.spacing = static_cast<float>(self.spacing());
        info.cut = self.cut();
        info.scale = static_cast<float>(self.scale());
        info.waiting_points = self.waiting_points();
        info.dense_samples = self.dense_samples();
        write_struct(out_info, info, "out_info");
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeUndo(FlgContext context, FlgLiveStroke stroke, uint32_t count, uint32_t* out_point_count) {
    return guarded([&] {
        if (out_point_count) *out_point_count = 0;
        LiveStroke& self = *get_context(context).live_strokes.get(stroke.id, "stroke");
        self.undo(count);
        if (out_point_count) *out_point_count = self.point_count();
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeEnd(FlgContext context, FlgLiveStroke stroke, const FlgJobOptions* job,
                           FlgCurveSet* out_stylized, FlgCurveSet* out_samples, FlgJob* out_job) {
    return guarded([&] {
        if (out_stylized) *out_stylized = {};
        if (out_samples) *out_samples = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::curves];
        const std::shared_ptr<LiveStroke> ended = self.live_strokes.get(stroke.id, "stroke");
        if (ended->phase() != LiveStroke::Phase::drawing) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "stroke has ended already");
        }
        if (ended->sample_count() == 0) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "stroke has no samples; release it");
        }
        Submission submission(self, job);
        NewSets sets(self);
        if (!job) submission.job().priority = FLG_PRIORITY_HIGH;
        const auto ending = make_object<LiveEnding>(memory);
        ending->stroke = ended;
        ending->handle = stroke.id;
        ending->stylized = sets.add(out_stylized, ended->origin, submission.job());
        ending->samples = sets.add(out_samples, ended->origin, submission.job());
        submission.job().strand.start(end_stroke(submission.pace(), *ending));
        ended->begin_end();
        try {
            submission.commit(ending, MemoryKind::curves, out_job);
        } catch (...) {
            ended->settle(false);
            throw;
        }
        sets.keep();
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeResume(FlgContext context, FlgLiveStroke stroke) {
    return guarded([&] {
        LiveStroke& self = *get_context(context).live_strokes.get(stroke.id, "stroke");
        if (self.phase() == LiveStroke::Phase::drawing) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "stroke has not ended");
        }
        if (self.readers > 0) return FLG_NOT_READY;
        self.resume();
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeSplit(FlgContext context, FlgLiveStroke stroke, uint32_t point, const FlgJobOptions* job,
                             FlgCurveSet* out_first, FlgCurveSet* out_second, FlgJob* out_job) {
    return guarded([&] {
        if (out_first) *out_first = {};
        if (out_second) *out_second = {};
        if (out_job) *out_job = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::curves];
        const std::shared_ptr<LiveStroke> cut = self.live_strokes.get(stroke.id, "stroke");
        if (cut->phase() == LiveStroke::Phase::drawing) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "stroke has not ended; end it first");
        }
        if (cut->phase() == LiveStroke::Phase::ending) return FLG_NOT_READY;
        if (point >= cut->point_count()) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "point is %u, stroke has %u points", point, cut->point_count());
        }
        Submission submission(self, job);
        NewSets sets(self);
        if (!job) submission.job().priority = FLG_PRIORITY_HIGH;
        const auto split = make_object<LiveSplit>(memory);
        split->stroke = cut;
        split->point = point;
        split->first = sets.add(out_first, cut->origin, submission.job());
        split->second = sets.add(out_second, cut->origin, submission.job());
        submission.job().strand.start(split_stroke(submission.pace(), *split));
        ++cut->readers;
        try {
            submission.commit(split, MemoryKind::curves, out_job);
        } catch (...) {
            --cut->readers;
            throw;
        }
        sets.keep();
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeRelease(FlgContext context, FlgLiveStroke stroke) {
    return guarded([&] {
        get_context(context).live_strokes.remove(stroke.id, "stroke");
        return FLG_OK;
    });
}

FlgResult flgLiveStrokeReplay(FlgContext context, const FlgLiveStrokeDesc* desc, FlgCurveSet samples,
                              const FlgJobOptions* job, FlgCurveSet* out_set, FlgJob* out_job) {
    return guarded([&] {
        if (out_job) *out_job = {};
        require(out_set, "out_set") = {};
        Context& self = get_context(context);
        Memory* const memory = self.memory[MemoryKind::curves];
        const FlgLiveStrokeDesc read = read_struct(desc, default_live_stroke_desc(), "desc");
        check(read);
        Submission submission(self, job);
        LiveReplayRequest request;
        request.desc = read;
        request.drives = read_hand_drives(read);
        request.style_count = read.further_style_count + 1;
        each_style(self, read, request.styles,
                   [&](const LiveStyleRequest& one, const char* name) { submission.read(*one.style, name); });
        request.samples = self.curve_sets.get(samples.id, "samples");
        submission.read(*request.samples, "samples");
        request.out = make_object<CurveSet>(memory, memory);
        request.out->origin = request.samples->origin;
        const std::shared_ptr<CurveSet> out = request.out;
        submission.job().strand.start(replay_strokes(submission.pace(), std::move(request)));
        *out_set = {submission.commit(self.curve_sets, out, out_job)};
        return FLG_OK;
    });
}

}  // extern "C"
