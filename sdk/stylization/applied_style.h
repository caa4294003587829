// SPDX-License-Identifier: MIT
// A style as one job applies it: displacements in the size and in the basis that the job wants, node by node, so that a
// sample costs one look-up.
#pragma once

#include <array>

#include "core/memory.h"
#include "core/vec.h"
#include "stylization/style.h"

namespace flg {

struct AppliedStyle {
    Buffer<Vec3> displacement;           // metres along the target's tangent, first and second normal, at magnitude 1
    std::array<Buffer<float>, 3> along;  // the same, as blocks of samples take them
    std::span<const StyleAttribute> attributes;
    double scale = 1;  // of the attributes' lengths
    double bend = 0;   // PreparedStyle::bend, scaled likewise

    // Where in `attributes` it is; their number if the style doesn't transfer it.
    size_t find(FlgAttribute attribute) const;
};

// `basis` is row-major.
Eigen::Matrix3d scaled_basis(double scale, const std::array<double, 9>& basis);

// A point of the style as it is applied.
inline Vec3 fitted(const Eigen::Matrix3d& scaled_basis, const Displacement& d, uint32_t node) {
    return scaled_basis * Vec3(d.along_tangent[node], d.along_normal[node], d.along_binormal[node]);
}

// Along a target's tangent, first and second normal.
inline Vec3 in_frame(const Vec3& d, const Vec3& tangent, const Vec3& normal) {
    return d.x() * tangent + d.y() * normal + d.z() * tangent.cross(normal);
}

// PreparedStyle::bend as it is applied.
double fitted_bend(const Eigen::Matrix3d& scaled_basis, const PreparedStyle& style);

// Throws what the host is told if the style's attributes would get larger than columns may be, somewhere: at the
// `largest_scale`.
void check_attribute_sizes(const PreparedStyle& style, double scale, double largest_scale);

// Row-major: basis times (along tangent, first normal, second normal). The style outlives the result. About 10 ns a
// point. Throws what the host is told if the style would get larger than coordinates may be, somewhere: at the
// `largest_scale`.
Task<AppliedStyle> fit_style(Pace& pace, const PreparedStyle& style, double scale, std::array<double, 9> basis,
                             double largest_scale);

}  // namespace flg
