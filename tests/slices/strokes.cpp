// SPDX-License-Identifier: MIT
// Curves, styles, stylization, live strokes.
#include <cmath>
#include <cstring>

#include "slices/sized_jobs.h"

namespace flg::slices {

namespace {

struct Line {
    std::vector<float> positions, radii;
    std::vector<uint32_t> offsets{0};
};

// A walk along a torus knot; every tenth point a corner, if asked for. In curves of `points_each`.
Line walk(uint32_t size, bool corners, uint32_t points_each) {
    Line line;
    for (uint32_t i = 0; i < size; ++i) {
        const double t = 1e-2 * i, off = corners && i % 20 < 10 ? 0.01 * (i % 10) : 0.01 * (corners ? 10 - i % 10 : 0);
        const double r = 2 + std::cos(0.31 * t);
        line.positions.insert(line.positions.end(),
                              {static_cast<float>(r * std::cos(t)), static_cast<float>(r * std::sin(t)),
                               static_cast<float>(std::sin(0.31 * t) + off)});
        line.radii.push_back(static_cast<float>(0.02 + 0.01 * std::sin(t)));
        if (i + 1 == size || (i + 1) % points_each == 0) line.offsets.push_back(i + 1);
    }
    return line;
}

FlgCurveSet create(WatchedHost& host, const Line& line) {
    const FlgColumn columns[] = {{FLG_ATTRIBUTE_POSITION, 3, line.positions.data(), 0, 0},
                                 {FLG_ATTRIBUTE_RADIUS, 1, line.radii.data(), 0, 0}};
    FlgCurveSetView view = flgCurveSetViewDefaults();
    view.curve_count = static_cast<uint32_t>(line.offsets.size()) - 1;
    view.curve_offsets = line.offsets.data();
    view.columns = columns;
    view.column_count = 2;
    FlgCurveSet set{};
    host.copy("flgCurveSetCreate", flgCurveSetCreate, &view, &set);
    host.made("flgCurveSetRelease", flgCurveSetRelease, set);
    return set;
}

FlgCurveSet create(WatchedHost& host, uint32_t size) {
    return create(host, walk(size, false, size));
}

FlgStyle create_style(WatchedHost& host, uint32_t points, float phase = 0) {
    Line coil;
    for (uint32_t i = 0; i < points; ++i) {
        const double t = static_cast<double>(i) / (points - 1), u = 2 * M_PI * (points / 20.0) * t + double{phase};
        coil.positions.insert(coil.positions.end(),
                              {static_cast<float>(2 * t + 0.05 * std::cos(u)), static_cast<float>(0.1 * std::sin(u)),
                               static_cast<float>(0.1 * std::cos(1.7 * u))});
        coil.radii.push_back(static_cast<float>(0.02 + 0.005 * std::sin(u)));
    }
    coil.offsets.push_back(points);
    FlgStyleDesc desc = flgStyleDefaults();
    desc.style = create(host, coil);
    FlgStyle style{};
    host.call("flgStyleCreate", flgStyleCreate, &desc, &style, host.job());
    host.made("flgStyleRelease", flgStyleRelease, style);
    return style;
}

void finish_set(WatchedHost& host, FlgCurveSet set) {
    host.made("flgCurveSetRelease", flgCurveSetRelease, set);
    host.finish();
}

void resample(WatchedHost& host, uint32_t size) {
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = create(host, size);
    desc.spacing = 0.02f;
    desc.frame = FLG_FRAME_METHOD_ROTATION_MINIMIZING;
    FlgCurveSet out{};
    host.call("flgCurveSetResample", flgCurveSetResample, &desc, &out, host.job());
    finish_set(host, out);
}

void resample_many(WatchedHost& host, uint32_t size) {
    FlgCurveSetResampleDesc desc = flgCurveSetResampleDefaults();
    desc.curves = create(host, walk(size, false, 5));
    desc.spacing = 0.02f;
    FlgCurveSet out{};
    host.call("flgCurveSetResample", flgCurveSetResample, &desc, &out, host.job());
    finish_set(host, out);
}

void simplify(WatchedHost& host, uint32_t size) {
    const float tolerances[] = {0.001f, 0.01f, 0.3f};
    FlgCurveSetSimplifyDesc desc = flgCurveSetSimplifyDefaults();
    desc.curves = create(host, size);
    desc.tolerances = tolerances;
    desc.level_count = 3;
    FlgCurveSet out{};
    host.call("flgCurveSetSimplify", flgCurveSetSimplify, &desc, &out, host.job());
    finish_set(host, out);
}

void prepare(WatchedHost& host, uint32_t size) {
    create_style(host, size);
    host.finish();
}

void warm(WatchedHost& host, uint32_t size) {
    const FlgStyle style = create_style(host, size);
    host.finish();
    host.call("flgStyleWarm", flgStyleWarm, style, 1.0f, nullptr, host.job());
    host.finish();
}

// As many points as the target has, about.
FlgCurveSetStylizeDesc to_stylize(WatchedHost& host, FlgCurveSet target) {
    FlgCurveSetStylizeDesc desc = flgCurveSetStylizeDefaults();
    desc.style = create_style(host, 100);
    host.finish();
    FlgStyleInfo info = flgStyleInfoDefaults();
    host.call("flgStyleGetInfo", flgStyleGetInfo, desc.style, &info);
    desc.target = target;
    desc.scale = 0.025f / info.spacing;
    desc.temperature = 0.5f;
    return desc;
}

void stylize(WatchedHost& host, const FlgCurveSetStylizeDesc& desc) {
    FlgCurveSet out{};
    host.call("flgCurveSetStylize", flgCurveSetStylize, &desc, &out, host.job());
    finish_set(host, out);
}

void stylize_one(WatchedHost& host, uint32_t size) {
    stylize(host, to_stylize(host, create(host, size)));
}

void stylize_hair(WatchedHost& host, uint32_t size) {
    FlgCurveSetStylizeDesc desc = to_stylize(host, create(host, walk(size, false, 100)));
    desc.scale = 0;
    desc.strokes = 2;
    desc.keep_displacement = 1;
    desc.frame = FLG_FRAME_METHOD_FRENET;
    stylize(host, desc);
}

// Everything at once.
void stylize_corners(WatchedHost& host, uint32_t size) {
    FlgCurveSetStylizeDesc desc = to_stylize(host, create(host, walk(size, true, size / 2)));
    const FlgStyle other = create_style(host, 80, 1);
    const FlgStyleDrive choice = {FLG_ATTRIBUTE_RADIUS, FLG_STYLE_DRIVEN_STYLE, 0.01f, 0.03f, 0, 1};
    desc.further_styles = &other;
    desc.further_style_count = 1;
    desc.drives = &choice;
    desc.drive_count = 1;
    desc.corners = FLG_STYLE_CORNERS_MOTIFS;
    desc.corner_angle = 0.3f;
    desc.pin_ends = 1;
    desc.smooth_junctions = 1;
    stylize(host, desc);
}

void write(WatchedHost& host, uint32_t size) {
    const FlgCurveSet set = create(host, size);
    std::vector<float> positions(size_t{3} * size);
    const FlgBufferColumn column = {
        FLG_ATTRIBUTE_POSITION, FLG_NUMBER_FORMAT_FLOAT32, positions.data(), 0, 0, {}, 0, 0};
    FlgBufferOutput output = flgBufferOutputDefaults();
    output.columns = &column;
    output.column_count = 1;
    output.row_capacity = size;
    host.call("flgCurveSetWrite", flgCurveSetWrite, set, &output, nullptr, host.job());
    host.finish();
}

void live(WatchedHost& host, uint32_t size) {
    FlgLiveStrokeDesc desc = flgLiveStrokeDefaults();
    desc.style = create_style(host, 100);
    host.finish();
    host.call("flgStyleWarm", flgStyleWarm, desc.style, 0.0f, nullptr, host.job());
    host.finish();
    desc.max_samples = size;
    desc.max_points = 8 * size;
    desc.scale = 0.5f;
    FlgLiveStroke stroke{};
    host.copy("flgLiveStrokeBegin", flgLiveStrokeBegin, &desc, &stroke);
    const Line hand = walk(size, false, size);
    FlgCurveSetView view = flgCurveSetViewDefaults();
    for (uint32_t i = 0; i < size; i += 10) {
        FlgLiveSampleView samples = flgLiveSampleViewDefaults();
        samples.sample_count = std::min(10u, size - i);
        samples.positions = hand.positions.data() + size_t{3} * i;
        host.call("flgLiveStrokePush", flgLiveStrokePush, stroke, &samples, &view);
    }
    FlgCurveSet stylized{}, recorded{}, first{}, second{}, again{};
    host.call("flgLiveStrokeEnd", flgLiveStrokeEnd, stroke, nullptr, &stylized, &recorded, host.job());
    host.finish();
    host.call("flgLiveStrokeSplit", flgLiveStrokeSplit, stroke, size / 2, nullptr, &first, &second, host.job());
    host.call("flgLiveStrokeReplay", flgLiveStrokeReplay, &desc, recorded, nullptr, &again, host.job());
    host.made("flgLiveStrokeRelease", flgLiveStrokeRelease, stroke);
    for (const FlgCurveSet set : {stylized, recorded, first, second, again})
        host.made("flgCurveSetRelease", flgCurveSetRelease, set);
    host.finish();
}

constexpr uint32_t largest_style = 4096;

constexpr SizedJob all[] = {
    {"resample", resample},
    {"resample_many", resample_many},
    {"simplify", simplify},
    {"style", prepare, largest_style},
    {"style_warm", warm, largest_style},
    {"stylize", stylize_one},
    {"stylize_hair", stylize_hair},
    {"stylize_corners", stylize_corners},
    {"curves_write", write},
    {"live", live, 1u << 18},
};

}  // namespace

std::span<const SizedJob> stroke_jobs() {
    return all;
}

}  // namespace flg::slices
