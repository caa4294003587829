// SPDX-License-Identifier: MIT
#include "strokes/strokes_workspace.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <map>

#include "strokes/standing_strokes.h"
#include "strokes/stroke_arrays.h"
#include "strokes/stroke_files.h"
#include "workspaces.h"

namespace flg::studio {
namespace {

constexpr size_t kSteps = 200;       // of undo
constexpr float kReachUnits = 9.0f;  // of the eraser
constexpr float kFloorReach = 4.0f;  // how far from the scene's middle the floor is drawn on, radii of the scene

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 d = b - a;
    const float square = glm::dot(d, d);
    const float t = square > 0.0f ? glm::clamp(glm::dot(p - a, d) / square, 0.0f, 1.0f) : 0.0f;
    return glm::distance(p, a + t * d);
}

}  // namespace

std::unique_ptr<Workspace> make_strokes(AppContext& app) {
    return std::make_unique<StrokesWorkspace>(app);
}

StrokesWorkspace::StrokesWorkspace(AppContext& app)
    : Workspace(app),
      style_cache_(app),
      guide_(app, style_cache_),
      layers_(app, style_cache_),
      pen_(app, style_cache_),
      replay_(app, style_cache_) {
    document_.active_layer();
}

std::string StrokesWorkspace::help() const {
    switch (tool_) {
        case Tool::draw: return "Drag to draw on the mesh or beside it.";
        case Tool::draw_style: return "Drag to draw an example. It becomes a new style.";
        case Tool::select:
            return selected_.empty()
                       ? "Click a stroke to select it. Shift-click selects more."
                       : "Change the settings, then press Apply to selection. Delete erases the selection.";
        case Tool::erase: return "Click a stroke to erase it.";
    }
    return {};
}

void StrokesWorkspace::leave() {
    if (pen_.down()) end_stroke();
    hovered_.reset();
    hovered_stroke_.reset();
}

void StrokesWorkspace::remember() {
    if (undone_from_.size() == kSteps) undone_from_.erase(undone_from_.begin());
    undone_from_.push_back(document_);
    redone_from_.clear();
    ++app_.changes;
    app_.timeline.push(*this);
}

bool StrokesWorkspace::give_up() {
    const bool was_down = pen_.down();
    if (was_down) pen_.lift();
    return was_down;
}

void StrokesWorkspace::undo() {
    if (!can_undo()) return;
    redone_from_.push_back(std::move(document_));
    document_ = std::move(undone_from_.back());
    undone_from_.pop_back();
    forget_gone();
    pen_.lift();
    replay_.stop();
    ++app_.changes;
}

void StrokesWorkspace::redo() {
    if (!can_redo()) return;
    undone_from_.push_back(std::move(document_));
    document_ = std::move(redone_from_.back());
    redone_from_.pop_back();
    forget_gone();
    ++app_.changes;
}

void StrokesWorkspace::update() {
    style_cache_.forget(document_, next_);
    replay_.update(document_);
    layers_.update(document_, replay_.layer());
    if (lifts_pen_ && !layers_.busy()) {
        lifts_pen_ = false;
        if (!pen_.down()) pen_.lift();
    }
    // Its example may have been undone.
    if (!style_cache_.has(document_, next_.style)) next_.style = StrokeSettings().style;
    // So that the next stroke can begin at once.
    const filigree::Style* style = style_cache_.get(document_, next_);
    if (!pen_.down()) lift_m_ = lift(style);  // one for all of a stroke, also if its style gets ready meanwhile
    is_warm_ = style == nullptr ||
               (style_cache_.info(*style).displacement_rms > 0.0f && style_cache_.warm(*style, next_.temperature));
}

float StrokesWorkspace::lift(const filigree::Style* style) {
    const float asked = 0.001f * height_mm_;
    const float rms = style != nullptr ? style_cache_.info(*style).displacement_rms : 0.0f;
    if (!next_.styled || tool_ != Tool::draw || !(rms > 0.0f)) return asked;
    const glm::vec2 reach = style_cache_.reach(document_, next_.style);
    const float swing = swing_m(next_) / rms * next_.magnitude * (next_.upright ? reach.y : reach.x);
    return std::max(asked, swing + 0.001f * next_.radius_mm);
}

void StrokesWorkspace::forget_gone() {
    if (selected_.empty()) return;
    std::set<StrokePtr> there;
    for (const StrokeLayer& layer : document_.layers)
        for (const Stroke& stroke : layer.strokes)
            if (is_selected(stroke)) there.insert(stroke.drawn);
    selected_ = std::move(there);
}

