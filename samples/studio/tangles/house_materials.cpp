// SPDX-License-Identifier: MIT
#include "tangles/house_materials.h"

#include <cmath>

#include "shell/studio_error.h"

namespace flg::studio {
namespace {

constexpr size_t kMaxMaterials = 256;

glm::vec3 srgb(uint32_t hex) {
    glm::vec3 color;
    for (int i = 0; i < 3; ++i) {
        const float s = static_cast<float>(hex >> (16 - 8 * i) & 0xffu) / 255.0f;
        color[i] = s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
    }
    return color;
}

nlohmann::json color_json(const glm::vec3& c) {
    return {c.x, c.y, c.z};
}

float share_of(const nlohmann::json& json, float most) {
    const float value = json.get<float>();
    if (!(value >= 0.0f && value <= most)) throw StudioError("A material in the document has a value out of range.");
    return value;
}

glm::vec3 color_of(const nlohmann::json& json) {
    return {share_of(json.at(0), 1.0f), share_of(json.at(1), 1.0f), share_of(json.at(2), 1.0f)};
}

}  // namespace

Palette house_palette() {
    Palette palette;
    const auto add = [&](const char* name, uint32_t hex, float metallic, float roughness) {
        palette.materials.push_back({.name = name, .color = srgb(hex), .metallic = metallic, .roughness = roughness});
    };
    add("Slip", 0xefe4cd, 0.0f, 0.42f);
    add("Cobalt", 0x1f3f8f, 0.0f, 0.20f);
    add("Honey", 0xe2a33c, 0.0f, 0.25f);
    add("Rust", 0xb5482a, 0.0f, 0.25f);
    add("Sage", 0x8fb39a, 0.0f, 0.28f);
    add("Teal", 0x1f7078, 0.0f, 0.20f);
    add("Plum", 0x6d2f55, 0.0f, 0.22f);
    add("Sky", 0x9cc3d6, 0.0f, 0.28f);
    add("Ink", 0x20242e, 0.0f, 0.30f);
    add("Gold", 0xf0c46a, 1.0f, 0.24f);
    add("Copper", 0xd0805a, 1.0f, 0.30f);
    add("Silver", 0xd8dade, 1.0f, 0.25f);
    return palette;
}

std::vector<uint32_t> accent_materials() {
    return {1, 2, 3, 4, 5, 7, 6};
}

render::Material to_render(const TangleMaterial& material) {
    return {material.color, material.metallic, material.roughness, material.border_px, material.border_color};
}

nlohmann::json to_json(const Palette& palette) {
    nlohmann::json list = nlohmann::json::array();
    for (const TangleMaterial& m : palette.materials) {
        list.push_back({{"name", m.name},
                        {"color", color_json(m.color)},
                        {"metallic", m.metallic},
                        {"roughness", m.roughness},
                        {"border_px", m.border_px},
                        {"border_color", color_json(m.border_color)}});
    }
    return {{"materials", std::move(list)},
            {"border_px", palette.border_px},
            {"border_color", color_json(palette.border_color)}};
}

Palette palette_from_json(const nlohmann::json& json) {
    constexpr float kWidest = 16.0f;
    Palette palette;
    for (const nlohmann::json& m : json.at("materials")) {
        palette.materials.push_back({m.at("name").get<std::string>(), color_of(m.at("color")),
                                     share_of(m.at("metallic"), 1.0f), share_of(m.at("roughness"), 1.0f),
                                     share_of(m.at("border_px"), kWidest), color_of(m.at("border_color"))});
    }
    if (palette.materials.size() < house_palette().materials.size() || palette.materials.size() > kMaxMaterials)
        throw StudioError("The document has too few or too many materials.");
    palette.border_px = share_of(json.at("border_px"), kWidest);
    palette.border_color = color_of(json.at("border_color"));
    return palette;
}

}  // namespace flg::studio
