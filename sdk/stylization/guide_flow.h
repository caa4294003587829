// SPDX-License-Identifier: MIT
// The guide of a style: the style curve with its detail smoothed away, by the length-controlling curvature flow of
// Minarcik, Fiser, Sykora, "Example-Based Authoring of Expressive Space Curves", sec. 4.1:
//     d gamma / dt = kappa (1 - w) n + tangential,   w = alpha F psi(kappa) / kappa,   F = int kappa^2 / int kappa psi,
// so that dL/dt = (alpha - 1) int kappa^2 (Eq. 2) and points stay evenly spaced.
//
// Departures from the paper
// - There psi = kappa^2, whose flow is backward parabolic, hence ill-posed, wherever 2 alpha F kappa > 1. Here psi goes
//   on along its tangent from the curvature kappa_c on where the diffusivity 1 - d(alpha F psi)/dkappa has fallen to (1
//   - alpha) / 2: the same flow where the paper's is well-posed, parabolic everywhere, with the same length law. At
//   alpha = 1 the only such flow is the one that stands still (int kappa V = 0 with V rising from 0).
// - Implicit steps in place of Euler's: one tridiagonal solve (I - dt (1 - w) d_ss) x' = x. Each new point is a convex
//   combination of old ones, so the curve never leaves its convex hull, whatever the input and the step.
// - The tangential term is carried out exactly, by respacing the points evenly after each step.
// - How far to flow is not in the paper. A wave of length l is damped by exp(-(1 - w) (2 pi / l)^2 t), and l shrinks as
//   the curve does: the flow ends at the damping wanted for the longest waves of the style, see `style_waves.h`.
// - There ends stay. A tip is anywhere on a wave, or a hook where a pen was put down: here the guide ends on the middle
//   line of the last waves, abreast of the tip.
// - The flow flattens the bends of the guide, too, the less the longer they are. As much time again takes about as much
//   again, while of waves nothing is left: 2 G(t) - G(2 t) has the style's bends. A term more would overshoot where
//   scribbles turn back.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "runtime/task.h"

namespace flg {

struct GuideFlowParams {
    double alpha = 0.5;  // 0 to 1: dL/dt = (alpha - 1) int kappa^2
    // The flow's time, as a multiple of the one chosen from the style. A style without waves is left as it is.
    double smoothing = 1.0;
    // Squared metres. Above 0: the bare flow between the style's own ends, for exactly this time.
    double time = 0.0;
    // Growth of t per step; the number of steps is about log(t / spacing^2) / growth, whatever the shape.
    double growth = 0.6;
};

struct FlowedGuide {
    std::pmr::vector<Vec3> points;  // as many as the style's
    double time = 0.0;              // t, squared metres
    double length = 0.0;
    uint32_t steps = 0;  // all that were made, those beyond `time` too
};

// `style`: at least two points, about evenly spaced. They outlive the task. About 10 ns a point and pass; a step has
// five or more.
Task<FlowedGuide> guide_flow(Pace& pace, std::span<const Vec3> style, GuideFlowParams params);

}  // namespace flg
