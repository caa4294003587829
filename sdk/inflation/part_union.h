// SPDX-License-Identifier: MIT
// All parts as one function: the largest of their values. Where two of them cross, the edge between them may be rounded
// off: by the blend of Quilez (smooth minimum, 2013) with a length that shrinks to 0 where the surfaces are parallel, so that parts
// in one plane, and copies of a part, are not swollen.
#pragma once

#include <span>
#include <vector>

#include "inflation/implicit_part.h"

namespace flg {

class PartUnion {
public:
    struct Sample {
        double value;
        Vec3 gradient;  // about; where it grows fastest
        uint32_t part;  // whose value is largest
    };

    // `blend`: the length over which crossings are rounded, in the model's units; 0: not; below 0: a share of the smaller of the two parts'
    // radii. Throws as ImplicitPart does.
    PartUnion(std::span<const PlacedPart> parts, double blend, Memory* memory);

    std::span<const ImplicitPart> parts() const { return parts_; }
    // Far below 0 where no part is near. Linear in the parts, with 5 ns for each that is not near.
    Sample sample(const Vec3& p) const;
    // Lengths of blends are at most this.
    double widest_blend() const { return widest_; }

private:
    double blend_of(uint32_t a, uint32_t b) const;

    std::pmr::vector<ImplicitPart> parts_;
    double blend_;
    double widest_ = 0;
};

}  // namespace flg
