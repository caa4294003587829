// SPDX-License-Identifier: MIT
#include "strokes/stroke_document.h"

#include <algorithm>
#include <cmath>

#include "shell/studio_error.h"

namespace flg::studio {
namespace {

constexpr size_t kSampleNumbers = 8;
constexpr const char* kShapes[] = {"ribbon", "tube", "raw"};

nlohmann::json to_json(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
glm::vec3 to_vec3(const nlohmann::json& v) {
    return {v.at(0).get<float>(), v.at(1).get<float>(), v.at(2).get<float>()};
}

nlohmann::json to_json(const DrawnStroke& stroke) {
    std::vector<float> numbers;
    numbers.reserve(stroke.samples.size() * kSampleNumbers);
    for (const StrokeSample& s : stroke.samples)
        numbers.insert(numbers.end(), {s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z,
                                       s.pressure, s.time});
    nlohmann::json json = {{"samples", std::move(numbers)}};
    if (stroke.color) json["color"] = to_json(*stroke.color);
    return json;
}

StrokePtr to_stroke(const nlohmann::json& json) {
    const auto numbers = json.at("samples").get<std::vector<float>>();
    const bool finite = std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); });
    if (numbers.empty() || numbers.size() % kSampleNumbers != 0 || !finite)
        throw StudioError("A stroke of the document is damaged: " + std::to_string(numbers.size()) + " numbers.");
    auto stroke = std::make_shared<DrawnStroke>();
    for (size_t i = 0; i < numbers.size(); i += kSampleNumbers) {
        const float* n = numbers.data() + i;
        stroke->samples.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, std::clamp(n[6], 0.0f, 1.0f), n[7]});
    }
    if (json.contains("color")) stroke->color = to_vec3(json.at("color"));
    return stroke;
}

nlohmann::json to_json(const StrokeSettings& s) {
    return {{"style", s.style},
            {"shape", kShapes[static_cast<int>(s.shape)]},
            {"standing", s.standing},
            {"scale_cm", s.scale_cm},
            {"magnitude", s.magnitude},
            {"temperature", s.temperature},
            {"patch", s.patch},
            {"radius_mm", s.radius_mm},
            {"seed", s.seed},
            {"color", to_json(s.color)},
            {"color_end", to_json(s.color_end)}};
}

StrokeSettings to_settings(const nlohmann::json& json) {
    StrokeSettings s;
    s.style = json.at("style").get<std::string>();
    for (int i = 0; i < 3; ++i)
        if (json.at("shape") == kShapes[i]) s.shape = static_cast<StrokeShape>(i);
    s.standing = json.value("standing", false);
    s.scale_cm = std::clamp(json.at("scale_cm").get<float>(), 0.01f, 100.0f);
    s.magnitude = std::clamp(json.at("magnitude").get<float>(), 0.0f, 10.0f);
    s.temperature = std::clamp(json.at("temperature").get<float>(), 0.0f, 100.0f);
    s.patch = std::clamp(json.at("patch").get<int>(), 1, 64);
    s.radius_mm = std::clamp(json.at("radius_mm").get<float>(), 0.01f, 1000.0f);
    s.seed = json.at("seed").get<int>();
    s.color = to_vec3(json.at("color"));
    s.color_end = to_vec3(json.at("color_end"));
    return s;
}

}  // namespace

StrokeLayer* StrokeDocument::find(uint32_t id) {
    for (StrokeLayer& layer : layers)
        if (layer.id == id) return &layer;
    return nullptr;
}

const StrokeLayer* StrokeDocument::find(uint32_t id) const {
    return const_cast<StrokeDocument*>(this)->find(id);
}

StrokeLayer& StrokeDocument::active_layer() {
    if (StrokeLayer* layer = find(active)) return *layer;
    if (layers.empty()) return add_layer("Layer 1", {});
    active = layers.back().id;
    return layers.back();
}

StrokeLayer& StrokeDocument::add_layer(std::string name, const StrokeSettings& settings) {
    layers.push_back({++last_id, std::move(name), true, settings, {}});
    active = last_id;
    return layers.back();
}

const DrawnStyle* StrokeDocument::find_style(const std::string& name) const {
    for (const DrawnStyle& style : styles)
        if (style.name == name) return &style;
    return nullptr;
}

size_t StrokeDocument::stroke_count() const {
    size_t count = 0;
    for (const StrokeLayer& layer : layers) count += layer.strokes.size();
    return count;
}

nlohmann::json to_json(const StrokeDocument& document) {
    nlohmann::json layers = nlohmann::json::array(), styles = nlohmann::json::array();
    for (const StrokeLayer& layer : document.layers) {
        nlohmann::json strokes = nlohmann::json::array();
        for (const StrokePtr& stroke : layer.strokes) strokes.push_back(to_json(*stroke));
        layers.push_back({{"name", layer.name},
                          {"visible", layer.visible},
                          {"active", layer.id == document.active},
                          {"settings", to_json(layer.settings)},
                          {"strokes", std::move(strokes)}});
    }
    for (const DrawnStyle& style : document.styles) {
        nlohmann::json json = to_json(*style.stroke);
        json["name"] = style.name;
        styles.push_back(std::move(json));
    }
    return {{"layers", std::move(layers)}, {"styles", std::move(styles)}};
}

StrokeDocument strokes_from_json(const nlohmann::json& part) {
    StrokeDocument document;
    for (const nlohmann::json& json : part.value("styles", nlohmann::json::array()))
        document.styles.push_back({json.at("name").get<std::string>(), to_stroke(json)});
    uint32_t active = 0;
    for (const nlohmann::json& json : part.value("layers", nlohmann::json::array())) {
        StrokeLayer& layer = document.add_layer(json.at("name").get<std::string>(), to_settings(json.at("settings")));
        layer.visible = json.value("visible", true);
        for (const nlohmann::json& stroke : json.at("strokes")) layer.strokes.push_back(to_stroke(stroke));
        if (json.value("active", false)) active = layer.id;
    }
    document.active = active;
    return document;
}

}  // namespace flg::studio
