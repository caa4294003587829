// SPDX-License-Identifier: MIT
#include "strokes/stroke_layers.h"

#include <algorithm>

namespace flg::studio {
namespace {

// Whether the same result is made of both: colours and cross-sections are the renderer's.
bool makes_same(const StrokeSettings& a, const StrokeSettings& b) {
    StrokeSettings seen_as_b = a;
    seen_as_b.color = b.color;
    seen_as_b.color_end = b.color_end;
    seen_as_b.shape = b.shape;
    return seen_as_b == b;
}

bool makes_same(const std::vector<Stroke>& a, const std::vector<Stroke>& b) {
    const auto same = [](const Stroke& x, const Stroke& y) { return x.drawn == y.drawn; };
    if (!std::equal(a.begin(), a.end(), b.begin(), b.end(), same)) return false;
    return a.empty() || (a.front().number == b.front().number && makes_same(*a.front().settings, *b.front().settings));
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
    for (auto& [id, layer] : layers_)
        for (const std::list<Shown>* list : {&layer.groups, &layer.old})
            for (const Shown& shown : *list) app_.renderer.remove(shown.drawn);
}

std::vector<StrokeLayers::Group> StrokeLayers::groups_of(const std::vector<Stroke>& strokes) {
    std::map<std::pair<SettingsPtr, float>, size_t> index;  // whose order is that of addresses
    std::vector<Group> alike, groups;
    for (const Stroke& stroke : strokes) {
        const auto [found, is_new] = index.emplace(std::pair{stroke.settings, stroke.drawn->size}, alike.size());
        if (is_new) alike.emplace_back();
        alike[found->second].push_back(stroke);
    }
    for (Group& group : alike) {
        std::stable_sort(group.begin(), group.end(),
                         [](const Stroke& a, const Stroke& b) { return a.number < b.number; });
        for (const Stroke& stroke : group) {
            const bool follows = !groups.empty() && groups.back().back().settings == stroke.settings &&
                                 groups.back().back().drawn->size == stroke.drawn->size &&
                                 groups.back().back().number + 1 == stroke.number;
            if (!follows) groups.emplace_back();
            groups.back().push_back(stroke);
        }
    }
    return groups;
}

void StrokeLayers::regroup(LayerShown& layer, const std::vector<Stroke>& strokes) {
    layer.strokes = strokes;
    std::list<Shown> before;
    before.swap(layer.groups);
    const auto reuse = [&](Group& group, auto&& fits) {
        const auto found = std::find_if(before.begin(), before.end(), fits);
        if (found == before.end()) return false;
        found->wanted = std::move(group);
        layer.groups.splice(layer.groups.end(), before, found);
        return true;
    };
    // What stays as it is, then what got or lost strokes or other settings.
    std::vector<Group> changed;
    for (Group& group : groups_of(strokes)) {
        const auto stays = [&](const Shown& shown) { return makes_same(shown.wanted, group); };
        if (!reuse(group, stays)) changed.push_back(std::move(group));
    }
    for (Group& group : changed) {
        const auto grows = [&](const Shown& shown) {
            return shown.wanted.front().drawn == group.front().drawn &&
                   *shown.wanted.front().settings == *group.front().settings;
        };
        if (reuse(group, grows)) continue;
        layer.groups.emplace_back();
        layer.groups.back().id = ++last_id_;
        layer.groups.back().wanted = std::move(group);
    }
    layer.old.splice(layer.old.end(), before);
}

void StrokeLayers::update(const StrokeDocument& document, uint32_t hidden) {
    static const std::vector<Stroke> kNone;
    for (const StrokeLayer& layer : document.layers) layers_[layer.id];
    busy_ = false;
    for (auto it = layers_.begin(); it != layers_.end();) {
        LayerShown& shown_layer = it->second;
        const StrokeLayer* layer = document.find(it->first);
        const std::vector<Stroke>& strokes = layer != nullptr ? layer->strokes : kNone;
        if (shown_layer.strokes != strokes) regroup(shown_layer, strokes);
        bool coming = false;
        for (Shown& shown : shown_layer.groups) {
            const bool made = shown.result && makes_same(shown.made_of, shown.wanted);
            const bool tried = shown.failed && makes_same(shown.coming_of, shown.wanted);
            if (!made && !tried && !shown.running && layer != nullptr) start(document, *layer, shown);
            coming = coming || shown.running || (!made && !tried);
            if (!made) continue;
            const bool is_so =
                shown.is_shown && shown.drawn_of == shown.wanted && shown.stands == stands_of(shown.wanted);
            if (!is_so) upload(shown);
        }
        busy_ = busy_ || coming;
        std::erase_if(shown_layer.old, [&](const Shown& old) {
            if (old.running || (coming && layer != nullptr)) return false;
            app_.renderer.remove(old.drawn);
            return true;
        });
        const bool visible = layer != nullptr && layer->visible && layer->id != hidden && app_.scene.in_sight();
        for (std::list<Shown>* list : {&shown_layer.groups, &shown_layer.old}) {
            for (Shown& shown : *list) {
                if (shown.drawn.value == 0 || visible == shown.drawn_visible) continue;
                app_.renderer.set_visible(shown.drawn, visible);
                shown.drawn_visible = visible;
            }
        }
        const bool gone = layer == nullptr && shown_layer.groups.empty() && shown_layer.old.empty();
        it = gone ? layers_.erase(it) : std::next(it);
    }
}

StrokeLayers::Shown* StrokeLayers::find(uint32_t layer, uint32_t id) {
    LayerShown& shown_layer = layers_.at(layer);
    for (std::list<Shown>* list : {&shown_layer.groups, &shown_layer.old})
        for (Shown& shown : *list)
            if (shown.id == id) return &shown;
    return nullptr;
}

void StrokeLayers::start(const StrokeDocument& document, const StrokeLayer& layer, Shown& shown) {
    const Stroke& first = shown.wanted.front();
    const filigree::Style* style = style_cache_.get(document, *first.settings);
    shown.failed = style == nullptr;
    shown.coming_of = shown.wanted;
    if (style == nullptr) return;
    const float rms = style_cache_.info(*style).displacement_rms;
    if (!(rms > 0.0f)) return;  // the style is on its way
    const StrokeArrays arrays(shown.wanted);
    const filigree::CurveSet samples = app_.context.curve_set(arrays.view());
    FlgLiveStrokeDesc desc = live_desc(*first.settings, rms, first.drawn->size);
    desc.style = style->get();
    desc.seed += first.number;
    FlgCurveSet made{};
    FlgJob job{};
    filigree::check(flgLiveStrokeReplay(app_.context.get(), &desc, samples.get(), nullptr, &made, &job));
    shown.coming = filigree::CurveSet(app_.context.get(), made);
    shown.running = true;
    app_.jobs.add("Stylizing " + layer.name, filigree::Job(app_.context.get(), job),
                  [this, layer_id = layer.id, id = shown.id](const FlgJobStatus& status) {
                      Shown& ended = *find(layer_id, id);
                      ended.running = false;
                      ended.failed = status.result != FLG_OK;
                      if (ended.failed) return;
                      ended.made_of = std::move(ended.coming_of);
                      ended.result = std::move(ended.coming);
                      ended.holds = {};
                  });
}

std::vector<StrokeLayers::Stand> StrokeLayers::stands_of(const Group& group) const {
    std::vector<Stand> stands;
    for (const Stroke& stroke : group) {
        const uint32_t id = stroke.drawn->on;
        const auto is_it = [id](const Stand& stand) { return stand.mesh == id; };
        if (id == 0 || std::any_of(stands.begin(), stands.end(), is_it)) continue;
        const SceneMesh* mesh = app_.scene.find(id);
        Stand& stand = stands.emplace_back(Stand{id, mesh != nullptr && mesh->visible, {}});
        if (mesh == nullptr) continue;
        stand.placement = mesh->placement;
        if (mesh->bent() != nullptr) stand.bend = mesh->bent()->revision();
    }
    return stands;
}

void StrokeLayers::upload(Shown& shown) {
    FlgCurveSetView view = shown.result.view();
    const auto is_as_made = [&](const Stroke& stroke) {
        return !has_own_color(stroke) && is_seen(app_.scene, *stroke.drawn) &&
               moved(app_.scene, *stroke.drawn).is_identity() && !is_bent(app_.scene, *stroke.drawn);
    };
    StandingCurves standing(app_.scene);
    if (!std::all_of(shown.wanted.begin(), shown.wanted.end(), is_as_made)) {
        standing.add(view, shown.wanted, &shown.holds);
        view = standing.view(std::any_of(shown.wanted.begin(), shown.wanted.end(), has_own_color));
    }
    const render::CurveLook look = look_of(*shown.wanted.front().settings);
    if (view.curve_count == 0) {
        app_.renderer.remove(std::exchange(shown.drawn, {}));
        shown.drawn_visible = true;
    } else if (shown.drawn.value == 0) {
        shown.drawn = app_.renderer.upload(view, look);
    } else {
        app_.renderer.update(shown.drawn, view, look);
    }
    shown.drawn_of = shown.wanted;
    shown.stands = stands_of(shown.wanted);
    shown.is_shown = true;
}

size_t StrokeLayers::point_count() const {
    size_t count = 0;
    for (const auto& [id, layer] : layers_)
        visit(id, [&](const FlgCurveSetView& view, std::span<const Stroke>) {
            if (view.curve_count > 0) count += view.curve_offsets[view.curve_count];
        });
    return count;
}

void StrokeLayers::visit(uint32_t layer, const Visitor& visitor) const {
    const auto found = layers_.find(layer);
    if (found == layers_.end()) return;
    for (const Shown& shown : found->second.groups)
        if (shown.result) visitor(shown.result.view(), shown.made_of);
}

void StrokeLayers::device_lost() {
    for (auto& [id, layer] : layers_) {
        for (std::list<Shown>* list : {&layer.groups, &layer.old}) {
            for (Shown& shown : *list) {
                shown.drawn = {};
                shown.drawn_visible = true;
                shown.is_shown = false;
            }
        }
    }
}

}  // namespace flg::studio
