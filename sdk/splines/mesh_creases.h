// SPDX-License-Identifier: MIT
// What rounds a sharp edge or corner: a sample of the cylinder or sphere that touches the planes on all its sides.
// Samples of the planes alone would swell there, each counting where another plane is the surface.
#pragma once

#include "core/vec.h"
#include "splines/oriented_samples.h"

namespace flg {

class CreaseRounding {
public:
    // Of a place on the crease.
    explicit CreaseRounding(const Vec3& place) : place_(place) {}

    // One of the planes there, by its normal of unit length.
    void add_normal(const Vec3& normal) {
        planes_ += normal * normal.transpose();
        sum_ += normal;
    }
    // `convex`: the sides of an edge there fall away from each other.
    void add_edge(bool convex) { (convex ? convex_ : concave_) = true; }

    // The sample, of so large a radius of curvature that it touches the planes no farther than `length` away from an
    // edge, nor is that radius longer; metres, > 0. About 0.5 us. False where edges are of both kinds, or as sharp as
    // knives.
    bool round(double length, double radius, OrientedSample& sample) const;

private:
    Vec3 place_;
    Eigen::Matrix3d planes_ = Eigen::Matrix3d::Zero();
    Vec3 sum_ = Vec3::Zero();
    bool convex_ = false, concave_ = false;
};

}  // namespace flg
