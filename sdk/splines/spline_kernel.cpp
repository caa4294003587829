// SPDX-License-Identifier: MIT
// The course of the optimization; what is done at one node is in spline_kernel_nodes.cpp.
#include "splines/spline_kernel.h"

#include <cmath>

#include "splines/footpoint_cone.h"

namespace flg {

namespace {

constexpr double armijo = 1e-4;        // the share of what the slope promises that a step must bring
constexpr uint32_t max_shrinks = 40;   // of one step
constexpr double tension_fall = 0.25;  // a round
constexpr double heavy_change = 0.02;  // of a segment's share of the length, until parameters are measured again
constexpr uint32_t max_reparametrizations = 6;
constexpr double settled_residual = 0.05;  // when lengths are looked at for the first time
constexpr double least_share = 0.1;        // of concave curvature, before there is none
constexpr double epsilon = 0x1p-52;

uint32_t block_size(const SplineProblem& problem) {
    return (problem.bending > 0 ? problem.manifold->ambient() : 0) + problem.manifold->dimension();
}

uint32_t count_nodes(const SplineProblem& problem) {
    return static_cast<uint32_t>(problem.points.size() / problem.manifold->ambient());
}

}  // namespace

SplineKernel::SplineKernel(SplineProblem& problem, Memory* memory)
    : problem_(problem),
      memory_(memory),
      n_(problem.manifold->ambient()),
      k_(problem.manifold->dimension()),
      nodes_(count_nodes(problem)),
      memory_size_(problem.manifold->memory_size()),
      moments_(nodes_, n_, problem.closed, memory),
      last_(size_t{nodes_} * n_, memory),
      difference_(size_t{nodes_} * n_, memory),
      moment_(size_t{nodes_} * n_, memory),
      gradient_(size_t{nodes_} * n_, memory),
      basis_(size_t{nodes_} * n_ * k_, memory),
      form_(size_t{nodes_} * k_ * k_, memory),
      shift_(size_t{nodes_} * k_, memory),
      knot_of_(nodes_, memory),
      lengths_(problem.knots.size(), memory),
      spans_(problem.knots.size(), memory),
      system_(nodes_, block_size(problem), problem.closed, memory) {
    now_.points = std::move(problem.points);
    remembers_ = memory_size_ > 0 && problem.memory.size() == size_t{nodes_} * memory_size_;
    now_.memory = remembers_ ? std::move(problem.memory) : Buffer<double>(size_t{nodes_} * memory_size_, memory);
    trial_.points = Buffer<double>(size_t{nodes_} * n_, memory);
    trial_.memory = Buffer<double>(size_t{nodes_} * memory_size_, memory);
    tension_ = std::max(problem.tension, problem.first_tension);
    pull_ = problem.smoothing > 0 ? 1 / problem.smoothing : 0;
    enter(Pass::project_first, nodes_);
}

bool SplineKernel::run(uint32_t count) {
    units_ = count;
    while (units_ > 0 && pass_ != Pass::done) step();
    return pass_ == Pass::done;
}

void SplineKernel::enter(Pass pass, uint32_t end) {
    pass_ = pass;
    at_ = 0;
    end_ = end;
}

// One node of the pass, or its end.
void SplineKernel::step() {
    if (at_ == end_) return leave();
    const uint32_t i = at_++, area = system_.size() * system_.size();
    switch (pass_) {
        case Pass::project_first: charge(80); return project_first(i);
        case Pass::measure_lengths: charge(1); return measure_length(i);
        case Pass::set_steps: charge(1); return set_step(i);
        case Pass::factorize: charge(1); return moments_.measure(i);
        case Pass::solve: charge(1); return moments_.solve(i, measured_points());
        case Pass::moments: charge(1); return moments_.moment(i, &moment_[size_t{i} * n_]);
        case Pass::collect: charge(1); return collect(i);
        case Pass::gradient: charge(1); return find_gradient(i);
        case Pass::frames: charge(40); return find_frame(i);
        case Pass::eliminate_free: charge(10 + area * system_.size() / 5); return eliminate(*free_system_, i, true);
        case Pass::substitute_free: charge(10); return substitute_free(i);
        case Pass::subtract:
            charge(1);
            for (uint32_t c = i * n_; c < (i + 1) * n_; ++c) difference_[c] = last_[c] - now_.points[c];
            return;
        case Pass::subtract_tangent:
            charge(1);
            for (uint32_t a = 0; a < k_; ++a) {
                for (uint32_t c = 0; c < n_; ++c)
                    difference_[i * n_ + c] -= shift_[i * k_ + a] * basis_of(i)[a * n_ + c];
            }
            return;
        case Pass::eliminate: charge(2 + area * system_.size() / 40); return eliminate(system_, i, false);
        case Pass::substitute: charge(1 + area / 15); return substitute(i);
        case Pass::move: charge(80); return move(i);
        case Pass::done: return;
    }
}

void SplineKernel::leave() {
    switch (pass_) {
        case Pass::project_first:
            if (!projects_) return finish(SplineEnding::failed);
            report_.length = 0;
            return enter(Pass::measure_lengths, nodes_);
        case Pass::measure_lengths: span_ = 0; return enter(Pass::set_steps, problem_.closed ? nodes_ : nodes_ - 1);
        case Pass::set_steps: return enter(Pass::factorize, bends() ? moments_.measure_count() : 0);
        case Pass::factorize: return begin_measuring(Measured::now);
        case Pass::solve: return enter(Pass::moments, nodes_);
        case Pass::moments: return enter(Pass::collect, nodes_);
        case Pass::collect: return after_collecting();
        case Pass::gradient:
            tangential_ = change_ = 0;
            free_nodes_ = 0;
            return enter(Pass::frames, nodes_);
        case Pass::frames: return after_frames();
        case Pass::eliminate_free: return enter(Pass::substitute_free, nodes_);
        case Pass::substitute_free:
            least_ = weighted(now_) + slope_;
            has_least_ = true;
            return after_frames();
        case Pass::subtract: return begin_measuring(Measured::from_last);
        case Pass::subtract_tangent: return begin_measuring(Measured::from_tangent);
        case Pass::eliminate: return after_elimination();
        case Pass::substitute: return after_substitution();
        case Pass::move: ++report_.projections; return projects_ ? begin_measuring(Measured::trial) : refuse();
        case Pass::done: return;
    }
}

const double* SplineKernel::measured_points() const {
    if (measured_ == Measured::now) return now_.points.data();
    return measured_ == Measured::trial ? trial_.points.data() : difference_.data();
}

void SplineKernel::begin_measuring(Measured measured) {
    measured_ = measured;
    std::fill_n(sums_, 3, 0.0);
    Curve& curve = measured == Measured::trial ? trial_ : now_;
    const bool whole = measured == Measured::now || measured == Measured::trial;
    if (!problem_.closed && bends()) {
        set_end(false, at(curve, 0), memory_of(curve, 0), whole);
        set_end(true, at(curve, nodes_ - 1), memory_of(curve, nodes_ - 1), whole);
    }
    if (bends()) {
        enter(Pass::solve, moments_.solve_count());
    } else {
        enter(Pass::collect, nodes_);
    }
}

void SplineKernel::after_collecting() {
    if (measured_ == Measured::from_last || measured_ == Measured::from_tangent) {
        const double square = problem_.bending * sums_[0] + tension_ * sums_[1] + pull_ * sums_[2];
        if (measured_ == Measured::from_last) {
            square_last_ = square;
            return enter(Pass::subtract_tangent, nodes_);
        }
        square_tangent_ = square;
        return choose_cone_step();
    }
    Curve& curve = measured_ == Measured::now ? now_ : trial_;
    curve.bending = sums_[0];
    curve.stretching = sums_[1];
    curve.misfit = sums_[2];
    if (measured_ == Measured::now) return begin_gradient();
    if (weighted(trial_) <= weighted(now_) + 2 * armijo * step_ * slope_ + noise()) return accept();
    refuse();
}

// What rounding of the points does to the energy.
double SplineKernel::noise() const {
    return 10 * epsilon * problem_.manifold->size() * forces_;
}

// A round begins: forces and bases are those of the present points.
void SplineKernel::after_frames() {
    const bool of_new_points = pass_ == Pass::frames;
    if (of_new_points) {
        const double density = forces_ / span_;
        const double mean = free_nodes_ > 0 ? std::sqrt(tangential_ / free_nodes_) : 0;
        last_residual_ = report_.residual;
        // The energy of a straight chain whose points are rounded.
        const double rounding = epsilon * problem_.manifold->size(), mean_step = span_ / nodes_;
        const double nothing = 1e3 * nodes_ * rounding * rounding / (mean_step * mean_step * mean_step);
        report_.residual = weighted(now_) > nothing ? mean / density : 0;
        report_.energy = weighted(now_);
        report_.bending = now_.bending;
        report_.stretching = now_.stretching;
        const bool at_end = tension_ == problem_.tension;
        const bool converged = report_.residual <= problem_.tolerance;
        if (at_end && report_.residual <= settled_residual && reparametrize()) return;
        if (at_end && converged) return finish(SplineEnding::converged);
        if (report_.rounds >= problem_.max_rounds) return finish(SplineEnding::rounds);
    }
    if (problem_.method == SplineMethod::footpoint_cone && !has_least_) {
        if (!free_system_) free_system_.emplace(nodes_, (bends() ? n_ : 0) + n_, problem_.closed, memory_);
        return begin_elimination(*free_system_, Pass::eliminate_free);
    }
    begin_elimination(system_, Pass::eliminate);
}

// Blocks that others are subtracted from have to be there before.
void SplineKernel::begin_elimination(BlockTridiagonal& system, Pass pass) {
    slope_ = largest_ = 0;
    assemble(system, 0, pass == Pass::eliminate_free);
    if (problem_.closed) assemble(system, 1, pass == Pass::eliminate_free);
    enter(pass, nodes_);
}

void SplineKernel::eliminate(BlockTridiagonal& system, uint32_t k, bool unrestricted) {
    const uint32_t ahead = problem_.closed ? k + 2 : k + 1;
    if (ahead < nodes_) assemble(system, ahead, unrestricted);
    system.eliminate(k);
}

void SplineKernel::after_elimination() {
    const uint32_t expected = bends() ? n_ * nodes_ : 0;
    const bool indefinite = system_.negative_pivots() != expected || system_.is_singular();
    if (problem_.method == SplineMethod::newton && indefinite && concave_share_ > 0) {
        concave_share_ = concave_share_ > least_share ? 0.5 * concave_share_ : 0;
        return begin_elimination(system_, Pass::eliminate);
    }
    enter(Pass::substitute, nodes_);
}

void SplineKernel::after_substitution() {
    if (!(slope_ < 0) || largest_ <= 4 * epsilon * problem_.manifold->size()) return finish(SplineEnding::rounding);
    shrinks_ = 0;
    if (problem_.method == SplineMethod::footpoint_cone && has_last_) return enter(Pass::subtract, nodes_);
    try_step(1);
}

// Once the last two curves are too near to each other the last curvature is used again.
void SplineKernel::choose_cone_step() {
    const double to_p = weighted(now_) - least_, tangent = -slope_;
    const double step = footpoint_stepsize({.tangent = std::sqrt(tangent),
                                            .height = std::sqrt(std::max(0.0, to_p - tangent)),
                                            .last_to_p = std::sqrt(std::max(0.0, last_energy_ - least_)),
                                            .last_to_current = std::sqrt(square_last_),
                                            .last_to_tangent = std::sqrt(square_tangent_)});
    if (step > 0) cone_step_ = step;
    try_step(cone_step_);
}

void SplineKernel::try_step(double size) {
    step_ = size;
    projects_ = true;
    enter(Pass::move, nodes_);
}

void SplineKernel::refuse() {
    if (++shrinks_ > max_shrinks) return finish(-slope_ < noise() ? SplineEnding::rounding : SplineEnding::stalled);
    try_step(0.5 * step_);
}

void SplineKernel::accept() {
    // What Newton's method promises is below what can be told from rounding, and it no longer gets nearer.
    const bool idle = -slope_ < noise() && report_.residual > 0.5 * last_residual_ && last_residual_ > 0;
    last_energy_ = weighted(now_);
    if (step_ == 1) concave_share_ = std::min(1.0, std::max(2 * concave_share_, least_share));
    std::swap(now_.points, last_);
    std::swap(now_.points, trial_.points);
    std::swap(now_.memory, trial_.memory);
    std::swap(now_.bending, trial_.bending);
    std::swap(now_.stretching, trial_.stretching);
    std::swap(now_.misfit, trial_.misfit);
    has_last_ = true;
    ++report_.rounds;
    if (tension_ > problem_.tension) {
        tension_ *= tension_fall;
        // Where the weight says less than a hundredth of what bending does it is left out.
        if (tension_ * now_.stretching < 0.01 * now_.bending || tension_ < problem_.tension)
            tension_ = problem_.tension;
        has_last_ = has_least_ = false;
    }
    if (idle && tension_ == problem_.tension) return finish(SplineEnding::rounding);
    begin_gradient();
}

void SplineKernel::begin_gradient() {
    forces_ = report_.length = 0;
    enter(Pass::gradient, nodes_);
}

bool SplineKernel::reparametrize() {
    if (problem_.parameters.size() > 0 || reparametrizations_ == max_reparametrizations || change_ <= heavy_change) {
        return false;
    }
    ++reparametrizations_;
    has_last_ = has_least_ = false;
    span_ = 0;
    enter(Pass::set_steps, problem_.closed ? nodes_ : nodes_ - 1);
    return true;
}

void SplineKernel::finish(SplineEnding ending) {
    report_.ending = ending;
    enter(Pass::done, 0);
}

}  // namespace flg
