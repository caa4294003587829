// SPDX-License-Identifier: MIT
// The guide of a style: the style curve with its detail smoothed away, by the length-controlling curvature flow of
// Minarcik, Fiser, Sykora, "Example-Based Authoring of Expressive Space Curves", sec. 4.1:
//     d gamma / dt = kappa (1 - w) n + tangential,   w = alpha F psi(kappa) / kappa,   F = int kappa^2 / int kappa psi,
// so that dL/dt = (alpha - 1) int kappa^2 (Eq. 2) and points stay evenly spaced.
//
// Departures from the paper
// - There psi = kappa^2, whose flow is backward parabolic, hence ill-posed, wherever 2 alpha F kappa > 1. Here psi goes on
//   along its tangent from the curvature kappa_c on where the diffusivity 1 - d(alpha F psi)/dkappa has fallen to
//   (1 - alpha) / 2: the same flow where the paper's is well-posed, parabolic everywhere, with the same length law. At
//   alpha = 1 the only such flow is the one that stands still (int kappa V = 0 with V rising from 0).
// - Implicit steps in place of Euler's: one tridiagonal solve (I - dt (1 - w) d_ss) x' = x. Each new point is a convex
//   combination of old ones, so the curve never leaves its convex hull, whatever the input and the step.
// - The tangential term is carried out exactly, by respacing the points evenly after each step.
// - How far to flow is not in the paper, see `Params::smoothing`.
// Invariants: first and last point stay; the same bits for every slicing into run(n).
#pragma once

#include <cstdint>
#include <vector>

#include "core/memory.h"
#include "core/vec.h"

namespace flg {

class GuideFlow {
public:
    struct Params {
        double alpha = 0.5;  // 0 to 1: dL/dt = (alpha - 1) int kappa^2
        // The flow's time, as a multiple of the one chosen from the style. That one is the last valley of t * mean(kappa^2)
        // (the share of its length that the curve loses per unit of log t): detail of size r makes a peak there at t = r^2, the
        // overall bend makes it rise again. A curve without detail has its valley at the start, and is left as it is.
        double smoothing = 1.0;
        // Squared metres. Above 0: flow for exactly this time, smoothing has no effect.
        double time = 0.0;
        // Growth of t per step; the number of steps is about log(t / spacing^2) / growth, whatever the shape.
        double growth = 0.1;
    };

    // `style`: `count` >= 2 points, about evenly spaced, not copied: they must live as long as this.
    GuideFlow(const Vec3* style, uint32_t count, const Params& params, Memory* memory);

    // Does about n points' worth of one pass; true when done. About 10 ns a point: 2048 stay below 25 us.
    bool run(uint32_t n);

    // After run() returned true: `count` points, and the steps taken (all of them, those beyond the chosen time too).
    const Vec3* guide() const { return result_; }
    uint32_t steps() const { return steps_; }
    // The time at which guide() was taken, squared metres, and the length then.
    double time() const { return result_time_; }
    double length() const { return result_length_; }

private:
    enum class Phase : uint8_t { load, measure, limit, forward, backward, respace, save, done };

    void load(uint32_t end);
    void measure(uint32_t end);
    void limit(uint32_t end);
    void forward(uint32_t end);
    void backward(uint32_t end);
    void respace(uint32_t end);
    void save(uint32_t end);
    void enter(Phase phase);
    void restart(double time);
    void measured();
    void limited();
    void begin_step();
    void finish(const std::pmr::vector<Vec3>& points, double time, double length);

    const Vec3* style_;
    uint32_t count_;
    Params params_;
    Phase phase_ = Phase::load;
    uint32_t index_ = 0;

    std::pmr::vector<Vec3> points_;  // the curve now; between backward and respace the moved, not yet respaced one
    std::pmr::vector<Vec3> other_;   // right-hand side of the solve, then the respaced points
    std::pmr::vector<Vec3> saved_;   // the curve in the valley
    Buffer<double> bend_;            // kappa * spacing, then 1 - w
    Buffer<double> factor_;          // of the tridiagonal solve, then arc lengths

    uint32_t steps_ = 0;
    double end_time_ = 0.0;  // 0 while the time is still to be chosen
    double time_ = 0.0;
    double step_time_ = 0.0;
    double length_ = 0.0;
    double sum_bend_sq_ = 0.0;
    double sum_force_ = 0.0;
    double critical_bend_ = 0.0;  // kappa_c * spacing
    double force_ = 0.0;          // F / spacing
    uint32_t limit_passes_ = 0;
    uint32_t segment_ = 0;  // where respacing stands on the moved curve

    // The valley of t * mean(kappa^2).
    double low_ = 0.0;
    double peak_ = 0.0;
    double saved_time_ = 0.0;
    double saved_length_ = 0.0;
    bool rising_ = false;

    const Vec3* result_ = nullptr;
    double result_time_ = 0.0;
    double result_length_ = 0.0;
};

}  // namespace flg
