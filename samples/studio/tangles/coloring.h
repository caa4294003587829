// SPDX-License-Identifier: MIT
// What regions look like: as they were painted, or the nearest region around them was; what operators make has colours
// of its own until it is painted, every other part another than what it lies in.
#pragma once

#include <map>

#include "filigree_renderer/surface_look.h"
#include "tangles/house_materials.h"
#include "tangles/region_list.h"

namespace flg::studio {

using Paints = std::map<uint32_t, uint32_t>;  // region, place in the palette

// The region that is seen where this one is: scaffolds look like what they lie in.
uint32_t seen_region(const RegionList& regions, uint32_t region);

// A place in the palette for each region; paints beyond its materials don't count.
std::vector<uint32_t> color_regions(const RegionList& regions, const Paints& paints, size_t material_count);

struct TangleLook {
    render::SurfaceLook look;
    std::vector<uint32_t> label_of;  // of regions: those between which there is no line have the same
};
TangleLook make_look(const RegionList& regions, const std::vector<uint32_t>& materials, const Palette& palette,
                     bool shows_scaffolds);

}  // namespace flg::studio