std::optional<StrokeSample> StrokesWorkspace::sample_at(glm::vec2 px, const SceneMesh*& mesh) const {
    mesh = nullptr;
    const Ray ray = app_.view.ray(px);
    if (ground_ == Ground::mesh) {
        if (const auto hit = app_.scene.hit(ray)) {
            mesh = hit->mesh;
            // On the side that is looked at.
            const glm::vec3 normal = glm::dot(hit->normal(), ray.direction) > 0.0f ? -hit->normal() : hit->normal();
            return StrokeSample{hit->position() + lift_m_ * normal, normal};
        }
    }
    const render::Camera& camera = app_.view.orbit.camera;
    constexpr glm::vec3 kUp{0.0f, 1.0f, 0.0f};
    const auto floor = meet_plane(ray, app_.scene.floor() * kUp, kUp);
    const auto on_floor = [&] { return StrokeSample{*floor + lift_m_ * kUp, kUp}; };
    if (ground_ == Ground::floor) return floor ? std::optional(on_floor()) : std::nullopt;
    // An example keeps the shape that it has in the picture.
    const bool sees_floor = ground_ == Ground::mesh && tool_ != Tool::draw_style && floor && is_floor_seen(ray, *floor);
    if (sees_floor && (!pen_.down() || pen_.stroke().samples.empty() || begins_on_floor_)) return on_floor();
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const float depth =
        last_depth_ > 0.0f && ground_ == Ground::mesh ? last_depth_ : glm::length(camera.target - camera.eye);
    const auto met = meet_plane(ray, camera.eye + depth * forward, -forward);
    if (!met) return std::nullopt;
    // Beside a mesh a stroke goes on in the air, down to the floor.
    if (sees_floor && met->y < floor->y + lift_m_) return on_floor();
    return StrokeSample{*met, -forward};
}

bool StrokesWorkspace::is_floor_seen(const Ray& ray, const glm::vec3& place) const {
    const render::Box box = app_.scene.box();
    const render::Camera& camera = app_.view.orbit.camera;
    const glm::vec3 middle = box.empty() ? camera.target : box.center();
    const float radius = box.empty() ? glm::distance(camera.eye, camera.target) : 0.5f * box.diagonal();
    return app_.renderer.scene().ground && ray.direction.y < 0.0f &&
           glm::distance(place, middle) < kFloorReach * radius;
}

void StrokesWorkspace::pointer(const Pointer& mouse) {
    hovered_.reset();
    hovered_stroke_.reset();
    if (tool_ == Tool::erase) {
        erase(mouse);
        return;
    }
    if (tool_ == Tool::select) {
        select(mouse);
        return;
    }
    const SceneMesh* under = nullptr;
    if (mouse.inside) hovered_ = sample_at(mouse.px, under);
    if (mouse.pressed) begin_stroke(mouse);
    if (!pen_.down()) return;
    for (const MouseSample& place : mouse.path) {
        std::optional<StrokeSample> sample = sample_at(place.px, under);
        if (!sample) continue;
        if (pen_.stroke().samples.empty()) begin_at(*sample, under);
        // The first mesh that it comes over is the one it stays with.
        if (under != nullptr && pen_.stroke().on == 0) pen_.stand_on(under->id, under->placement);
        sample->pressure = place.pressure;
        sample->time = static_cast<float>(std::max(place.seconds - stroke_start_s_, 0.0));
        if (!pen_.stroke().samples.empty()) sample->time = std::max(sample->time, pen_.stroke().samples.back().time);
        const glm::vec3 arm = sample->position - app_.view.orbit.camera.eye;
        last_depth_ = glm::dot(arm, glm::normalize(app_.view.orbit.camera.target - app_.view.orbit.camera.eye));
        pen_.add(*sample);
    }
    if (mouse.released) end_stroke();
}

void StrokesWorkspace::begin_stroke(const Pointer& mouse) {
    replay_.stop();
    lifts_pen_ = false;
    last_depth_ = 0.0f;
    StrokeSettings settings = next_;
    if (tool_ == Tool::draw_style) settings.styled = false;
    pen_.begin(document_, document_.active_layer().made(nullptr, settings));
    stroke_start_s_ = mouse.path.empty() ? app_.seconds : mouse.path.front().seconds;
    if (!mouse.path.empty()) return;
    const SceneMesh* under = nullptr;
    const auto sample = sample_at(mouse.px, under);
    if (!sample) return;
    begin_at(*sample, under);
    if (under != nullptr) pen_.stand_on(under->id, under->placement);
    pen_.add(*sample);
}

