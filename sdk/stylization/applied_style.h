// SPDX-License-Identifier: MIT
// A style as one job applies it: displacements and attributes (Minarcik, Fiser, Sykora, sec. 5) in the size and in the
// basis that the job wants, node by node, so that a sample costs one look-up.
#pragma once

#include <array>
#include <vector>

#include "core/memory.h"
#include "core/vec.h"
#include "stylization/style.h"

namespace flg {

struct AppliedAttribute {
    FlgAttribute attribute = FLG_ATTRIBUTE_USER;
    uint32_t components = 0;
    // The components from this one on are angles, of which values this far apart are equal; none if it is `components`.
    uint32_t first_angle = 0;
    double period_rad = 0;
    Buffer<float> values;  // `components` a node; lengths times the scale
};

struct AppliedStyle {
    // By how much a ribbon is turned.
    struct Turn {
        double cosine, sine;
    };

    explicit AppliedStyle(Memory* memory) : attributes(memory) {}
    // Null if the style doesn't transfer it.
    const AppliedAttribute* find(FlgAttribute attribute) const;

    Buffer<Vec3> displacement;  // metres along the target's tangent, first and second normal, at magnitude 1
    Buffer<Turn> turns;         // empty if the style doesn't transfer ANGLE
    std::pmr::vector<AppliedAttribute> attributes;
};

// A unit is a point of the style, about 30 ns.
class AppliedStyleKernel {
public:
    // Row-major: basis times (along tangent, first normal, second normal). The style outlives the kernel.
    AppliedStyleKernel(const PreparedStyle& style, double scale, const std::array<double, 9>& basis, Memory* memory);
    bool run(uint32_t n);
    // After run() returned true.
    AppliedStyle take() { return std::move(result_); }

private:
    void apply_point(uint32_t node);

    const PreparedStyle& style_;
    double scale_;
    Eigen::Matrix3d scaled_basis_;
    AppliedStyle result_;
    uint32_t done_ = 0;
};

}  // namespace flg
