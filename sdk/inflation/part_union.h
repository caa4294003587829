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

    // `blend`: the length over which crossings are rounded, in the model's units; 0: not; below 0: a share of the smaller of
    // the two parts' radii. What the parts show outlives it.
    PartUnion(std::span<const PlacedPart> parts, double blend, Memory* memory);

    // Gets ready: true when it is. A unit is about 0.5 us; about one a part, and for each of the coarse cells that it reaches into 2 ns.
    // Throws as ImplicitPart does.
    bool run(uint32_t count);

    std::span<const ImplicitPart> parts() const { return parts_; }
    // Far below 0 where no part is near. About 50 ns, and as much for each part that is near.
    Sample sample(const Vec3& p) const;
    // Lengths of blends are at most this.
    double widest_blend() const { return widest_; }

private:
    enum class Pass { parts, clear, count, sum, fill, done };

    void begin_cells();
    double blend_of(uint32_t a, uint32_t b) const;
    template <class Action>
    bool layer(const Action& action);
    void cells_of(const ImplicitPart& part, std::array<uint32_t, 3>& first, std::array<uint32_t, 3>& last) const;

    std::span<const PlacedPart> placed_;
    Memory* memory_;
    std::pmr::vector<ImplicitPart> parts_;
    double blend_;
    double widest_ = 0, margin_ = 0;
    // Which parts may matter in each cell of a coarse grid over all of them.
    Vec3 low_, high_;
    double cell_ = 0;
    std::array<uint32_t, 3> counts_{};
    Buffer<uint32_t> offsets_, near_;
    Pass pass_ = Pass::parts;
    uint32_t at_ = 0, layer_ = 0;
};

}  // namespace flg