void StrokesWorkspace::begin_at(const StrokeSample& sample, const SceneMesh* under) {
    begins_on_floor_ = under == nullptr && sample.normal == glm::vec3(0.0f, 1.0f, 0.0f);
}

void StrokesWorkspace::end_stroke() {
    StrokePtr stroke = pen_.end();
    if (stroke == nullptr) return;
    remember();
    StrokeLayer& layer = document_.active_layer();
    if (tool_ == Tool::draw) {
        layer.strokes.push_back(layer.made(std::move(stroke), next_));
        lifts_pen_ = true;
        return;
    }
    pen_.lift();
    next_.style = "mine " + std::to_string(document_.styles.size() + 1);
    auto example = std::make_shared<DrawnStroke>(*stroke);
    example->on = 0;
    document_.styles.push_back({next_.style, std::move(example)});
    set_tool(Tool::draw);
}

bool StrokesWorkspace::is_selected(const Stroke& stroke) const {
    return selected_.contains(stroke.drawn);
}

void StrokesWorkspace::select(const Pointer& mouse) {
    if (!mouse.inside) return;
    hovered_stroke_ = stroke_at(mouse.px);
    if (!mouse.pressed) return;
    if (!mouse.shift && !mouse.control) selected_.clear();
    if (!hovered_stroke_) return;
    const StrokeLayer& layer = *document_.find(hovered_stroke_->layer);
    const Stroke& stroke = layer.strokes[hovered_stroke_->stroke];
    if (!selected_.insert(stroke.drawn).second) selected_.erase(stroke.drawn);
}

void StrokesWorkspace::select_layer() {
    selected_.clear();
    for (const Stroke& stroke : document_.active_layer().strokes) selected_.insert(stroke.drawn);
    set_tool(Tool::select);
}

void StrokesWorkspace::erase_selection() {
    if (selected_.empty()) return;
    remember();
    for (StrokeLayer& layer : document_.layers)
        std::erase_if(layer.strokes, [&](const Stroke& stroke) { return is_selected(stroke); });
    selected_.clear();
}

void StrokesWorkspace::apply(StrokeLayer& layer, const std::function<bool(const Stroke&)>& to) {
    std::map<SettingsPtr, SettingsPtr> becomes;
    std::map<std::pair<SettingsPtr, float>, uint32_t> number;  // of the next of this size
    for (Stroke& stroke : layer.strokes) {
        if (!to(stroke)) continue;
        SettingsPtr& settings = becomes[stroke.settings];
        if (settings == nullptr) {
            StrokeSettings wanted = next_;
            if (keeps_colors_) {
                wanted.color = stroke.settings->color;
                wanted.color_end = stroke.settings->color_end;
            }
            settings = layer.made(nullptr, wanted).settings;
        }
        const std::pair key{settings, stroke.drawn->size};
        if (!number.contains(key)) number[key] = layer.made(stroke.drawn, *settings).number;
        // Those that have them already stay as they are.
        if (stroke.settings != settings) stroke.number = number.at(key)++;
        stroke.settings = settings;
        stroke.own_color = stroke.own_color && keeps_colors_;
    }
}

void StrokesWorkspace::apply_to_selection() {
    remember();
    for (StrokeLayer& layer : document_.layers)
        apply(layer, [this](const Stroke& stroke) { return is_selected(stroke); });
}

void StrokesWorkspace::apply_to_layer() {
    remember();
    apply(document_.active_layer(), [](const Stroke&) { return true; });
}

void StrokesWorkspace::take_from_selection() {
    for (const StrokeLayer& layer : document_.layers)
        for (const Stroke& stroke : layer.strokes)
            if (is_selected(stroke)) {
                next_ = *stroke.settings;
                return;
            }
}

std::optional<StrokesWorkspace::Found> StrokesWorkspace::stroke_at(glm::vec2 px) const {
    std::optional<Found> best;
    float nearest = kReachUnits * app_.scale;
    for (const StrokeLayer& layer : document_.layers) {
        if (!layer.visible) continue;
        for (size_t s = 0; s < layer.strokes.size(); ++s) {
            const DrawnStroke& drawn = *layer.strokes[s].drawn;
            if (!is_seen(app_.scene, drawn)) continue;
            const render::Placement move = moved(app_.scene, drawn);
            std::optional<glm::vec2> before;
            for (const StrokeSample& sample : drawn.samples) {
                const auto at = app_.view.project(move.point(sample.position));
                if (at && before) {
                    const float distance = distance_to_segment(px, *before, *at);
                    if (distance < nearest) {
                        nearest = distance;
                        best = {layer.id, s};
                    }
                }
                before = at;
            }
        }
    }
    return best;
}

