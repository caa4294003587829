// SPDX-License-Identifier: MIT
// Embeds the isolines of a field at many levels into the mesh, in one pass and without ordering them: sec. 4.2 of
// Nazzaro, Puppo, Pellacini: geoTangle (2021), for many levels at once and with bounded slivers.
//
// Invariants
// - The field is linear in each triangle. A triangle that levels cross is cut into the strips between them; a vertex
//   that comes in at a level has the level's value exactly, and each piece lies between two levels.
// - Snapping: where the level next to a vertex's value differs from it by at most cut_tolerance of the steepest edge
//   that leaves the vertex within a crossed triangle, the vertex's value becomes that level. This is decided for all
//   vertices before any value moves, so all triangles see the same. With a single level, no new point is nearer to an
//   end of its edge than that fraction of the edge; points of different levels are as near to each other as the levels
//   are.
// - Only triangles of the listed regions are cut, and only if all their values are finite. Others that share an edge
//   with a cut one are split to stay joined to it, and keep their label; but those of listed regions with a value that
//   is not finite count as above all levels.
#pragma once

#include <algorithm>
#include <span>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh_edit.h"
#include "surfaces/mesh/mesh_growth.h"

namespace flg {

// Triangles of `region` that lie above k levels get the label first_label + k; with no_index they keep theirs.
struct RegionLevels {
    uint32_t region;
    uint32_t first_label;

    uint32_t label_above(uint32_t levels) const { return first_label == no_index ? region : first_label + levels; }
};

// Where values lie among the levels of a cut, and the labels that follow from it.
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

    std::span<const RegionLevels> regions() const { return regions_; }
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

// So that no triangle takes longer than a slice may.
constexpr uint32_t max_cut_levels = 256;

// `field`: the column (of one component) whose isolines these are; its values move by snapping. `edit` is a new one; if
// this throws for want of memory, it takes back what was changed. 0.2 us for 64 triangles of the regions, and for each
// crossed triangle four times. Memory while it runs: 16 bytes for 64 triangles, 56 bytes a crossed triangle.
Task<void> embed_isolines(Pace& pace, Mesh& mesh, MeshColumns& columns, uint32_t field, CutLevels levels,
                          MeshEdit& edit);

}  // namespace flg
