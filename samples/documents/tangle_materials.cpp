// SPDX-License-Identifier: MIT
#include "documents/tangle_materials.h"

#include <algorithm>
#include <optional>

#include "documents/json_color.h"

namespace flg::cli {
namespace {

constexpr float kUsualColor[] = {0.42f, 0.36f, 0.31f}, kUsualRoughness = 0.5f;
constexpr double kWidestBorder = 64;

FlgMeshMaterial read_look(const JsonPlace& entry, const FlgMeshMaterial& otherwise) {
    FlgMeshMaterial look = otherwise;
    read_color(entry.at("color"), look.color);
    if (const auto metallic = entry.find("metallic")) look.metallic = metallic->number(0, 1);
    if (const auto roughness = entry.find("roughness")) look.roughness = roughness->number(0, 1);
    if (const auto border = entry.find("border")) {
        border->allow({"color", "width"});
        look.border_width_px = border->at("width").number(0, kWidestBorder);
        if (const auto color = border->find("color")) read_color(*color, look.border_color);
    }
    return look;
}

}  // namespace

std::vector<ScriptMaterial> read_materials(const JsonPlace& list, bool has_own, const Selection& select) {
    FlgMeshMaterial usual = flgMeshMaterialDefaults();
    std::copy_n(kUsualColor, 3, usual.color);
    usual.roughness = kUsualRoughness;
    std::vector<ScriptMaterial> materials = {
        {.is_default = true, .is_kept = has_own, .regions = {}, .name = "default", .look = usual}};
    for (const JsonPlace& entry : list.items()) {
        entry.allow({"on", "name", "keep", "color", "metallic", "roughness", "border"});
        const JsonPlace on = entry.at("on");
        const bool is_default = on.is_string() && on.text() == "default";
        if (is_default && materials.size() > 1) on.fail("`default` must come first");
        if (is_default) materials.clear();
        ScriptMaterial& material = materials.emplace_back();
        material.is_default = is_default;
        if (!is_default) material.regions = select(on);
        material.name = on.is_string() ? on.text() : "material " + std::to_string(materials.size());
        if (const auto name = entry.find("name")) material.name = name->text();
        if (const auto keep = entry.find("keep"); keep && keep->flag()) {
            if (!has_own)
                keep->fail("the mesh is no .gltf or .glb file that is written as .glb: it has no materials to keep");
            entry.allow({"on", "name", "keep"});
            material.is_kept = true;
            material.look = usual;
            continue;
        }
        // Border lines are those of the default where an entry has none.
        FlgMeshMaterial otherwise = usual;
        otherwise.border_width_px = materials.front().look.border_width_px;
        std::copy_n(materials.front().look.border_color, 3, otherwise.border_color);
        material.look = read_look(entry, otherwise);
    }
    return materials;
}

TangleMaterials spread_materials(std::vector<ScriptMaterial> entries, const std::vector<FlgTangleRegion>& regions) {
    TangleMaterials materials;
    std::vector<std::optional<uint32_t>> painted(regions.size());
    std::vector<bool> kept;
    for (uint32_t i = 0; i < entries.size(); ++i) {
        for (uint32_t region : entries[i].regions) {
            while (regions[region].joined_into != FLG_NO_INDEX) region = regions[region].joined_into;
            painted[region] = i;
        }
        kept.push_back(entries[i].is_kept);
        materials.names.push_back(std::move(entries[i].name));
    }
    for (uint32_t i = 0; i < entries.size(); ++i) {
        FlgMeshMaterial& material = materials.table.emplace_back(entries[i].look);
        material.name = materials.names[i].c_str();
    }
    for (uint32_t r = 0; r < regions.size(); ++r) {
        uint32_t at = r;
        while (at != 0 && (!painted[at] || regions[at].scaffold != 0)) at = regions[at].parent;
        const uint32_t entry = painted[at].value_or(0);
        materials.of_region.push_back(kept[entry] ? FLG_NO_INDEX : entry);
    }
    return materials;
}

}  // namespace flg::cli
