// SPDX-License-Identifier: MIT
// Where values lie among the levels of a cut, and the labels that follow from it.
#pragma once

#include <algorithm>
#include <span>

#include "surfaces/mesh.h"

namespace flg {

// Triangles of `region` that lie above k levels get the label first_label + k; with no_index they keep theirs.
struct RegionLevels {
    uint32_t region;
    uint32_t first_label;

    uint32_t label_above(uint32_t levels) const { return first_label == no_index ? region : first_label + levels; }
};

class CutLevels {
public:
    // Levels are finite and rise; regions, those to cut, rise too.
    CutLevels(std::span<const float> levels, std::span<const RegionLevels> regions)
        : levels_(levels), regions_(regions) {}

    float operator[](uint32_t level) const { return levels_[level]; }
    uint32_t count() const { return static_cast<uint32_t>(levels_.size()); }

    // How many levels are <= value, and < value.
    uint32_t up_to(float value) const {
        return static_cast<uint32_t>(std::upper_bound(levels_.begin(), levels_.end(), value) - levels_.begin());
    }
    uint32_t below(float value) const {
        return static_cast<uint32_t>(std::lower_bound(levels_.begin(), levels_.end(), value) - levels_.begin());
    }

    // Those strictly between two values.
    struct Range {
        uint32_t first, count;
    };
    Range between(float a, float b) const {
        const uint32_t first = up_to(std::min(a, b)), end = below(std::max(a, b));
        return {first, end > first ? end - first : 0};
    }
    // The number of levels that what lies from `low` to `high` is above; none of them between these. What is flat at a
    // level lies below it.
    uint32_t interval(float low, float high) const { return low < high ? up_to(low) : below(low); }

    // Null for regions that are not cut.
    const RegionLevels* find(uint32_t region) const {
        const auto found =
            std::lower_bound(regions_.begin(), regions_.end(), region,
                             [](const RegionLevels& listed, uint32_t asked) { return listed.region < asked; });
        return found != regions_.end() && found->region == region ? &*found : nullptr;
    }

private:
    std::span<const float> levels_;
    std::span<const RegionLevels> regions_;
};

}  // namespace flg
