// SPDX-License-Identifier: MIT
// Parts drawn in one plane that cross: which of them are not welded, and how far each comes out of its plane so that
// their surfaces don't cut through each other.
//
// Two parts cross where their bodies overlap away from where they hang on the part that bears both, or on each other.
// Up to `hold` from there a limb is one with what it hangs on; distances are measured within the contour
// (part_front.h). Beyond, an overlap that goes on from there is still a fork or a broad attachment and no crossing: up
// to some more of `hold`, unless the bones cross. If one hangs on the other in one plane and their depths
// differ, half as far.
//
// 1. Order. The part with the larger depth is in front; else the one whose plane is; else the one drawn later. Front is
//    where the normals of the first root point; the image of a part in a mirror across that faces the other way.
// 2. Limbs with all that hangs on them move as one, unless some of that crosses the rest of it. Roots, and what hangs
//    on them and crosses nothing, stay where they are.
// 3. Each crossing asks for a distance: the sum of both heights, where that is most, and a gap. Distances chain up
//    along the order from both ends; a limb takes the middle of both sums: the least depth for all that are free.
// 4. A part rises evenly from the joint to where it first crosses another. Where that would be steep, it hangs in front
//    of the joint or behind it, still within what it hangs on.
//
// Only parts whose planes are about parallel to that of the first root come out of them.
#pragma once

#include <array>
#include <deque>
#include <span>

#include "inflation/implicit_parts.h"
#include "runtime/each.h"
#include "runtime/task.h"
#include "skeletons/bone_tree.h"

namespace flg {

inline constexpr uint32_t no_part = UINT32_MAX;

// How a part hangs on others.
struct HungPart {
    uint32_t parent = no_part;
    Vec3 joint = Vec3::Zero();    // its own that it hangs by
    Vec3 bearing = Vec3::Zero();  // the parent's that it hangs on; counts where its own is outside of the parent
    double hold = 0;              // from there: so far it is one with the parent
    uint32_t twin = no_part;      // its mirror image: they don't move out of each other's way
    double depth = 0;             // larger: farther in front; equal: as they were drawn
    bool is_turned = false;       // an image in a mirror across the drawing: it faces backwards
};

struct DrawnParts {
    std::span<const PlacedPart> parts;  // in the order they were drawn
    std::span<const HungPart> hung;     // by part
    std::span<const BoneSegment> bones;
    std::span<const std::array<uint32_t, 2>> apart;  // pairs that are not welded even where they only touch
    double gap = 0;                                  // between surfaces that pass each other
};

struct PartDepths {
    explicit PartDepths(Memory* memory) : lifts(memory) {}

    // Parts that are not welded with a part.
    std::span<const uint32_t> apart_from(uint32_t part) const { return apart.of(part); }
    // How far a part is out of its plane; none: not at all.
    const PartLift* lift(uint32_t part) const {
        return lifts[part].base != 0 || lifts[part].rise != 0 ? &lifts[part] : nullptr;
    }

    Groups apart;
    std::pmr::deque<PartLift> lifts;  // by part
};

// What `drawn` shows outlives the task. Takes about 20 ns for each vertex of a part and each part that it overlaps, and
// 1.5 us a vertex of those that cross others.
Task<PartDepths> find_depths(Pace& pace, DrawnParts drawn);

}  // namespace flg
