// SPDX-License-Identifier: MIT
// The flow of Minarcik, Fiser, Sykora, "Example-Based Authoring of Expressive Space Curves", sec. 4.1, as written
// there: Euler steps of d gamma / dt = kappa (1 - alpha kappa F') n + theta_t t with Steiner's discrete curvature
// (corners expanded by a line segment) and the tangential redistribution of Eq. 3, with that equation's two errors
// mended:
//   For d/dt (|gamma_u| / L) = 0 the tangential speed must obey d theta_t / ds = kappa theta_n + (dL/dt) / L, where
//   dL/dt = (alpha - 1) int kappa^2. (In the paper the first integrand lacks kappa and the second term has the other
//   sign.)
//   Both ends are pinned: theta_t(0) = 0, and theta_t(L) = int kappa theta_n + dL/dt = 0 then holds by itself.
// Explicit, and ill-posed where 2 alpha kappa F' > 1: only for smooth curves, short times, and few points.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace flg::reference {

struct LiteralFlow {
    std::vector<Vec3> points;
    double time = 0.0;
    double predicted_length = 0.0;  // the first length plus the integral of (alpha - 1) int kappa^2 over time
};

// `steps` steps of `step_time` from the evenly spaced `curve`. Without `redistribution` theta_t = 0: the same shapes as
// long as the points, which gather where the curve bends, allow (Fig. 13 of the paper).
LiteralFlow literal_guide_flow(const std::vector<Vec3>& curve, double alpha, double step_time, uint32_t steps,
                               bool redistribution = true);

}  // namespace flg::reference
