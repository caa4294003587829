// SPDX-License-Identifier: MIT
#include "tangles/coloring.h"

#include <algorithm>

namespace flg::studio {
namespace {

// The accent of an operation and its kinds of parts; another than what is around.
uint32_t accent(uint32_t number, uint32_t around) {
    static const std::vector<uint32_t> accents = accent_materials();
    const uint32_t chosen = accents[number % accents.size()];
    return chosen != around ? chosen : accents[(number + 1) % accents.size()];
}

uint32_t own_color(const RegionList& regions, uint32_t region, const std::vector<uint32_t>& materials) {
    const FlgTangleRegion& r = regions[region];
    const uint32_t around = materials[r.parent], number = r.operation > 0 ? r.operation - 1 : 0;
    const Operation& made_by = regions.operation(r.operation);
    if (made_by.is_chequer && regions[r.parent].operation + 1 == r.operation) {
        const uint32_t row = regions[r.parent].part, below = materials[regions[r.parent].parent];
        return (row + r.part) % 2 == 1 ? below : accent(number - 1, below);
    }
    switch (made_by.grouping) {
        case FLG_TANGLE_GROUPING_ONE: return accent(number, around);
        case FLG_TANGLE_GROUPING_EACH: return accent(number + r.part, around);
        case FLG_TANGLE_GROUPING_CYCLE: {
            const uint32_t kind = r.part % std::max(made_by.cycle, 1u);
            return kind == 1 ? around : accent(number + (kind > 1 ? kind - 1 : 0), around);
        }
        default: return r.part % 2 == 1 ? around : accent(number, around);
    }
}

}  // namespace

uint32_t seen_region(const RegionList& regions, uint32_t region) {
    while (region != 0 && regions[region].scaffold != 0) region = regions[region].parent;
    return region;
}

std::vector<uint32_t> color_regions(const RegionList& regions, const Paints& paints, size_t material_count) {
    std::vector<uint32_t> materials(regions.count(), kGroundMaterial);
    for (uint32_t r = 0; r < regions.count(); ++r) {
        const auto painted = paints.find(r);
        if (painted != paints.end() && painted->second < material_count)
            materials[r] = painted->second;
        else if (r != 0)
            materials[r] = regions[r].scaffold != 0 ? materials[regions[r].parent] : own_color(regions, r, materials);
    }
    return materials;
}

TangleLook make_look(const RegionList& regions, const std::vector<uint32_t>& materials, const Palette& palette,
                     bool shows_scaffolds) {
    TangleLook made;
    made.look.border_width_px = palette.border_px;
    made.look.border_color = palette.border_color;
    made.label_of.assign(regions.count(), 0);
    // Lines are those of the material further down, so labels go by materials first.
    struct Shown {
        uint32_t material, look, region;
    };
    std::vector<Shown> shown;
    for (const uint32_t leaf : regions.leaves())
        shown.push_back({materials[leaf], shows_scaffolds ? leaf : regions[leaf].look, leaf});
    std::sort(shown.begin(), shown.end(), [](const Shown& a, const Shown& b) {
        return a.material != b.material ? a.material < b.material : a.look < b.look;
    });
    for (size_t i = 0; i < shown.size(); ++i) {
        if (i == 0 || shown[i].material != shown[i - 1].material || shown[i].look != shown[i - 1].look) {
            render::Material material = to_render(palette.materials[shown[i].material]);
            if (palette.border_px == 0.0f) material.border_width_px = 0.0f;
            made.look.regions.push_back(material);
        }
        made.label_of[shown[i].region] = static_cast<uint32_t>(made.look.regions.size() - 1);
    }
    return made;
}

}  // namespace flg::studio
