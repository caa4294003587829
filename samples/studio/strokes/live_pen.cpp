// SPDX-License-Identifier: MIT
#include "strokes/live_pen.h"

#include <utility>

#include "support/curve_source.h"

namespace flg::studio {
namespace {

constexpr int kRests = 5;  // leave e^-5 of the lag

}  // namespace

void LivePen::begin(const StrokeDocument& document, const Stroke& like) {
    const StrokeSettings& settings = *like.settings;
    lift();
    stroke_ = {};
    if (like.drawn != nullptr) stroke_.size = like.drawn->size;
    down_ = true;
    const filigree::Style* style = style_cache_.get(document, settings);
    if (style == nullptr) return;
    const float rms = style_cache_.info(*style).displacement_rms;
    if (!(rms > 0.0f) || !style_cache_.warm(*style, settings.temperature)) return;
    FlgLiveStrokeDesc desc = live_desc(settings, rms, stroke_.size);
    desc.style = style->get();
    desc.seed += like.number;
    live_ = app_.context.begin(desc);
    if (!live_) return;
    render::CurveLook look = look_of(settings);
    if (like.drawn != nullptr && like.own_color && like.drawn->color) look.color = look.color_end = *like.drawn->color;
    drawn_ = app_.renderer.begin_growing(look, desc.max_points);
    final_points_ = 0;
}

void LivePen::add(const StrokeSample& sample) {
    if (!down_) return;
    stroke_.samples.push_back(sample);
    if (!live_) return;
    const samples::LiveSample live = live_sample(sample);
    const FlgLiveSampleView pushed = samples::view_of(live);
    FlgCurveSetView made = flgCurveSetViewDefaults();
    // A stroke that is full ends here on the screen; what is recorded goes on.
    if (flgLiveStrokePush(app_.context.get(), live_.get(), &pushed, &made) != FLG_OK) return;
    if (drawn_.value != 0) show(made);
}

void LivePen::show(const FlgCurveSetView& made) {
    app_.renderer.truncate(drawn_, final_points_);
    if (made.curve_count > 0) {
        app_.renderer.append(drawn_, made);
        final_points_ += made.curve_offsets[1];
    }
    const FlgCurveSetView tip = live_.tip();
    if (tip.curve_count == 0) return;
    const samples::PointRange provisional(tip, final_points_ > 0 ? 1 : 0);  // it begins with the last point that stays
    app_.renderer.append(drawn_, provisional.view());
}

void LivePen::stand_on(uint32_t mesh, const render::Placement& placement) {
    stroke_.on = mesh;
    stroke_.stood = placement;
}

StrokePtr LivePen::end() {
    // The line follows the hand with a lag: it catches up as if the hand had rested.
    for (int i = 0; i < kRests && !stroke_.samples.empty(); ++i) {
        StrokeSample rest = stroke_.samples.back();
        rest.time += kHandSmoothing_s;
        add(rest);
    }
    down_ = false;
    live_.reset();
    bool moved = false;
    for (const StrokeSample& sample : stroke_.samples)
        moved = moved || sample.position != stroke_.samples.front().position;
    if (!moved) {
        lift();
        return nullptr;
    }
    return std::make_shared<DrawnStroke>(std::move(stroke_));
}

void LivePen::lift() {
    app_.renderer.remove(std::exchange(drawn_, {}));
    live_.reset();
    down_ = false;
}

}  // namespace flg::studio
