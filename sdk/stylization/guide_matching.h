// SPDX-License-Identifier: MIT
// Which point of the style belongs to which point of the guide: the semi-discrete matching of Minarcik, Fiser, Sykora,
// "Example-Based Authoring of Expressive Space Curves", sec. 4.2. Minimizes over non-decreasing delta, ends fixed,
//     E'(delta) = sum over 1 <= i <= N-2 of
//                 beta |G_i - gamma_S(delta_i)|^2 + (1 - beta) (delta_i - L_S i / (N - 1))^2.
//
// Departures from the paper
// - Its distortion term compares delta_i with (L_S / L_G) i; what is meant is the arc length s_i = L_G i / (N - 1).
// - Its start is not said, and E' has many local minima. Here: dynamic programming from coarse to fine. Alone, point i
//   would not go further from its even place e_i than |delta_i - e_i| <= sqrt(beta / (1 - beta)) |G_i - gamma_S(e_i)|,
//   where distortion outweighs all that closeness could win; the coarsest table is the monotone hull of that. Each
//   finer one has a third of the stride and stays within one coarse step of the path before.
// - It lets a step delta_(i+1) - delta_i be of any length. Where the style turns back along its guide, E' has its
//   minimum in a long one, and what that passes by is cut off. Here steps have a bound. (With 1.4 times the mean, 53
//   built-in styles and scribbles keep at least 97 % of their length on their own guide, without it 79 %; the
//   rms of their displacement grows by 3 % in the middle, 10 % at most.) The dynamic programming knows no bound.
// - Its Hessian 2I leaves out the style's curvature. E' couples points through order and bound only: each point is
//   taken to its own minimum by Newton's method inside a bracket, then the models found there are minimized within
//   order and bound, exactly; points that are held by these get new models where they are, until they rest.
// Invariants: delta_0 = 0, delta_(N-1) = L_S, steps from 0 to the bound.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/task.h"
#include "stylization/smooth_style_curve.h"

namespace flg {

struct GuideMatch {
    Buffer<double> places;  // the arc lengths delta_i on the style
    // E', by the models: exact to third order in the last steps.
    double energy = 0.0;
    uint32_t sweeps = 0;  // how often points were pooled
};

// `guide`: at least two points, evenly spaced. It and the style's points outlive the task. `beta` in (0, 1): closeness
// against evenness. `farthest_step`: the bound, metres of the style, at least the mean. About 3 us a point.
Task<GuideMatch> match_guide(Pace& pace, SmoothStyleCurve style, std::span<const Vec3> guide, double beta,
                             double farthest_step);

}  // namespace flg
