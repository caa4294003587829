// SPDX-License-Identifier: MIT
#include "strokes/stroke_document.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/placement_json.h"
#include "shell/studio_error.h"

namespace flg::studio {
namespace {

constexpr size_t kSampleNumbers = 8;
constexpr const char* kShapes[] = {"ribbon", "tube"};

nlohmann::json to_json(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
glm::vec3 to_vec3(const nlohmann::json& v) {
    return {v.at(0).get<float>(), v.at(1).get<float>(), v.at(2).get<float>()};
}

nlohmann::json to_json(const DrawnStroke& stroke, const std::vector<uint32_t>& mesh_ids) {
    std::vector<float> numbers;
    numbers.reserve(stroke.samples.size() * kSampleNumbers);
    for (const StrokeSample& s : stroke.samples)
        numbers.insert(numbers.end(), {s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z,
                                       s.pressure, s.time});
    nlohmann::json json = {{"samples", std::move(numbers)}};
    if (stroke.color) json["color"] = to_json(*stroke.color);
    if (stroke.size > 0.0f) json["size"] = stroke.size;
    if (stroke.on != 0) {
        json["on"] = std::find(mesh_ids.begin(), mesh_ids.end(), stroke.on) - mesh_ids.begin();
        json["stood"] = studio::to_json(stroke.stood);
    }
    return json;
}

StrokePtr to_stroke(const nlohmann::json& json, const std::vector<uint32_t>& mesh_ids) {
    const auto numbers = json.at("samples").get<std::vector<float>>();
    const bool finite = std::all_of(numbers.begin(), numbers.end(), [](float x) { return std::isfinite(x); });
    if (numbers.empty() || numbers.size() % kSampleNumbers != 0 || !finite)
        throw StudioError("A stroke in the document is damaged: it has " + std::to_string(numbers.size()) +
                          " numbers.");
    auto stroke = std::make_shared<DrawnStroke>();
    for (size_t i = 0; i < numbers.size(); i += kSampleNumbers) {
        const float* n = numbers.data() + i;
        stroke->samples.push_back({{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, std::clamp(n[6], 0.0f, 1.0f), n[7]});
    }
    if (json.contains("color")) stroke->color = to_vec3(json.at("color"));
    if (json.contains("size")) stroke->size = std::clamp(json.at("size").get<float>(), 1e-6f, 1e6f);
    if (json.contains("on")) {
        const auto number = json.at("on").get<size_t>();
        if (number >= mesh_ids.size())
            throw StudioError("A stroke of the document is on mesh " + std::to_string(number) + ", which isn't there.");
        stroke->on = mesh_ids[number];
        stroke->stood = studio::to_placement(json.at("stood"));
    }
    return stroke;
}

nlohmann::json to_json(const StrokeSettings& s) {
    return {{"style", s.style},
            {"shape", kShapes[static_cast<int>(s.shape)]},
            {"styled", s.styled},
            {"upright", s.upright},
            {"scale_cm", s.scale_cm},
            {"magnitude", s.magnitude},
            {"temperature", s.temperature},
            {"patch", s.patch},
            {"smoothing", s.smoothing},
            {"beta", s.beta},
            {"radius_mm", s.radius_mm},
            {"seed", s.seed},
            {"color", to_json(s.color)},
            {"color_end", to_json(s.color_end)}};
}

StrokeSettings to_settings(const nlohmann::json& json) {
    StrokeSettings s;
    s.style = json.at("style").get<std::string>();
    for (int i = 0; i < 2; ++i)
        if (json.at("shape") == kShapes[i]) s.shape = static_cast<StrokeShape>(i);
    // Documents of version 0.1 had a shape "raw", and called what is upright standing.
    s.styled = json.value("styled", json.at("shape") != "raw");
    s.upright = json.value("upright", json.value("standing", false));
    s.scale_cm = std::clamp(json.at("scale_cm").get<float>(), 0.0f, 100.0f);
    s.magnitude = std::clamp(json.at("magnitude").get<float>(), 0.0f, 10.0f);
    s.temperature = std::clamp(json.at("temperature").get<float>(), 0.0f, 100.0f);
    s.patch = std::clamp(json.at("patch").get<int>(), 1, 64);
    s.smoothing = std::clamp(json.value("smoothing", s.smoothing), 0.001f, 1000.0f);
    s.beta = std::clamp(json.value("beta", s.beta), 0.001f, 0.999f);
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

Stroke StrokeLayer::made(StrokePtr drawn, const StrokeSettings& settings) const {
    Stroke stroke{std::move(drawn), nullptr, 0, true};
    const float size = stroke.drawn != nullptr ? stroke.drawn->size : 0.0f;
    for (const Stroke& other : strokes) {
        if (stroke.settings == nullptr && *other.settings == settings) stroke.settings = other.settings;
        if (other.settings == stroke.settings && other.drawn->size == size)
            stroke.number = std::max(stroke.number, other.number + 1);
    }
    if (stroke.settings == nullptr) stroke.settings = std::make_shared<StrokeSettings>(settings);
    return stroke;
}

StrokeLayer& StrokeDocument::active_layer() {
    if (StrokeLayer* layer = find(active)) return *layer;
    if (layers.empty()) return add_layer("Layer 1");
    active = layers.back().id;
    return layers.back();
}

StrokeLayer& StrokeDocument::add_layer(std::string name) {
    layers.push_back({++last_id, std::move(name), true, {}});
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

nlohmann::json to_json(const StrokeDocument& document, const std::vector<uint32_t>& mesh_ids) {
    const auto is_there = [&](const DrawnStroke& stroke) {
        return stroke.on == 0 || std::find(mesh_ids.begin(), mesh_ids.end(), stroke.on) != mesh_ids.end();
    };
    nlohmann::json layers = nlohmann::json::array(), styles = nlohmann::json::array();
    for (const StrokeLayer& layer : document.layers) {
        nlohmann::json strokes = nlohmann::json::array(), settings = nlohmann::json::array();
        std::map<SettingsPtr, size_t> index;
        for (const Stroke& stroke : layer.strokes) {
            if (!is_there(*stroke.drawn)) continue;
            if (index.emplace(stroke.settings, settings.size()).second) settings.push_back(to_json(*stroke.settings));
            nlohmann::json json = to_json(*stroke.drawn, mesh_ids);
            json["settings"] = index.at(stroke.settings);
            json["number"] = stroke.number;
            if (stroke.drawn->color) json["own_color"] = stroke.own_color;
            strokes.push_back(std::move(json));
        }
        layers.push_back({{"name", layer.name},
                          {"visible", layer.visible},
                          {"active", layer.id == document.active},
                          {"settings", std::move(settings)},
                          {"strokes", std::move(strokes)}});
    }
    for (const DrawnStyle& style : document.styles) {
        nlohmann::json json = to_json(*style.stroke, mesh_ids);
        json["name"] = style.name;
        styles.push_back(std::move(json));
    }
    return {{"layers", std::move(layers)}, {"styles", std::move(styles)}};
}

StrokeDocument strokes_from_json(const nlohmann::json& part, const std::vector<uint32_t>& mesh_ids) {
    StrokeDocument document;
    for (const nlohmann::json& json : part.value("styles", nlohmann::json::array()))
        document.styles.push_back({json.at("name").get<std::string>(), to_stroke(json, mesh_ids)});
    uint32_t active = 0;
    for (const nlohmann::json& json : part.value("layers", nlohmann::json::array())) {
        StrokeLayer& layer = document.add_layer(json.at("name").get<std::string>());
        layer.visible = json.value("visible", true);
        std::vector<SettingsPtr> settings;
        // One for all of the layer's strokes, in documents of version 0.1.
        const bool shared = json.at("settings").is_object();
        for (const nlohmann::json& entry : shared ? nlohmann::json::array({json.at("settings")}) : json.at("settings"))
            settings.push_back(std::make_shared<StrokeSettings>(to_settings(entry)));
        for (const nlohmann::json& stroke : json.at("strokes"))
            layer.strokes.push_back({to_stroke(stroke, mesh_ids), settings.at(stroke.value("settings", size_t{0})),
                                     stroke.value("number", static_cast<uint32_t>(layer.strokes.size())),
                                     stroke.value("own_color", true)});
        if (json.value("active", false)) active = layer.id;
    }
    document.active = active;
    return document;
}

}  // namespace flg::studio
