// SPDX-License-Identifier: MIT
#include "strokes/strokes_workspace.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>

#include "strokes/stroke_files.h"
#include "workspaces.h"

namespace flg::studio {
namespace {

constexpr size_t kSteps = 200;       // of undo
constexpr float kReachUnits = 9.0f;  // of the eraser

float distance_to_segment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    const glm::vec2 d = b - a;
    const float square = glm::dot(d, d);
    const float t = square > 0.0f ? glm::clamp(glm::dot(p - a, d) / square, 0.0f, 1.0f) : 0.0f;
    return glm::distance(p, a + t * d);
}

}  // namespace

std::unique_ptr<Workspace> make_strokes(Desk& desk) {
    return std::make_unique<StrokesWorkspace>(desk);
}

StrokesWorkspace::StrokesWorkspace(Desk& desk)
    : Workspace(desk), shelf_(desk), layers_(desk, shelf_), pen_(desk, shelf_), replay_(desk, shelf_) {
    document_.active_layer();
}

std::string StrokesWorkspace::help() const {
    switch (tool_) {
        case Tool::draw: return "Drag to draw, on a mesh or beside it.";
        case Tool::draw_style: return "Drag to draw an example: it becomes a style.";
        case Tool::erase: return "Click a stroke to take it away.";
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
    ++desk_.changes;
}

void StrokesWorkspace::undo() {
    if (!can_undo()) return;
    redone_from_.push_back(std::move(document_));
    document_ = std::move(undone_from_.back());
    undone_from_.pop_back();
    pen_.lift();
    replay_.stop();
    ++desk_.changes;
}

void StrokesWorkspace::redo() {
    if (!can_redo()) return;
    undone_from_.push_back(std::move(document_));
    document_ = std::move(redone_from_.back());
    redone_from_.pop_back();
    ++desk_.changes;
}

void StrokesWorkspace::update() {
    shelf_.forget_drawn(document_);
    replay_.update(document_);
    layers_.update(document_, replay_.layer());
    if (lifts_pen_ && !layers_.busy()) {
        lifts_pen_ = false;
        if (!pen_.down()) pen_.lift();
    }
    // So that the next stroke can begin at once.
    const StrokeSettings& settings = document_.active_layer().settings;
    const filigree::Style* style = shelf_.get(document_, settings.style, settings.patch);
    is_warm_ =
        style == nullptr || (shelf_.info(*style).displacement_rms > 0.0f && shelf_.warm(*style, settings.temperature));
}

std::optional<StrokeSample> StrokesWorkspace::sample_at(glm::vec2 px) const {
    const Ray ray = desk_.view.ray(px);
    const float lift = 0.001f * height_mm_;
    if (ground_ == Ground::mesh) {
        if (const auto hit = desk_.scene.hit(ray)) {
            // On the side that is looked at.
            const glm::vec3 normal = glm::dot(hit->normal(), ray.direction) > 0.0f ? -hit->normal() : hit->normal();
            return StrokeSample{hit->position() + lift * normal, normal};
        }
    }
    const render::Camera& camera = desk_.view.orbit.camera;
    if (ground_ == Ground::floor) {
        const render::Box box = desk_.scene.box();
        const float level = box.empty() ? 0.0f : box.min.y;
        if (const auto met = meet_plane(ray, {0.0f, level, 0.0f}, {0.0f, 1.0f, 0.0f}))
            return StrokeSample{*met + glm::vec3(0.0f, lift, 0.0f), {0.0f, 1.0f, 0.0f}};
        return std::nullopt;
    }
    const glm::vec3 forward = glm::normalize(camera.target - camera.eye);
    const float depth =
        last_depth_ > 0.0f && ground_ == Ground::mesh ? last_depth_ : glm::length(camera.target - camera.eye);
    if (const auto met = meet_plane(ray, camera.eye + depth * forward, -forward)) return StrokeSample{*met, -forward};
    return std::nullopt;
}

void StrokesWorkspace::pointer(const Pointer& mouse) {
    hovered_.reset();
    hovered_stroke_.reset();
    if (tool_ == Tool::erase) {
        erase(mouse);
        return;
    }
    if (mouse.inside) hovered_ = sample_at(mouse.px);
    if (mouse.pressed) begin_stroke(mouse);
    if (!pen_.down()) return;
    for (const MouseSample& place : mouse.path) {
        std::optional<StrokeSample> sample = sample_at(place.px);
        if (!sample) continue;
        sample->time = static_cast<float>(std::max(place.seconds - stroke_start_s_, 0.0));
        if (!pen_.stroke().samples.empty()) sample->time = std::max(sample->time, pen_.stroke().samples.back().time);
        const glm::vec3 arm = sample->position - desk_.view.orbit.camera.eye;
        last_depth_ = glm::dot(arm, glm::normalize(desk_.view.orbit.camera.target - desk_.view.orbit.camera.eye));
        pen_.add(*sample);
    }
    if (mouse.released) end_stroke();
}

void StrokesWorkspace::begin_stroke(const Pointer& mouse) {
    replay_.stop();
    lifts_pen_ = false;
    last_depth_ = 0.0f;
    const StrokeLayer& layer = document_.active_layer();
    StrokeSettings settings = layer.settings;
    if (tool_ == Tool::draw_style) settings.shape = StrokeShape::raw;
    pen_.begin(document_, settings, static_cast<uint32_t>(layer.strokes.size()), std::nullopt);
    stroke_start_s_ = mouse.path.empty() ? desk_.seconds : mouse.path.front().seconds;
    if (!mouse.path.empty()) return;
    if (const auto sample = sample_at(mouse.px)) pen_.add(*sample);
}

void StrokesWorkspace::end_stroke() {
    StrokePtr stroke = pen_.end();
    if (stroke == nullptr) return;
    remember();
    StrokeLayer& layer = document_.active_layer();
    if (tool_ == Tool::draw) {
        layer.strokes.push_back(std::move(stroke));
        lifts_pen_ = true;
        return;
    }
    pen_.lift();
    const std::string name = "mine " + std::to_string(document_.styles.size() + 1);
    document_.styles.push_back({name, std::move(stroke)});
    layer.settings.style = name;
    set_tool(Tool::draw);
}

std::optional<StrokesWorkspace::Found> StrokesWorkspace::stroke_at(glm::vec2 px) const {
    std::optional<Found> best;
    float nearest = kReachUnits * desk_.scale;
    for (const StrokeLayer& layer : document_.layers) {
        if (!layer.visible) continue;
        for (size_t s = 0; s < layer.strokes.size(); ++s) {
            std::optional<glm::vec2> before;
            for (const StrokeSample& sample : layer.strokes[s]->samples) {
                const auto at = desk_.view.project(sample.position);
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
    hovered_stroke_.reset();
}

void StrokesWorkspace::overlay(ImDrawList& list) {
    const float unit = desk_.scale;
    if (hovered_) {
        // A ring as wide as the stroke will be, lying as it will lie.
        const StrokeSettings& settings = document_.active_layer().settings;
        const glm::vec3 n = hovered_->normal;
        const glm::vec3 a =
            glm::normalize(glm::cross(n, std::abs(n.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
        const glm::vec3 b = glm::cross(n, a);
        const float radius =
            std::max(0.001f * settings.radius_mm, 4.0f * unit * desk_.view.metres_per_px(hovered_->position));
        ImVec2 ring[24];
        int count = 0;
        for (int i = 0; i < 24; ++i) {
            const float angle = 6.2831853f * static_cast<float>(i) / 24.0f;
            const auto at =
                desk_.view.project(hovered_->position + radius * (std::cos(angle) * a + std::sin(angle) * b));
            if (at) ring[count++] = {at->x, at->y};
        }
        list.AddPolyline(ring, count, IM_COL32(255, 255, 255, 230), ImDrawFlags_Closed, 1.5f * unit);
        list.AddPolyline(ring, count, IM_COL32(60, 40, 20, 160), ImDrawFlags_Closed, 0.7f * unit);
    }
    if (hovered_stroke_) {
        const StrokePtr& stroke = document_.find(hovered_stroke_->layer)->strokes[hovered_stroke_->stroke];
        std::vector<ImVec2> line;
        for (const StrokeSample& sample : stroke->samples)
            if (const auto at = desk_.view.project(sample.position)) line.push_back({at->x, at->y});
        list.AddPolyline(line.data(), static_cast<int>(line.size()), IM_COL32(255, 90, 70, 220), 0, 3.0f * unit);
    }
}

void StrokesWorkspace::set_tool(Tool tool) {
    if (pen_.down()) end_stroke();
    tool_ = tool;
}

bool StrokesWorkspace::shortcut(const Chord& chord) {
    if (chord.control) return false;
    StrokeSettings changed = document_.active_layer().settings;
    switch (chord.key) {
        case GLFW_KEY_B: set_tool(Tool::draw); return true;
        case GLFW_KEY_S: set_tool(Tool::draw_style); return true;
        case GLFW_KEY_E: set_tool(Tool::erase); return true;
        case GLFW_KEY_G: ground_ = static_cast<Ground>((static_cast<int>(ground_) + 1) % 3); return true;
        case GLFW_KEY_LEFT_BRACKET: changed.radius_mm = std::max(0.8f * changed.radius_mm, 0.2f); break;
        case GLFW_KEY_RIGHT_BRACKET: changed.radius_mm = std::min(1.25f * changed.radius_mm, 30.0f); break;
        case GLFW_KEY_ESCAPE:
            replay_.stop();
            pen_.lift();
            return true;
        default: return false;
    }
    remember();
    document_.active_layer().settings = changed;
    return true;
}

std::span<const Workspace::Shortcut> StrokesWorkspace::shortcuts() const {
    static constexpr Shortcut kKeys[] = {{"B", "Draw"},
                                         {"S", "Draw a style"},
                                         {"E", "Erase strokes"},
                                         {"G", "Mesh, facing plane or floor to draw on"},
                                         {"[ and ]", "Thinner, thicker"},
                                         {"Escape", "Let go of the stroke, stop the replay"}};
    return kKeys;
}

bool StrokesWorkspace::open(const std::string& path) {
    if (!is_stroke_file(path)) return false;
    StrokeDocument opened = document_;
    import_strokes(opened, path);
    remember();
    document_ = std::move(opened);
    return true;
}

void StrokesWorkspace::load(const nlohmann::json& part) {
    StrokeDocument loaded = strokes_from_json(part);
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
}

std::span<const Workspace::Export> StrokesWorkspace::exports() const {
    static constexpr Export kFormats[] = {{"Strokes", ".glb"}, {"Strokes", ".xyz"}, {"Strokes", ".obj"}};
    return kFormats;
}

void StrokesWorkspace::write(const Export&, const std::string& path) {
    export_strokes(document_, layers_, path);
}

void StrokesWorkspace::device_lost() {
    pen_.device_lost();
    replay_.device_lost();
    layers_.device_lost();
}

double StrokesWorkspace::count(const std::string& name) const {
    if (name == "count") return static_cast<double>(document_.stroke_count());
    if (name == "layers") return static_cast<double>(document_.layers.size());
    if (name == "styles") return static_cast<double>(document_.styles.size());
    if (name == "points") return static_cast<double>(layers_.point_count());
    throw StudioError("strokes count count, layers, styles and points, not " + name + ".");
}

}  // namespace flg::studio
