// SPDX-License-Identifier: MIT
// The two ways of matching guide and style in Minarcik, Fiser, Sykora, "Example-Based Authoring of Expressive Space
// Curves", sec. 4.2, as written there (with s_i = L_G i / (N - 1) in the distortion term): dynamic programming over
// sampled places, and gradient descent with the Hessian 2I and clipping to the neighbours.
#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace flg::reference {

struct LiteralMatching {
    std::vector<double> delta;  // arc lengths on the style
    double energy = 0.0;        // E'; infinite when no sequence is possible
};

// Best sequence of style points with both ends fixed. O(N M) time and space. With `strict` every point of the style is
// used at most once, which needs at least as many of them as the guide has.
LiteralMatching match_discrete(const std::vector<Vec3>& style, double style_length, const std::vector<Vec3>& guide,
                               double beta, bool strict);

// Projected descent from the even matching; the style is the Catmull-Rom cubic through its points.
LiteralMatching match_by_gradient(const std::vector<Vec3>& style, double style_length, const std::vector<Vec3>& guide,
                                  double beta, uint32_t steps);

}  // namespace flg::reference
