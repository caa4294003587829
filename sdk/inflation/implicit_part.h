// SPDX-License-Identifier: MIT
// A part in its place, as a function of space: above zero inside, below outside, near its surface about the distance to it.
//
//     F(u, v, w) = thickness^2 g(u, v) - w^2        value = 2 F / (|grad F| + sqrt(|grad F|^2 + 4 F))
//
// in the part's plane, with g from the raster (cubic, so that slopes are continuous). For a ball the value is the distance
// everywhere. Surfaces are where F = 0 is, whatever the normalization.
#pragma once

#include <array>

#include "core/vec.h"
#include "inflation/inflated_part.h"

namespace flg {

struct PlacedPart {
    const InflatedPart* part = nullptr;
    // Rows of a 3 x 4 matrix: (x, y, z, 1) of the part's plane, z its normal, to the model. Rotation, one scale, translation,
    // mirrored or not.
    std::array<double, 12> placement = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    double thickness = 1;  // as InflationOptions has it; the part's own does not matter here
};

class ImplicitPart {
public:
    struct Sample {
        double value;
        Vec3 gradient;  // of length 1 or 0: where value grows fastest
    };

    // Throws, with the number of the part, if the matrix is not what it has to be, or the thickness not above 0. The part outlives it.
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
    // Of a point of the part's space.
    Vec3 place(const Vec3& p) const { return matrix_ * p + origin_; }

private:
    const InflatedPart* part_;
    double thickness_, scale_ = 0, radius_ = 0;
    Eigen::Matrix3d matrix_, inverse_;
    Vec3 origin_, low_, high_;
};

}  // namespace flg
