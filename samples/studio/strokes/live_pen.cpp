// SPDX-License-Identifier: MIT
#include "strokes/live_pen.h"

#include <utility>

namespace flg::studio {

void LivePen::begin(const StrokeDocument& document, const StrokeSettings& settings, uint32_t number,
                    const std::optional<glm::vec3>& color) {
    lift();
    stroke_ = {{}, color};
    down_ = true;
    const filigree::Style* style = shelf_.get(document, settings.style, settings.patch);
    if (style == nullptr) return;
    const float rms = shelf_.info(*style).displacement_rms;
    if (!(rms > 0.0f) || !shelf_.warm(*style, settings.temperature)) return;
    FlgLiveStrokeDesc desc = live_desc(settings, rms);
    desc.style = style->get();
    desc.seed += number;
    live_ = desk_.context.begin(desc);
    if (!live_) return;
    render::CurveLook look = look_of(settings);
    if (color) look.color = *color;
    drawn_ = desk_.renderer.begin_growing(look, desc.max_points);
}

void LivePen::add(const StrokeSample& sample) {
    if (!down_) return;
    stroke_.samples.push_back(sample);
    if (!live_) return;
    const FlgLiveSample live = live_sample(sample);
    FlgCurveSetView made = flgCurveSetViewDefaults();
    // A stroke that is full ends here on the screen; what is recorded goes on.
    if (flgLiveStrokePush(desk_.context.get(), live_.get(), &live, 1, &made) != FLG_OK) return;
    if (made.curve_count > 0 && drawn_.value != 0) desk_.renderer.append(drawn_, made);
}

StrokePtr LivePen::end() {
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
    desk_.renderer.remove(std::exchange(drawn_, {}));
    live_.reset();
    down_ = false;
}

}  // namespace flg::studio
