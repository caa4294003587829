// SPDX-License-Identifier: MIT
#include "strokes/stroke_replay.h"

#include "strokes/standing_strokes.h"

namespace flg::studio {
namespace {

// Each stroke that is drawn again takes memory of its own until the end.
constexpr size_t kMaxAtOnce = 256;

}  // namespace

void StrokeReplay::start(const StrokeLayer& layer, float speed) {
    stop();
    if (layer.strokes.empty()) return;
    layer_ = layer.id;
    speed_ = speed;
    stroke_ = sample_ = 0;
    stroke_start_s_ = app_.seconds;
}

void StrokeReplay::stop() {
    layer_ = 0;
    pens_.clear();
}

void StrokeReplay::update(const StrokeDocument& document) {
    if (layer_ == 0) return;
    const StrokeLayer* layer = document.find(layer_);
    if (layer == nullptr || stroke_ >= std::min(layer->strokes.size(), kMaxAtOnce)) {
        stop();
        return;
    }
    const Stroke& stroke = layer->strokes[stroke_];
    const std::vector<StrokeSample>& samples = stroke.drawn->samples;
    const render::Placement move = moved(app_.scene, *stroke.drawn);
    if (!is_seen(app_.scene, *stroke.drawn)) {
        ++stroke_;
        return;
    }
    if (sample_ == 0) {
        const filigree::Style* style = style_cache_.get(document, *stroke.settings);
        if (style == nullptr) return stop();
        // The pen has to be warm before it is put down.
        if (!(style_cache_.info(*style).displacement_rms > 0.0f) ||
            !style_cache_.warm(*style, stroke.settings->temperature)) {
            stroke_start_s_ = app_.seconds;
            return;
        }
        pens_.push_back(std::make_unique<LivePen>(app_, style_cache_));
        Stroke placed = stroke;
        if (move.scale != 1.0f) {
            StrokeSettings settings = *stroke.settings;
            settings.radius_mm *= move.scale;
            settings.scale_cm *= move.scale;
            placed.settings = std::make_shared<StrokeSettings>(settings);
        }
        pens_.back()->begin(document, placed);
    }
    const double now = (app_.seconds - stroke_start_s_) * static_cast<double>(speed_);
    const auto first = static_cast<double>(samples.front().time);
    while (sample_ < samples.size() && static_cast<double>(samples[sample_].time) - first <= now) {
        StrokeSample sample = samples[sample_++];
        sample.position = move.point(sample.position);
        sample.normal = move.direction(sample.normal);
        pens_.back()->add(sample);
    }
    if (sample_ < samples.size()) return;
    ++stroke_;
    sample_ = 0;
    stroke_start_s_ = app_.seconds;
}

void StrokeReplay::device_lost() {
    for (const auto& pen : pens_) pen->device_lost();
    stop();
}

}  // namespace flg::studio
