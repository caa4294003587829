// SPDX-License-Identifier: MIT
// What was drawn, and how it shall look: layers of strokes, and styles that were drawn. Strokes never change once drawn, so that
// a copy of a document is cheap: undo keeps copies.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace flg::studio {

struct StrokeSample {
    glm::vec3 position, normal;  // metres; unit length
    float pressure = 1.0f;       // 0 to 1
    float time = 0.0f;           // seconds since the stroke began
};

struct DrawnStroke {
    std::vector<StrokeSample> samples;
    std::optional<glm::vec3> color;  // linear RGB; none: the layer's
};
using StrokePtr = std::shared_ptr<const DrawnStroke>;

enum class StrokeShape { ribbon, tube, raw };

struct StrokeSettings {
    std::string style = "loops";  // built in, or drawn
    StrokeShape shape = StrokeShape::tube;
    bool standing = false;   // the style swings away from what it lies on, not along it
    float scale_cm = 1.6f;   // how far the style swings off the stroke, root mean square
    float magnitude = 1.0f;  // 0: the stroke alone
    float temperature = 0.0f;
    int patch = 10;
    float radius_mm = 2.2f;
    int seed = 1;
    glm::vec3 color{0.90f, 0.13f, 0.03f}, color_end{0.50f, 0.02f, 0.22f};  // linear RGB
    bool operator==(const StrokeSettings&) const = default;
};

struct StrokeLayer {
    uint32_t id = 0;  // never given again
    std::string name;
    bool visible = true;
    StrokeSettings settings;
    std::vector<StrokePtr> strokes;
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
    StrokeLayer& add_layer(std::string name, const StrokeSettings& settings);
    const DrawnStyle* find_style(const std::string& name) const;
    size_t stroke_count() const;
};

nlohmann::json to_json(const StrokeDocument& document);
// Throws nlohmann::json::exception or StudioError.
StrokeDocument strokes_from_json(const nlohmann::json& part);

}  // namespace flg::studio
