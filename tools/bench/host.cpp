// SPDX-License-Identifier: MIT
#include "bench/host.h"

#include <cmath>
#include <stdexcept>

namespace flg::bench {
namespace {

// The longest sleep; it ends when there is something to publish.
constexpr uint32_t kWaitUs = 10'000;

}  // namespace

void check(FlgResult result) {
    if (result != FLG_OK) throw std::runtime_error(std::string("bench: ") + flgErrorGetMessage());
}

Host::Host(const FlgAllocator& allocator, const FlgClock& clock, uint32_t workers) {
    FlgContextDesc desc = flgContextDefaults();
    desc.worker_count = workers;
    desc.allocator = &allocator;
    desc.clock = &clock;
    check(flgContextCreate(&desc, &context_));
}

Host::~Host() {
    flgContextDestroy(context_);
}

FlgCurveSet Host::add(std::span<const scenes::Curve> curves, std::span<const FlgColumn> more) {
    std::vector<uint32_t> offsets = {0};
    std::vector<scenes::Point> points;
    std::vector<uint8_t> flags;
    for (const scenes::Curve& curve : curves) {
        points.insert(points.end(), curve.points.begin(), curve.points.end());
        offsets.push_back(static_cast<uint32_t>(points.size()));
        flags.push_back(curve.closed ? FLG_CURVE_CLOSED : 0);
    }
    std::vector<FlgColumn> columns = {{FLG_ATTRIBUTE_POSITION, 3, &points[0].x, 0, 0}};
    columns.insert(columns.end(), more.begin(), more.end());
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(curves.size());
    view.curve_offsets = offsets.data();
    view.curve_flags = flags.data();
    view.columns = columns.data();
    view.column_count = static_cast<uint32_t>(columns.size());
    FlgCurveSet set = {};
    check(flgCurveSetCreate(context_, &view, &set));
    return set;
}

FlgStyle Host::prepare(FlgCurveSet curve, uint32_t point_count, FlgJob* job) {
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = curve;
    desc.point_count = point_count;
    FlgStyle style = {};
    check(flgStyleCreate(context_, &desc, &style, job));
    return style;
}

void Host::run() {
    FlgFrameReport report = {};
    report.struct_size = sizeof report;
    do {
        check(flgContextTick(context_, FLG_UNLIMITED, &report));
        if (report.jobs_pending > 0) flgContextWait(context_, kWaitUs);
    } while (report.jobs_pending > 0);
}

FlgCurveSetView Host::view(FlgCurveSet set) {
    FlgCurveSetView view = flgCurveSetViewDefaults();
    check(flgCurveSetGetView(context_, set, &view));
    return view;
}

FlgStyleInfo Host::info(FlgStyle style) {
    FlgStyleInfo info = {};
    info.struct_size = sizeof info;
    check(flgStyleGetInfo(context_, style, &info));
    return info;
}

void Host::check_done(FlgJob job) {
    FlgJobStatus status = {};
    status.struct_size = sizeof status;
    check(flgJobGetStatus(context_, job, &status));
    if (status.result != FLG_OK) throw std::runtime_error(std::string("bench: ") + status.error);
}

double length_of(const scenes::Curve& curve) {
    double length = 0.0;
    for (size_t i = 1; i < curve.points.size(); ++i) {
        const scenes::Point &p = curve.points[i - 1], &q = curve.points[i];
        length += std::hypot(q.x - p.x, q.y - p.y, q.z - p.z);
    }
    return length;
}

float scale_for(const FlgStyleInfo& style, double target_length, uint32_t count) {
    return static_cast<float>(target_length / ((count - 1.0) * style.spacing));
}

}  // namespace flg::bench
