// SPDX-License-Identifier: MIT
#include "strokes/live.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace flg::samples {
namespace {

// Styled points that a scene may have before the style is drawn larger than its strokes ask for.
constexpr double kMaxPoints = 4e5;

void check(FlgResult result) {
    if (result != FLG_OK) throw std::runtime_error(flgErrorGetMessage());
}

FlgJobStatus status_of(FlgContext context, FlgJob job) {
    FlgJobStatus status = {};
    status.struct_size = sizeof status;
    check(flgJobGetStatus(context, job, &status));
    return status;
}

float share(std::vector<float> values, double p) {
    if (values.empty()) return 0.0f;
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(p * static_cast<double>(values.size() - 1))];
}

double total_length(const FlgCurveSetView& view) {
    double length = 0.0;
    for (uint32_t c = 0; c < view.curve_count; ++c) length += curve_length(view, c);
    return length;
}

}  // namespace

Live::Live(uint32_t workers, uint32_t budget_us) : budget_us_(budget_us) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = workers;
    desc.worker_budget_us = budget_us;
    check(flgContextCreate(&desc, &context_));
}

Live::~Live() {
    flgContextDestroy(context_);
}

void Live::start(const CurveSource& style, std::vector<StrokeGroup>& groups) {
    FlgStyleDesc desc = flgStyleDefaults();
    const CurveRange first(style.view(), 0, 1);
    check(flgCurveSetCreate(context_, &first.view(), &desc.style));
    check(flgStyleCreate(context_, &desc, &style_, &style_job_));
    groups_ = &groups;
}

// The style's own displacement is known once it is prepared; then each group can be given its scale.
void Live::start_groups() {
    FlgStyleInfo info = {};
    info.struct_size = sizeof info;
    check(flgStyleGetInfo(context_, style_, &info));
    log_.style_points = info.point_count;
    double points = 0.0;
    for (StrokeGroup& group : *groups_) {
        points += total_length(group.strokes.view()) * info.displacement_rms / (group.displacement * info.spacing);
    }
    FlgJobOptions options = flgJobOptionsDefaults();
    options.partial_results = 1;
    const double enlargement = std::max(1.0, points / kMaxPoints);
    for (StrokeGroup& group : *groups_) {
        Item item = {&group};
        const FlgCurveSetView view = group.strokes.view();
        FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
        desc.job = &options;
        desc.style = style_;
        check(flgCurveSetCreate(context_, &view, &desc.target));
        desc.start = FLG_STYLE_START_RANDOM;
        desc.scale = static_cast<float>(enlargement * group.displacement / info.displacement_rms);
        check(flgCurveSetStylize(context_, &desc, &item.result, &item.job));
        check(flgCurveSetRelease(context_, desc.target));
        log_.target_points += group.strokes.point_count();
        items_.push_back(item);
    }
    log_.jobs = static_cast<uint32_t>(items_.size()) + 1;
    style_ready_ = true;
}

bool Live::frame(render::Renderer& renderer, render::Target& target, const render::Camera& camera) {
    const auto begin = std::chrono::steady_clock::now();
    FlgFrameReport report = {};
    report.struct_size = sizeof report;
    check(flgContextTick(context_, budget_us_, &report));
    log_.tick_us.push_back(report.tick_us);
    if (report.max_slice_us > log_.max_slice_us) {
        log_.max_slice_us = report.max_slice_us;
        log_.max_slice_stage = report.max_slice_stage;
    }
    bool working = true;
    if (style_ready_) {
        working = false;
        for (Item& item : items_) working |= show(item, renderer);
    } else if (const FlgJobStatus status = status_of(context_, style_job_); status.state == FLG_JOB_STATE_FINISHED) {
        if (status.result != FLG_OK) throw std::runtime_error(std::string("style: ") + status.error);
        log_.busy_ms += status.busy_us / 1000.0f;
        start_groups();
    }
    renderer.draw(target, camera);
    log_.frame_ms.push_back(std::chrono::duration<float, std::milli>(std::chrono::steady_clock::now() - begin).count());
    return working;
}

// Uploads the curves that have become visible since the last frame. Whether more will come.
bool Live::show(Item& item, render::Renderer& renderer) {
    if (item.curves_drawn == item.group->strokes.curve_count()) return false;
    const FlgJobStatus status = status_of(context_, item.job);
    if (status.state == FLG_JOB_STATE_FINISHED && status.result != FLG_OK) throw std::runtime_error(status.error);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    const FlgResult result = flgCurveSetGetView(context_, item.result, &view);
    if (result != FLG_OK && result != FLG_NOT_READY) check(result);
    if (view.curve_count > item.curves_drawn) {
        const CurveRange fresh(view, item.curves_drawn, view.curve_count - item.curves_drawn);
        renderer.upload(fresh.view(), {});
        log_.result_points += fresh.view().curve_offsets[fresh.view().curve_count];
        item.curves_drawn = view.curve_count;
    }
    if (status.state != FLG_JOB_STATE_FINISHED) return true;
    log_.busy_ms += status.busy_us / 1000.0f;
    return false;
}

float Live::progress() const {
    float sum = status_of(context_, style_job_).progress;
    for (const Item& item : items_) sum += status_of(context_, item.job).progress;
    return sum / static_cast<float>(groups_->size() + 1);
}

StrokeSet Live::result() const {
    StrokeSet all;
    for (const Item& item : items_) {
        FlgCurveSetView view = flgCurveSetViewDefaults();
        check(flgCurveSetGetView(context_, item.result, &view));
        all.add_all(view);
    }
    return all;
}

void FrameLog::write(const std::string& path, uint32_t budget_us, uint32_t workers, const std::string& device) const {
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (file == nullptr) throw std::runtime_error(path + ": can't be written");
    std::fprintf(file,
                 "{\"device\": \"%s\", \"workers\": %u, \"budget_us\": %u,\n"
                 " \"frames\": %zu, \"jobs\": %u, \"busy_ms\": %.3f,\n"
                 " \"points\": {\"style\": %llu, \"target\": %llu, \"result\": %llu},\n"
                 " \"tick_us\": {\"p50\": %.1f, \"p99\": %.1f, \"max\": %.1f},\n"
                 " \"frame_ms\": {\"p50\": %.2f, \"p99\": %.2f, \"max\": %.2f},\n"
                 " \"longest_chunk\": {\"us\": %.1f, \"stage\": \"%s\"}}\n",
                 device.c_str(), workers, budget_us, tick_us.size(), jobs, static_cast<double>(busy_ms),
                 static_cast<unsigned long long>(style_points), static_cast<unsigned long long>(target_points),
                 static_cast<unsigned long long>(result_points), static_cast<double>(share(tick_us, 0.5)),
                 static_cast<double>(share(tick_us, 0.99)), static_cast<double>(share(tick_us, 1.0)),
                 static_cast<double>(share(frame_ms, 0.5)), static_cast<double>(share(frame_ms, 0.99)),
                 static_cast<double>(share(frame_ms, 1.0)), static_cast<double>(max_slice_us), max_slice_stage.c_str());
    if (std::fclose(file) != 0) throw std::runtime_error(path + ": can't be written");
}

}  // namespace flg::samples
