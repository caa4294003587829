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
    Buffer<Vec3> displacement;  // metres along the target's tangent, first and second normal, at magnitude 1
    std::span<const StyleAttribute> attributes;
    double scale = 1;  // of the attributes' lengths

    // Where in `attributes` it is; their number if the style doesn't transfer it.
    size_t find(FlgAttribute attribute) const;
};

// A unit is a point of the style, about 10 ns.
class AppliedStyleKernel {
public:
    // Row-major: basis times (along tangent, first normal, second normal). The style outlives the kernel and the result.
    // Throws what the host is told, as run() does, if the style would get larger than coordinates may be.
    AppliedStyleKernel(const PreparedStyle& style, double scale, const std::array<double, 9>& basis, Memory* memory);
    bool run(uint32_t n);
    // After run() returned true.
    AppliedStyle take() { return std::move(result_); }

private:
    const PreparedStyle& style_;
    Eigen::Matrix3d scaled_basis_;
    AppliedStyle result_;
    uint32_t done_ = 0;
};

}  // namespace flg
