// SPDX-License-Identifier: MIT
// What was drawn, and how it shall look: layers of strokes, each with settings of its own, and styles that were drawn.
// Recorded strokes and settings never change and are shared, so that a copy of a document is cheap: undo keeps copies.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "filigree_renderer/placement.h"

namespace flg::studio {

struct StrokeSample {
    glm::vec3 position, normal;  // metres; unit length
    float pressure = 1.0f;       // 0 to 1
    float time = 0.0f;           // seconds since the stroke began
};

struct DrawnStroke {
    std::vector<StrokeSample> samples;
    std::optional<glm::vec3> color;  // of its own, linear RGB
    // Of strokes from files with sizes of their own, else 0: how many times larger than the settings say they are made.
    // Their pressure is the share of their radius, and without a style they are as thick as their brush made them.
    float size = 0.0f;
    uint32_t on = 0;            // the mesh that it was drawn on; 0: none
    render::Placement stood{};  // and where that stood then
};
using StrokePtr = std::shared_ptr<const DrawnStroke>;

// A brush's thickness, in radii that leave room between a style's turns.
constexpr float kThickness = 4.5f;

enum class StrokeShape { ribbon, tube };

struct StrokeSettings {
    std::string style = "loops";  // built in, or drawn
    bool styled = true;           // else the stroke alone
    StrokeShape shape = StrokeShape::tube;
    bool upright = false;    // the style swings away from what it lies on, not along it
    float scale_cm = 1.6f;   // how far the style swings off the stroke, root mean square; 0: what fits its radius
    float magnitude = 1.0f;  // 0: the stroke alone
    float temperature = 0.0f;
    int patch = 10;
    // How the guide of the example is made and matched, as in FlgStyleDesc.
    float smoothing = 1.0f, beta = 0.2f;
    float radius_mm = 2.2f;
    int seed = 1;
    glm::vec3 color{0.90f, 0.13f, 0.03f}, color_end{0.50f, 0.02f, 0.22f};  // linear RGB
    bool operator==(const StrokeSettings&) const = default;
};
using SettingsPtr = std::shared_ptr<const StrokeSettings>;

struct Stroke {
    StrokePtr drawn;
    SettingsPtr settings;
    uint32_t number =
        0;  // chooses its random numbers: its place among those of the same settings and size when it got them
    bool own_color = true;  // where it has one
    bool operator==(const Stroke&) const = default;
};

struct StrokeLayer {
    uint32_t id = 0;  // never given again
    std::string name;
    bool visible = true;
    std::vector<Stroke> strokes;

    // A stroke with these settings as the next of them, sharing them with the others that have them.
    Stroke made(StrokePtr drawn, const StrokeSettings& settings) const;
};

struct DrawnStyle {
    std::string name;
    StrokePtr stroke;
};

struct StrokeDocument {
    std::vector<StrokeLayer> layers;
    std::vector<DrawnStyle> styles;
    uint32_t active = 0, last_id = 0;

    StrokeLayer* find(uint32_t id);
    const StrokeLayer* find(uint32_t id) const;
    // There always is one.
    StrokeLayer& active_layer();
    StrokeLayer& add_layer(std::string name);
    const DrawnStyle* find_style(const std::string& name) const;
    size_t stroke_count() const;
};

// Meshes are named by their places in the scene's list, whose ids these are. Strokes on others, which are gone, are
// left out.
nlohmann::json to_json(const StrokeDocument& document, const std::vector<uint32_t>& mesh_ids);
// Throws nlohmann::json::exception or StudioError.
StrokeDocument strokes_from_json(const nlohmann::json& part, const std::vector<uint32_t>& mesh_ids);

}  // namespace flg::studio
