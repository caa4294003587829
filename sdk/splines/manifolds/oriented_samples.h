// SPDX-License-Identifier: MIT
// The smooth surface of samples that know which way is out: implicit moving least squares (Kolluri: Provably good
// moving least squares, 2008; Adamson, Alexa: Approximating and intersecting surfaces from points, 2003) with samples
// that also know how the surface bends. F(x) is the mean of
//     f_i(x) = n_i . (x - p_i) + 1/2 (x - p_i)^T B_i (x - p_i)
// weighted by (1 - |x - p_i|^2 / r_i^2)^4 / r_i^4, which is 0 from the radius r_i on: where samples of different radii
// overlap, fine ones count. F has three continuous derivatives.
//
// Sheets. Of thin parts only one side may count: what faces away from the sample that suits x best, by more than about
// 114 degrees, takes no part. On a sheet that turns less within its radii nothing depends on which sample that is;
// across an edge that is sharper F jumps by about what the sheets are apart there.
//
// Samples that cover a point are remembered with it, with slack, so that points that move little need not look for
// them. They are added up in one order, so the same bits come out without that.
#pragma once

#include "core/vec.h"
#include "splines/manifolds/hypersurface.h"
#include "splines/manifolds/point_tree.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

struct OrientedSample {
    std::array<double, 3> position;
    std::array<double, 3> normal;  // outwards, of unit length
    std::array<double, 6> bend;    // B: xx, xy, xz, yy, yz, zz
    double radius;                 // > 0
    double sharpness = 0;          // 1 / radius^2: oriented_samples() sets it
};

inline Vec3 place_of(const OrientedSample& sample) {
    return Vec3(sample.position[0], sample.position[1], sample.position[2]);
}
inline Vec3 normal_of(const OrientedSample& sample) {
    return Vec3(sample.normal[0], sample.normal[1], sample.normal[2]);
}

class OrientedSamples final : public Hypersurface {
public:
    // From oriented_samples(): samples in the order of the tree, as many as that has. `size`: of the whole surface.
    OrientedSamples(Buffer<OrientedSample> samples, PointTree tree, double size, double mean_radius);

    // False where no sample reaches. With samples remembered, about 15 of them: 0.4 us; else 2 us. Of more than 256
    // samples that reach a point the first of the tree's order count.
    bool evaluate(const double* x, double* hint, double* value, double* gradient, double* second) const override;

    // As Hypersurface; from farther away than samples reach: on from the nearest sample, towards the nearest point.
    // Beyond an open border that is a point near the border. 1 us near the surface, up to 20 us far away.
    bool project(double* x, double* hint) const override;

    // How far a place near the surface is from it, up to the square of that: |F| / |grad F|. False where no sample
    // reaches.
    bool distance_estimate(const Vec3& place, double* distance) const;

    // Calls visit(first, end) with ranges of samples, among them all that are not farther from the place.
    template <class Visit>
    void around(const Vec3& place, double distance, Visit&& visit) const {
        tree_.around(place.data(), distance, visit);
    }
    double mean_radius() const { return mean_radius_; }

    uint32_t sample_count() const { return tree_.size(); }
    const OrientedSample& sample(uint32_t i) const { return samples_[i]; }
    // The one whose position is nearest; of equally near ones, any, but always the same.
    uint32_t nearest_sample(const Vec3& x) const;

private:
    static constexpr uint32_t max_active = 256, remembered = 90;
    struct Active;
    struct Nearby;
    struct Blend;

    uint32_t gather(const double* x, double* hint, uint32_t* list) const;
    bool blend(const double* x, double* hint, const Vec3* sheet, bool with_second, Blend& result) const;
    bool descend(Vec3& x, double* hint, bool from_sample) const;

    bool bracket(Vec3& x, const OrientedSample& sample, double* hint) const;

    Buffer<OrientedSample> samples_;
    PointTree tree_;
    double mean_radius_;
};

// Sorts samples, at least 4 (or a Failure says so), and makes their tree. They are given back meanwhile. Most of those
// that lie much closer together than they reach are left out, such as those around the pole of a globe. About 80 ns a
// sample.
Task<OrientedSamples> oriented_samples(Pace& pace, GrowingBuffer<OrientedSample>& samples);

}  // namespace flg
