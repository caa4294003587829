// SPDX-License-Identifier: MIT
#include "strokes/stroke_layers.h"

#include <algorithm>

namespace flg::studio {
namespace {

// Settings that the result depends on: the others are the renderer's.
StrokeSettings made_by(StrokeSettings settings) {
    settings.color = settings.color_end = glm::vec3(0.0f);
    if (settings.shape != StrokeShape::raw) settings.shape = StrokeShape::tube;
    return settings;
}

}  // namespace

render::CurveLook look_of(const StrokeSettings& settings) {
    render::CurveLook look;
    look.shape = settings.shape == StrokeShape::ribbon ? render::Shape::ribbon : render::Shape::tube;
    look.color = settings.color;
    look.color_end = settings.color_end;
    look.radius = 0.001f * settings.radius_mm;
    look.gloss = 0.5f;
    return look;
}

StrokeLayers::~StrokeLayers() {
    for (auto& [id, shown] : layers_) desk_.renderer.remove(shown.drawn);
}

void StrokeLayers::update(const StrokeDocument& document, uint32_t hidden) {
    std::erase_if(layers_, [&](auto& item) {
        if (document.find(item.first) != nullptr || item.second.running) return false;
        desk_.renderer.remove(item.second.drawn);
        return true;
    });
    busy_ = false;
    for (const StrokeLayer& layer : document.layers) {
        Shown& shown = layers_[layer.id];
        const bool same = shown.strokes == layer.strokes && made_by(shown.settings) == made_by(layer.settings);
        if (!same) shown.failed = false;
        if (!same && !shown.running) start(document, layer, shown);
        busy_ = busy_ || shown.running;
        if (shown.drawn.value == 0 && !shown.running && shown.result && !layer.strokes.empty()) upload(layer, shown);
        if (shown.drawn.value == 0) continue;
        if (!(shown.look == layer.settings) && same && !shown.running) upload(layer, shown);
        const bool visible = layer.visible && layer.id != hidden;
        if (visible != shown.drawn_visible) desk_.renderer.set_visible(shown.drawn, visible);
        shown.drawn_visible = visible;
    }
}

void StrokeLayers::start(const StrokeDocument& document, const StrokeLayer& layer, Shown& shown) {
    if (layer.strokes.empty()) {
        desk_.renderer.remove(std::exchange(shown.drawn, {}));
        shown.strokes.clear();
        shown.settings = layer.settings;
        shown.result = {};
        return;
    }
    const filigree::Style* style = shelf_.get(document, layer.settings.style, layer.settings.patch);
    if (style == nullptr) return;
    const float rms = shelf_.info(*style).displacement_rms;
    if (!(rms > 0.0f)) {
        busy_ = true;  // the style is on its way
        return;
    }
    const StrokeArrays arrays(layer.strokes);
    const filigree::CurveSet samples = desk_.context.curves(arrays.view());
    FlgLiveStrokeDesc desc = live_desc(layer.settings, rms);
    desc.style = style->get();
    FlgCurveSet made{};
    FlgJob job{};
    filigree::check(flgLiveStrokeReplay(desk_.context.get(), &desc, samples.get(), nullptr, &made, &job));
    shown.coming = filigree::CurveSet(desk_.context.get(), made);
    shown.strokes = layer.strokes;
    shown.settings = layer.settings;
    shown.running = true;
    desk_.jobs.add("Drawing " + layer.name, filigree::Job(desk_.context.get(), job),
                   [this, id = layer.id, &document](const FlgJobStatus& status) {
                       Shown& ended = layers_.at(id);
                       ended.running = false;
                       if (status.result == FLG_OK) ended.result = std::move(ended.coming);
                       const StrokeLayer* still = document.find(id);
                       if (status.result == FLG_OK && still != nullptr && !still->strokes.empty())
                           upload(*still, ended);
                   });
}

void StrokeLayers::upload(const StrokeLayer& layer, Shown& shown) {
    FlgCurveSetView view = shown.result.view();
    std::vector<FlgColumn> columns(view.columns, view.columns + view.column_count);
    std::vector<float> colors;
    const bool colored = std::any_of(shown.strokes.begin(), shown.strokes.end(),
                                     [](const StrokePtr& stroke) { return stroke->color.has_value(); });
    if (colored) {
        for (uint32_t c = 0; c < view.curve_count; ++c) {
            const glm::vec3 color = shown.strokes[c]->color.value_or(layer.settings.color);
            for (uint32_t i = view.curve_offsets[c]; i < view.curve_offsets[c + 1]; ++i)
                colors.insert(colors.end(), {color.x, color.y, color.z, 1.0f});
        }
        columns.push_back({FLG_ATTRIBUTE_COLOR, 4, colors.data(), 0, 0});
        view.columns = columns.data();
        view.column_count = static_cast<uint32_t>(columns.size());
    }
    if (shown.drawn.value == 0)
        shown.drawn = desk_.renderer.upload(view, look_of(layer.settings));
    else
        desk_.renderer.update(shown.drawn, view, look_of(layer.settings));
    shown.look = layer.settings;
}

size_t StrokeLayers::point_count() const {
    size_t count = 0;
    for (const auto& [id, shown] : layers_) {
        if (!shown.result) continue;
        const FlgCurveSetView view = shown.result.view();
        if (view.curve_count > 0) count += view.curve_offsets[view.curve_count];
    }
    return count;
}

const filigree::CurveSet* StrokeLayers::result(uint32_t layer) const {
    const auto found = layers_.find(layer);
    return found != layers_.end() && found->second.result ? &found->second.result : nullptr;
}

void StrokeLayers::device_lost() {
    for (auto& [id, shown] : layers_) {
        shown.drawn = {};
        shown.drawn_visible = true;
    }
}

}  // namespace flg::studio
