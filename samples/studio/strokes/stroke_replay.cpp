// SPDX-License-Identifier: MIT
#include "strokes/stroke_replay.h"

namespace flg::studio {
namespace {

// Each stroke that is drawn again takes memory of its own until the end.
constexpr size_t kMostAtOnce = 256;

}  // namespace

void StrokeReplay::start(const StrokeLayer& layer, float speed) {
    stop();
    if (layer.strokes.empty()) return;
    layer_ = layer.id;
    speed_ = speed;
    stroke_ = sample_ = 0;
    stroke_start_s_ = desk_.seconds;
}

void StrokeReplay::stop() {
    layer_ = 0;
    pens_.clear();
}

void StrokeReplay::update(const StrokeDocument& document) {
    if (layer_ == 0) return;
    const StrokeLayer* layer = document.find(layer_);
    if (layer == nullptr || stroke_ >= std::min(layer->strokes.size(), kMostAtOnce)) {
        stop();
        return;
    }
    const std::vector<StrokeSample>& samples = layer->strokes[stroke_]->samples;
    if (sample_ == 0) {
        const filigree::Style* style = shelf_.get(document, layer->settings.style, layer->settings.patch);
        if (style == nullptr) return stop();
        // The pen has to be warm before it is put down.
        if (!(shelf_.info(*style).displacement_rms > 0.0f) || !shelf_.warm(*style, layer->settings.temperature)) {
            stroke_start_s_ = desk_.seconds;
            return;
        }
        pens_.push_back(std::make_unique<LivePen>(desk_, shelf_));
        pens_.back()->begin(document, layer->settings, static_cast<uint32_t>(stroke_), layer->strokes[stroke_]->color);
    }
    const double now = (desk_.seconds - stroke_start_s_) * static_cast<double>(speed_);
    const auto first = static_cast<double>(samples.front().time);
    while (sample_ < samples.size() && static_cast<double>(samples[sample_].time) - first <= now)
        pens_.back()->add(samples[sample_++]);
    if (sample_ < samples.size()) return;
    ++stroke_;
    sample_ = 0;
    stroke_start_s_ = desk_.seconds;
}

void StrokeReplay::device_lost() {
    for (const auto& pen : pens_) pen->device_lost();
    stop();
}

}  // namespace flg::studio
