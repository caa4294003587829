// SPDX-License-Identifier: MIT
// What regions are painted with: a dozen materials of the house, which the user may change, and the lines between
// regions.
#pragma once

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "filigree_renderer/surface_look.h"

namespace flg::studio {

// Colours are linear RGB.
struct TangleMaterial {
    std::string name;
    glm::vec3 color{1.0f};
    float metallic = 0.0f;
    float roughness = 0.4f;
    float border_px = 0.0f;  // of its lines to materials further up; 0: the palette's
    glm::vec3 border_color{0.0f};
    bool operator==(const TangleMaterial&) const = default;
};

struct Palette {
    std::vector<TangleMaterial> materials;
    float border_px = 1.0f;  // 0: no lines
    glm::vec3 border_color{0.011f, 0.016f, 0.033f};
    bool operator==(const Palette&) const = default;
};

Palette house_palette();

// What a mesh is before anything is painted, and what operators paint with by themselves, one after the other.
constexpr uint32_t kGroundMaterial = 0;
std::vector<uint32_t> accent_materials();

render::Material to_render(const TangleMaterial& material);

nlohmann::json to_json(const Palette& palette);
// Throws nlohmann's exceptions.
Palette palette_from_json(const nlohmann::json& json);

}  // namespace flg::studio
