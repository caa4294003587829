// SPDX-License-Identifier: MIT
#include "live_strokes/painter.h"
#include "support/live_sample.h"

#include <chrono>
#include <stdexcept>

namespace flg::samples {
namespace {

using Clock = std::chrono::steady_clock;

constexpr uint32_t kMaxSamples = 8192, kMaxPoints = 1u << 17;  // of a stroke
constexpr uint32_t kTickUs = 1000;
const glm::vec3 kColors[] = {
    {0.90f, 0.13f, 0.03f}, {0.05f, 0.30f, 0.62f}, {0.95f, 0.50f, 0.04f}, {0.50f, 0.02f, 0.22f}, {0.06f, 0.42f, 0.30f}};

void check(FlgResult result) {
    if (result != FLG_OK) throw std::runtime_error(flgErrorGetMessage());
}

FlgFrameReport tick_context(FlgContext context) {
    FlgFrameReport report = {};
    report.struct_size = sizeof report;
    check(flgContextTick(context, kTickUs, &report));
    return report;
}

FlgJobStatus status_of(FlgContext context, FlgJob job) {
    FlgJobStatus status = {};
    status.struct_size = sizeof status;
    check(flgJobGetStatus(context, job, &status));
    if (status.state == FLG_JOB_STATE_FINISHED && status.result != FLG_OK) throw std::runtime_error(status.error);
    return status;
}

void finish(FlgContext context, FlgJob job) {
    while (status_of(context, job).state != FLG_JOB_STATE_FINISHED) tick_context(context);
    check(flgJobRelease(context, job));
}

}  // namespace

Painter::Painter(render::Renderer& renderer, const CurveSource& style, float displacement) : renderer_(renderer) {
    FlgContextDesc context_desc = flgContextDefaults();
    context_desc.worker_count = 1;
    check(flgContextCreate(&context_desc, &context_));
    try {
        FlgStyleDesc style_desc = flgStyleDefaults();
        const CurveRange first(style.view(), 0, 1);
        check(flgCurveSetCreate(context_, &first.view(), &style_desc.style));
        desc_ = flgLiveStrokeDefaults();
        FlgJob job = {};
        check(flgStyleCreate(context_, &style_desc, &desc_.style, &job));
        finish(context_, job);
        check(flgStyleWarm(context_, desc_.style, desc_.temperature, nullptr, &job));
        finish(context_, job);
        FlgStyleInfo info = {};
        info.struct_size = sizeof info;
        check(flgStyleGetInfo(context_, desc_.style, &info));
        desc_.scale = displacement / info.displacement_rms;
        desc_.min_radius = 0.0016f;
        desc_.max_radius = 0.0055f;
        desc_.max_samples = kMaxSamples;
        desc_.max_points = kMaxPoints;
    } catch (...) {
        flgContextDestroy(context_);
        throw;
    }
}

Painter::~Painter() {
    flgContextDestroy(context_);
}

Added Painter::paint(const XrController& controller, double time_s) {
    Added added;
    const bool pressed = controller.trigger > 0.0f;
    if (pressed && !pressed_) begin();
    if (pressed) push(controller, time_s, added);
    if (!pressed && pressed_) end();
    pressed_ = pressed;
    return added;
}

void Painter::begin() {
    desc_.seed = stroke_count_ + 1;
    stroke_ = {};
    check(flgLiveStrokeBegin(context_, &desc_, &stroke_.live));
    const glm::vec3 color = kColors[stroke_count_ % std::size(kColors)];
    const auto shape = stroke_count_ % 3 == 2 ? render::Shape::tube : render::Shape::ribbon;
    stroke_.curve = renderer_.begin_growing({.shape = shape, .color = color, .color_end = color}, kMaxPoints);
    ++stroke_count_;
}

void Painter::push(const XrController& controller, double time_s, Added& added) {
    LiveSample sample = {};
    const glm::quat& turned = controller.pose.orientation;
    for (int i = 0; i < 3; ++i) sample.position[i] = controller.pose.position[i];
    sample.orientation[0] = turned.x;
    sample.orientation[1] = turned.y;
    sample.orientation[2] = turned.z;
    sample.orientation[3] = turned.w;
    sample.pressure = controller.trigger;
    sample.time = time_s;
    const FlgLiveSampleView pushed = view_of(sample);
    FlgCurveSetView fresh = flgCurveSetViewDefaults();
    const auto before = Clock::now();
    FlgResult result = flgLiveStrokePush(context_, stroke_.live, &pushed, &fresh);
    added.push_us += std::chrono::duration<double, std::micro>(Clock::now() - before).count();
    if (result == FLG_ERROR_LIMIT) {  // too far, or full: the next stroke begins here
        end();
        begin();
        result = flgLiveStrokePush(context_, stroke_.live, &pushed, &fresh);
    }
    check(result);
    ++added.samples;
    append(stroke_, fresh, added);
    show_tip(stroke_, added);
    ++added.strokes;
}

void Painter::end() {
    check(flgLiveStrokeEnd(context_, stroke_.live, nullptr, nullptr, nullptr, &stroke_.ending));
    ending_.push_back(stroke_);
}

// In place of the tip that was shown before.
void Painter::append(Stroke& stroke, const FlgCurveSetView& view, Added& added) {
    renderer_.truncate(stroke.curve, stroke.points);
    if (view.curve_count == 0) return;
    renderer_.append(stroke.curve, view);
    const uint32_t points = view.curve_offsets[1];
    stroke.points += points;
    point_count_ += points;
    added.points += points;
}

void Painter::show_tip(const Stroke& stroke, Added& added) {
    FlgCurveSetView tip = flgCurveSetViewDefaults();
    check(flgLiveStrokeGetTip(context_, stroke.live, &tip));
    if (tip.curve_count == 0) return;
    const PointRange provisional(tip, stroke.points > 0 ? 1 : 0);  // it begins with the last point that stays
    renderer_.append(stroke.curve, provisional.view());
    added.tips += provisional.view().curve_offsets[1];
}

FlgFrameReport Painter::tick(Added& in_out_added) {
    const FlgFrameReport report = tick_context(context_);
    std::erase_if(ending_, [&](Stroke& stroke) {
        if (status_of(context_, stroke.ending).state != FLG_JOB_STATE_FINISHED) return false;
        FlgCurveSetView whole = flgCurveSetViewDefaults();
        check(flgLiveStrokeGetPoints(context_, stroke.live, &whole));
        // What its end has added.
        append(stroke, PointRange(whole, stroke.points).view(), in_out_added);
        ++in_out_added.strokes;
        check(flgJobRelease(context_, stroke.ending));
        check(flgLiveStrokeRelease(context_, stroke.live));
        return true;
    });
    return report;
}

}  // namespace flg::samples
