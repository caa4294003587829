// SPDX-License-Identifier: MIT
// How a surface bends at a point, and which way its normal really goes there, from points and normals around it: least
// squares of a height z0 + a u + b v + (c u^2 + 2 e u v + g v^2) / 2 over the plane of a first normal (Cazals, Pouget:
// Estimating differential quantities using polynomial fitting of osculating jets, 2005), with normals as further
// equations, so that three neighbours are enough.
#pragma once

#include <array>

#include "core/vec.h"

namespace flg {

struct BentNormal {
    Vec3 normal;                   // of unit length
    std::array<double, 6> bend{};  // as that of OrientedSample
    double height = 0;             // of the surface over the point, metres, along the first normal
    double curvature = 0;          // the largest absolute one that was found, 1 / metres, also where `bend` is none
};

enum class QuadricKind {
    through,  // the surface passes through the place itself
    near,     // near ones count most
    smooth,   // those within `quadric_reach` spacings count much alike, and normals across creases not at all
};
constexpr double quadric_reach = 1.6;

class QuadricFit {
public:
    // Around `place`; `spacing`, > 0: how far the neighbours are, about.
    QuadricFit(const Vec3& place, const Vec3& normal, double spacing, QuadricKind kind);

    // Neighbours: 30 ns each.
    void add_point(const Vec3& point);
    void add_normal(const Vec3& point, const Vec3& normal);
    // About 0.3 us. Where a quadric is far from what was added there is no bend and, of surfaces through the place, the
    // normal is the first one; where it is creased there is neither height.
    BentNormal solve() const;

private:
    static constexpr size_t unknowns = 6;  // z0, a, b, c, e, g; lengths are in units of the spacing
    using Row = std::array<double, unknowns>;

    void add_row(const Row& row, double right, double weight);
    Vec3 local(const Vec3& point) const;

    Vec3 place_, normal_, u_, v_;
    double per_spacing_;
    std::array<double, unknowns * unknowns> matrix_{};  // lower part
    Row right_{};
    double squares_ = 0, weights_ = 0;  // sums: of the equations' right sides, of the points' weights
    QuadricKind kind_;
    bool creased_ = false;
};

}  // namespace flg
