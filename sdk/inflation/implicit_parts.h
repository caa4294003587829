// SPDX-License-Identifier: MIT
// A part in its place, as a function of space: above zero inside, below outside, near its surface about the distance to
// it.
//
//     F(u, v, w) = thickness^2 g(u, v) - w^2        value = 2 F / (|grad F| + sqrt(|grad F|^2 + 4 F))
//
// in the part's plane, with g from the raster (cubic, so that slopes are continuous). For a ball the value is the
// distance everywhere. Surfaces are where F = 0 is, whatever the normalization.
//
// All parts as one function: the largest of their values. Where two of them cross, the edge between them may be rounded
// off: by the blend of Quilez (smooth minimum, 2013) with a length that shrinks to 0 where the surfaces are parallel,
// so that parts in one plane, and copies of a part, are not swollen.
//
// Parts that are kept apart end where both have the same value, each half a gap before it: where they overlap they
// touch, as thighs do. What they hang on is joined with each of them: its values go on there.
//
// A part may be lifted out of its plane (part_depths.h says how far): w is measured from there.
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "core/vec.h"
#include "inflation/inflate_part.h"
#include "runtime/task.h"

namespace flg {

// How far a part is out of its plane: `base` where it hangs, `base` and `rise` from `reach` on, evenly in between. In
// units of its contour.
struct PartLift {
    double at(double way) const {
        const double t = std::clamp(way / reach, 0.0, 1.0);
        return base + rise * t * t * (3 - 2 * t);
    }
    double slope(double way) const {
        const double t = std::clamp(way / reach, 0.0, 1.0);
        return rise * 6 * t * (1 - t) / reach;
    }

    double base = 0, rise = 0, reach = 1;
    Buffer<double> ways;  // from where it hangs, within the contour, on the part's raster; none needed without a rise
};

struct PlacedPart {
    const InflatedPart* part = nullptr;
    // Rows of a 3 x 4 matrix: (x, y, z, 1) of the part's plane, z its normal, to the model. Rotation, one scale,
    // translation, mirrored or not.
    std::array<double, 12> placement = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    double thickness = 1;  // as InflationOptions has it; the part's own does not matter here
    // Parts that it touches without becoming one with them, as they do not with it; by number.
    std::span<const uint32_t> apart_from{};
    const PartLift* lift = nullptr;  // none: it stays in its plane
};

class ImplicitPart {
public:
    struct Sample {
        double value;
        Vec3 gradient;  // of length 1 or 0: where value grows fastest
    };

    // Throws, with the number of the part, if the matrix is not what it has to be, or the thickness not above 0. The
    // part outlives it.
    ImplicitPart(const PlacedPart& placed, uint32_t number);

    // Whether it may be above -`margin` at a point.
    bool reaches(const Vec3& p, double margin) const {
        return ((p - low_).array() > -margin).all() && ((p - high_).array() < margin).all();
    }
    // About 40 ns.
    Sample sample(const Vec3& p) const;

    const InflatedPart& part() const { return *part_; }
    double thickness() const { return thickness_; }
    double scale() const { return scale_; }
    // The lesser of half its depth and of the radius of a disc that surely fits into its contour; in the model's units.
    double radius() const { return radius_; }
    const Vec3& low() const { return low_; }
    const Vec3& high() const { return high_; }
    // Of a point of the part's space, and back.
    Vec3 place(const Vec3& p) const { return matrix_ * p + origin_; }
    Vec3 local(const Vec3& p) const { return inverse_ * (p - origin_); }
    // Of unit length.
    Vec3 normal() const { return matrix_.col(2) / scale_; }
    // In units of the contour: the square of the height over a point of its plane, below 0 outside; how far the part is
    // out of its plane there.
    double squared_height(double u, double v) const;
    double lift(double u, double v) const;

private:
    const InflatedPart* part_;
    const PartLift* lift_;
    double thickness_, scale_ = 0, radius_ = 0;
    Eigen::Matrix3d matrix_, inverse_;
    Vec3 origin_, low_, high_;
};

class PartUnion {
public:
    struct Sample {
        double value;
        Vec3 gradient;  // about; where it grows fastest
        uint32_t part;  // whose value is largest
    };

    // `blend`: the length over which crossings are rounded, in the model's units; 0: not; below 0: a share of the
    // smaller of the two parts' radii. What the parts show outlives the union. Takes about 0.5 us a part, and 2 ns for
    // each of the coarse cells that it reaches into. Throws as ImplicitPart does.
    static Task<PartUnion> make(Pace& pace, std::span<const PlacedPart> parts, double blend);

    // How far parts that are kept apart are from each other, at least. 0 at first.
    void set_gap(double gap) { gap_ = gap; }

    std::span<const ImplicitPart> parts() const { return parts_; }
    // Far below 0 where no part is near. About 50 ns, and as much for each part that is near.
    Sample sample(const Vec3& p) const;
    // The value of part a less that of part b, where others cut them off too; the gradient is not normalized.
    ImplicitPart::Sample difference(const Vec3& p, uint32_t a, uint32_t b) const;
    // Lengths of blends are at most this.
    double widest_blend() const { return widest_; }

private:
    struct Cells {
        std::array<uint32_t, 3> first, last;
    };

    PartUnion(double blend, Memory* memory) : parts_(memory), apart_from_(memory), blend_(blend) {}
    double blend_of(uint32_t a, uint32_t b) const;
    bool are_apart(uint32_t a, uint32_t b) const;
    struct Near;
    ImplicitPart::Sample cut_off(const ImplicitPart::Sample& whole, uint32_t part, const Vec3& p,
                                 const Near& near) const;
    Cells cells_of(const ImplicitPart& part) const;
    template <class Action>
    uint32_t each_cell_in_layer(uint32_t part, uint32_t layer, const Action& action) const;

    std::pmr::vector<ImplicitPart> parts_;
    std::pmr::vector<std::span<const uint32_t>> apart_from_;  // by part
    double blend_;
    double widest_ = 0, margin_ = 0, gap_ = 0;
    // Which parts may matter in each cell of a coarse grid over all of them.
    Vec3 low_, high_;
    double cell_ = 0;
    std::array<uint32_t, 3> counts_{};
    Buffer<uint32_t> offsets_, near_;
};

}  // namespace flg