void StrokesWorkspace::erase(const Pointer& mouse) {
    if (!mouse.inside) return;
    hovered_stroke_ = stroke_at(mouse.px);
    if (!mouse.pressed || !hovered_stroke_) return;
    remember();
    StrokeLayer& layer = *document_.find(hovered_stroke_->layer);
    layer.strokes.erase(layer.strokes.begin() + static_cast<std::ptrdiff_t>(hovered_stroke_->stroke));
    forget_gone();
    hovered_stroke_.reset();
}

void StrokesWorkspace::overlay(ImDrawList& list) {
    const float unit = app_.scale;
    if (hovered_) {
        // A ring as wide as the stroke will be, lying as it will lie.
        const glm::vec3 n = hovered_->normal;
        const glm::vec3 a =
            glm::normalize(glm::cross(n, std::abs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
        const glm::vec3 b = glm::cross(n, a);
        const float radius =
            std::max(0.001f * next_.radius_mm, 4.0f * unit * app_.view.metres_per_px(hovered_->position));
        ImVec2 ring[24];
        int count = 0;
        for (int i = 0; i < 24; ++i) {
            const float angle = 6.2831853f * static_cast<float>(i) / 24.0f;
            const auto at =
                app_.view.project(hovered_->position + radius * (std::cos(angle) * a + std::sin(angle) * b));
            if (at) ring[count++] = {at->x, at->y};
        }
        list.AddPolyline(ring, count, IM_COL32(255, 255, 255, 230), ImDrawFlags_Closed, 1.5f * unit);
        list.AddPolyline(ring, count, IM_COL32(60, 40, 20, 160), ImDrawFlags_Closed, 0.7f * unit);
    }
    // As many lines as can be drawn in a millisecond or two.
    constexpr size_t kMaxPoints = 20'000;
    size_t points = 0;
    for (const StrokePtr& stroke : selected_) points += stroke->samples.size();
    const size_t step = 1 + points / kMaxPoints;
    const auto trace = [&](const StrokePtr& stroke, ImU32 color, float width) {
        if (!is_seen(app_.scene, *stroke)) return;
        const render::Placement move = moved(app_.scene, *stroke);
        std::vector<ImVec2> line;
        for (size_t i = 0; i < stroke->samples.size(); i += step)
            if (const auto at = app_.view.project(move.point(stroke->samples[i].position)))
                line.push_back({at->x, at->y});
        list.AddPolyline(line.data(), static_cast<int>(line.size()), color, 0, width * unit);
    };
    for (const StrokePtr& stroke : selected_) trace(stroke, IM_COL32(255, 200, 90, 230), step > 1 ? 1.0f : 2.5f);
    if (!hovered_stroke_) return;
    const Stroke& stroke = document_.find(hovered_stroke_->layer)->strokes[hovered_stroke_->stroke];
    trace(stroke.drawn, tool_ == Tool::erase ? IM_COL32(255, 90, 70, 220) : IM_COL32(255, 255, 255, 200), 3.0f);
}

void StrokesWorkspace::set_tool(Tool tool) {
    if (pen_.down()) end_stroke();
    tool_ = tool;
}

bool StrokesWorkspace::shortcut(const Chord& chord) {
    if (chord.control && chord.key == GLFW_KEY_A) {
        select_layer();
        return true;
    }
    if (chord.control) return false;
    switch (chord.key) {
        case GLFW_KEY_B: set_tool(Tool::draw); return true;
        case GLFW_KEY_S: set_tool(Tool::draw_style); return true;
        case GLFW_KEY_E: set_tool(Tool::erase); return true;
        case GLFW_KEY_G: ground_ = static_cast<Ground>((static_cast<int>(ground_) + 1) % 3); return true;
        case GLFW_KEY_V: set_tool(Tool::select); return true;
        case GLFW_KEY_LEFT_BRACKET: next_.radius_mm = std::max(0.8f * next_.radius_mm, kThinnest_mm); return true;
        case GLFW_KEY_RIGHT_BRACKET: next_.radius_mm = std::min(1.25f * next_.radius_mm, kThickest_mm); return true;
        case GLFW_KEY_DELETE:
        case GLFW_KEY_BACKSPACE: erase_selection(); return true;
        case GLFW_KEY_ESCAPE:
            replay_.stop();
            pen_.lift();
            selected_.clear();
            return true;
        default: return false;
    }
}

std::span<const Workspace::Shortcut> StrokesWorkspace::shortcuts() const {
    static constexpr Shortcut kKeys[] = {{"B", "Draw"},
                                         {"S", "New style"},
                                         {"V", "Select strokes"},
                                         {"E", "Erase strokes"},
                                         {"Ctrl+A", "Select all strokes of the layer"},
                                         {"Delete", "Erase the selected strokes"},
                                         {"G", "Draw on the mesh, the view plane, the floor"},
                                         {"[ and ]", "Thinner, thicker"},
                                         {"Escape", "Drop the stroke, stop the replay, clear the selection"}};
    return kKeys;
}

bool StrokesWorkspace::open(const std::string& path) {
    if (!is_stroke_file(path)) return false;
    StrokeDocument opened = document_;
    const bool colored = import_strokes(
        opened, next_, [this](const render::Box& box) { return app_.scene.find_place(box); }, path);
    remember();
    document_ = std::move(opened);
    keeps_colors_ = keeps_colors_ || colored;
    return true;
}

void StrokesWorkspace::load(const nlohmann::json& part) {
    StrokeDocument loaded = strokes_from_json(part, app_.scene.ids());
    pen_.lift();
    replay_.stop();
    // Layers of the old document that have the same numbers are others.
    loaded.last_id += document_.last_id;
    for (StrokeLayer& layer : loaded.layers) layer.id += document_.last_id;
    if (loaded.active != 0) loaded.active += document_.last_id;
    document_ = std::move(loaded);
    document_.active_layer();
    undone_from_.clear();
    redone_from_.clear();
    selected_.clear();
    // Goes on as it was left.
    next_ = {};
    if (const auto& strokes = document_.active_layer().strokes; !strokes.empty()) next_ = *strokes.back().settings;
}

std::span<const Workspace::Export> StrokesWorkspace::exports() const {
    static constexpr Export kFormats[] = {{"Strokes", ".glb"}, {"Strokes", ".xyz"}, {"Strokes", ".obj"}};
    return kFormats;
}

void StrokesWorkspace::write(const Export&, const std::string& path) {
    export_strokes(document_, layers_, app_.scene, path);
}

void StrokesWorkspace::device_lost() {
    pen_.device_lost();
    replay_.device_lost();
    layers_.device_lost();
}

render::Box StrokesWorkspace::box() const {
    render::Box box;
    for (const StrokeLayer& layer : document_.layers) {
        if (!layer.visible) continue;
        for (const Stroke& stroke : layer.strokes) {
            if (!is_seen(app_.scene, *stroke.drawn)) continue;
            const render::Placement move = moved(app_.scene, *stroke.drawn);
            for (const StrokeSample& sample : stroke.drawn->samples)
                box.add({move.point(sample.position), move.point(sample.position)});
        }
    }
    return box;
}

double StrokesWorkspace::count(const std::string& name) const {
    if (name == "count" || name == "seen") {
        size_t found = 0;
        for (const StrokeLayer& layer : document_.layers) {
            for (const Stroke& stroke : layer.strokes) {
                const bool shows = layer.visible && is_seen(app_.scene, *stroke.drawn);
                found += (name == "count" ? is_there(app_.scene, *stroke.drawn) : shows) ? 1 : 0;
            }
        }
        return static_cast<double>(found);
    }
    if (name == "layers") return static_cast<double>(document_.layers.size());
    if (name == "styles") return static_cast<double>(document_.styles.size());
    if (name == "lift_mm") return 1e3 * static_cast<double>(lift_m_);
    if (name == "radius_mm") return static_cast<double>(next_.radius_mm);
    if (name == "seed") return next_.seed;
    if (name == "smoothing") return static_cast<double>(next_.smoothing);
    if (name == "beta") return static_cast<double>(next_.beta);
    if (name == "guides") return guide_.made();
    if (name == "displacement") return static_cast<double>(guide_.displacement());
    if (name == "selected") return static_cast<double>(selected_.size());
    if (name == "looks") {
        std::set<SettingsPtr> looks;
        for (const StrokeLayer& layer : document_.layers)
            for (const Stroke& stroke : layer.strokes) looks.insert(stroke.settings);
        return static_cast<double>(looks.size());
    }
    if (name == "points") return static_cast<double>(layers_.point_count());
    throw StudioError(
        "strokes has the values count, layers, styles, selected, looks, lift_mm, radius_mm, seed, smoothing, beta, "
        "guides, displacement and points, not " +
        name + ".");
}

}  // namespace flg::studio
