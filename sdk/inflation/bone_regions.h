// SPDX-License-Identifier: MIT
// Which bone of a part is nearest to a point of it, by the length of the way that stays within the drawn contour: limbs
// beside each other are as far apart as the way around the gap between them.
//
// Distances spread over the part's triangulation from the vertices around each bone (fast marching: Kimmel, Sethian,
// Computing geodesic paths on manifolds, 1998), in the part's plane: its depth makes no way shorter.
#pragma once

#include <array>
#include <span>

#include "inflation/implicit_parts.h"
#include "runtime/each.h"
#include "runtime/task.h"
#include "skeletons/bone_tree.h"

namespace flg {

class BoneRegions {
public:
    // The nearest bones at the corners of the triangle around a point.
    struct Found {
        uint32_t count = 0;
        std::array<uint32_t, 3> bones{};
    };

    // `own`: the bones of the part, by number in `bones`, ascending. The part outlives the regions. Takes about 2 us a
    // vertex of the part's triangulation.
    static Task<BoneRegions> make(Pace& pace, const PlacedPart& part, std::span<const BoneSegment> bones,
                                  std::span<const uint32_t> own);

    // Of a point of the model's space on the part's surface or nearby; none if it is farther off, or if no bone lies in
    // the part. About 0.3 us.
    Found at(const Vec3& position) const;
    // Bones of the part that have an end in common with one of them.
    std::span<const uint32_t> next_to(uint32_t bone) const { return next_to_.of(bone - first_own_); }

private:
    explicit BoneRegions(const PlacedPart& part);
    Point2 local(const Vec3& position) const;
    uint32_t cell_of(const Point2& at) const;
    uint32_t find_triangle(const Point2& at, std::array<double, 3>& shares) const;

    const InflatedPart* part_;
    Eigen::Matrix3d to_local_;
    Vec3 origin_;
    Groups triangles_in_;  // triangles by the cell of a coarse grid that their middle is in
    Point2 low_{};
    double cell_ = 0;  // as long as the longest edge: what is around a point is in the nine cells around it
    uint32_t columns_ = 0, rows_ = 0;
    Buffer<uint32_t> bone_of_;  // by vertex
    Groups next_to_;            // by bone, from the first of the part on
    uint32_t first_own_ = 0;
};

}  // namespace flg
