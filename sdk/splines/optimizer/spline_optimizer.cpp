// SPDX-License-Identifier: MIT
#include "splines/optimizer/spline_optimizer.h"

#include <array>
#include <cmath>

#include "splines/manifolds/coordinates.h"

namespace flg {

namespace {

using Vector = double[Manifold::max_ambient];

constexpr double armijo = 1e-4;        // the share of what the slope promises that a step must bring
constexpr uint32_t max_shrinks = 40;   // of one step
constexpr double tension_fall = 0.25;  // a round
constexpr double heavy_change = 0.02;  // of a segment's share of the length, until parameters are measured again
constexpr uint32_t max_reparametrizations = 6;
constexpr double settled_residual = 0.05;  // when lengths are looked at for the first time
// After so many steps that lead nowhere the surface is probed by one of 2^-10: what is off by more than this share of
// it has jumped.
constexpr uint32_t probed_shrinks = 3;
constexpr double probe_step = 0x1p-10, jump = 0.5;
constexpr double min_share = 0.1;  // of concave curvature, before there is none
constexpr double epsilon = 0x1p-52;
// About 4 us on slow manifolds, and 2.
constexpr uint32_t projection_work = 3, frame_work = 2;

constexpr uint32_t max_presses = 12;   // solves of a round until it is known which nodes the border keeps
constexpr uint32_t tried_shrinks = 6;  // of that step, before only those are pressed that are at the border
constexpr double least_force = 1e-9;   // of the mean one: less is none

uint32_t block_size(const SplineProblem& problem) {
    return (problem.bending > 0 ? problem.manifold->ambient() : 0) + problem.manifold->dimension();
}

uint32_t count_nodes(const SplineProblem& problem) {
    return static_cast<uint32_t>(problem.points.size() / problem.manifold->ambient());
}

// Makes a symmetric matrix more positive: negative eigenvalues become a share of themselves, 0 to 1. k x k numbers, in
// place; k at most Manifold::max_dimension. By Jacobi's rotations: some k^3 multiplications, ten times.
void scale_negative_part(double* matrix, uint32_t k, double share) {
    constexpr uint32_t rounds = 12;
    constexpr double negligible = 1e-14;  // of the whole, squared below
    double axes[Manifold::max_dimension * Manifold::max_dimension] = {};
    for (uint32_t i = 0; i < k; ++i) axes[i * k + i] = 1;
    for (uint32_t round = 0; round < rounds; ++round) {
        double off = 0, whole = 0;
        for (uint32_t i = 0; i < k; ++i) {
            for (uint32_t j = 0; j < k; ++j) (i == j ? whole : off) += matrix[i * k + j] * matrix[i * k + j];
        }
        if (off <= negligible * negligible * whole) break;
        for (uint32_t p = 0; p < k; ++p) {
            for (uint32_t q = p + 1; q < k; ++q) {
                if (matrix[p * k + q] == 0) continue;
                const double slope = (matrix[q * k + q] - matrix[p * k + p]) / (2 * matrix[p * k + q]);
                const double t = (slope < 0 ? -1 : 1) / (std::abs(slope) + std::hypot(slope, 1.0));
                const double cosine = 1 / std::hypot(t, 1.0), sine = t * cosine;
                for (uint32_t i = 0; i < k; ++i) {
                    const double a = matrix[i * k + p], b = matrix[i * k + q];
                    matrix[i * k + p] = cosine * a - sine * b;
                    matrix[i * k + q] = sine * a + cosine * b;
                    const double u = axes[i * k + p], v = axes[i * k + q];
                    axes[i * k + p] = cosine * u - sine * v;
                    axes[i * k + q] = sine * u + cosine * v;
                }
                for (uint32_t i = 0; i < k; ++i) {
                    const double a = matrix[p * k + i], b = matrix[q * k + i];
                    matrix[p * k + i] = cosine * a - sine * b;
                    matrix[q * k + i] = sine * a + cosine * b;
                }
            }
        }
    }
    double values[Manifold::max_dimension];
    for (uint32_t i = 0; i < k; ++i) values[i] = (matrix[i * k + i] > 0 ? 1 : share) * matrix[i * k + i];
    for (uint32_t i = 0; i < k; ++i) {
        for (uint32_t j = 0; j < k; ++j) {
            double sum = 0;
            for (uint32_t e = 0; e < k; ++e) sum += axes[i * k + e] * values[e] * axes[j * k + e];
            matrix[i * k + j] = sum;
        }
    }
}

}  // namespace

SplineOptimizer::SplineOptimizer(SplineProblem& problem, Memory* memory)
    : problem_(problem),
      n_(problem.manifold->ambient()),
      k_(problem.manifold->dimension()),
      nodes_(count_nodes(problem)),
      hint_size_(problem.manifold->hint_size()),
      moments_(nodes_, n_, problem.closed, problem.bending > 0 ? problem.tension : 0, memory),
      moment_(size_t{nodes_} * n_, memory),
      gradient_(nodes_, n_, memory),
      basis_(nodes_, size_t{n_} * k_, memory),
      form_(nodes_, size_t{k_} * k_, memory),
      shift_(nodes_, k_, memory),
      knot_of_(nodes_, memory),
      is_held_(nodes_, memory),
      walls_(*problem.manifold, problem.border, problem.within, nodes_, memory),
      base_(problem.border ? size_t{nodes_} * n_ : 0, memory),
      lengths_(problem.knots.size(), memory),
      spans_(problem.knots.size(), memory),
      system_(nodes_, block_size(problem), problem.closed, memory) {
    std::fill(is_held_.begin(), is_held_.end(), uint8_t{0});
    now_.points = std::move(problem.points);
    remembers_ = hint_size_ > 0 && problem.hints.size() == size_t{nodes_} * hint_size_;
    now_.hints = remembers_ ? std::move(problem.hints) : Buffer<double>(size_t{nodes_} * hint_size_, memory);
    trial_.points = Buffer<double>(size_t{nodes_} * n_, memory);
    trial_.hints = Buffer<double>(size_t{nodes_} * hint_size_, memory);
    tension_ = std::max(problem.tension, problem.first_tension);
    pull_ = problem.smoothing > 0 ? 1 / problem.smoothing : 0;
    if (problem.softness.size() > 0) {
        pull_shares_ = Buffer<double>(problem.softness.size(), memory);
        pull_ = 0;
    }
    if (problem.tensions.size() > 0) moments_.tension_shares() = Buffer<double>(nodes_, memory);
}

Task<void> SplineOptimizer::minimize(Pace& pace, SplineOptimizer& s) {
    for (bool goes_on = true; goes_on;) goes_on = co_await next_round(pace, s);
}

Task<void> SplineOptimizer::give_back(Pace& pace, SplineOptimizer& s) {
    std::array<RowBlocks<double>*, 10> parts{&s.gradient_, &s.basis_, &s.form_, &s.shift_, &s.moments_.inner()};
    size_t count = 5;
    s.system_.each_part([&](RowBlocks<double>& rows) { parts[count++] = &rows; });
    // The last first: allocators that grow a heap shrink it from its end, and else all at once.
    for (RowBlocks<double>* const rows : parts) {
        const size_t blocks = rows->block_count();
        co_await each(pace, blocks, Cost::microseconds,
                      [rows, blocks](uint32_t k) { rows->give_back(blocks - 1 - k); });
    }
    for (Buffer<double>* const buffer : {&s.trial_.points, &s.moment_, &s.trial_.hints, &s.base_}) {
        *buffer = Buffer<double>();
        co_await pace;
    }
}

Task<bool> SplineOptimizer::next_round(Pace& pace, SplineOptimizer& s) {
    if (!s.has_begun_) co_await begin(pace, s);
    if (s.report_.ending != SplineEnding::running) co_return false;
    for (;;) {
        co_await find_forces(pace, s);
        s.assess();
        if (!s.needs_parameters()) break;
        ++s.reparametrizations_;
        co_await set_parameters(pace, s);
    }
    if (s.is_over()) co_return false;
    co_await solve(pace, s);
    for (uint32_t turn = 0; s.has_border() && turn < max_presses; ++turn) {
        const bool changed = co_await press(pace, s);
        if (!changed) break;
        co_await solve(pace, s);
    }
    bool is_as_begun = !s.has_border();
    if (!is_as_begun && !(s.slope_ < 0)) {
        co_await press_as_begun(pace, s);
        is_as_begun = true;
    }
    if (!(s.slope_ < 0) || s.largest_ <= 4 * epsilon * s.problem_.manifold->size()) {
        s.report_.ending = SplineEnding::rounding;
        co_return false;
    }
    s.step_ = 1;
    for (uint32_t shrinks = 1;; ++shrinks, s.step_ *= 0.5) {
        const bool leads_down = co_await try_step(pace, s);
        if (leads_down) break;
        if (shrinks == probed_shrinks && s.problem_.holds_nodes) {
            const uint32_t held = s.report_.held;
            co_await hold_jumping(pace, s);
            if (s.report_.held > held) {
                if (s.report_.held > s.max_held()) s.report_.ending = SplineEnding::stalled;
                co_await measure(pace, s, s.now_);
                co_return s.report_.ending == SplineEnding::running;
            }
        }
        if (shrinks == tried_shrinks && !is_as_begun) {
            co_await press_as_begun(pace, s);
            is_as_begun = true;
            s.step_ = 2;
        }
        if (shrinks <= max_shrinks) continue;
        s.report_.ending = -s.slope_ < s.noise() ? SplineEnding::rounding : SplineEnding::stalled;
        co_return false;
    }
    co_return s.accept();
}

// Newton's step, with less of what is concave until it is a minimum's.
Task<void> SplineOptimizer::solve(Pace& pace, SplineOptimizer& s) {
    if (s.has_border()) co_await each(pace, s.nodes_, Cost::tens_of_ns, [&s](uint32_t node) { s.find_base(node); });
    for (;;) {
        co_await eliminate(pace, s);
        if (!s.is_indefinite() || !(s.concave_share_ > 0)) break;
        s.concave_share_ = s.concave_share_ > min_share ? 0.5 * s.concave_share_ : 0;
    }
    co_await substitute(pace, s);
}

// Presses nodes that the step would take over the border, and lets those go that it would take inwards if they could.
// Whether there are any.
Task<bool> SplineOptimizer::press(Pace& pace, SplineOptimizer& s) {
    bool changed = false;
    // Forces look at the shifts of neighbours, which stay until the next solve.
    co_await each(pace, s.nodes_, Cost::tens_of_ns, [&s, &changed](uint32_t node) {
        if (s.press_node(node)) changed = true;
    });
    co_return changed;
}

// The step with those pressed that are at the border: it leads down, if not far.
Task<void> SplineOptimizer::press_as_begun(Pace& pace, SplineOptimizer& s) {
    co_await each(pace, s.nodes_, Cost::some_ns,
                  [&s](uint32_t node) { s.walls_[node].pressed = s.walls_[node].began; });
    co_await solve(pace, s);
}

// Holds the nodes that a hair's step puts elsewhere than a hair away, or nowhere: there the surface has an edge or a
// gap, and no step of the whole curve, however short, would lead down.
Task<void> SplineOptimizer::hold_jumping(Pace& pace, SplineOptimizer& s) {
    const double step = std::exchange(s.step_, probe_step), rounding = 1e3 * epsilon * s.problem_.manifold->size();
    co_await each_by_work(pace, s.nodes_, Cost::microseconds, [&s, rounding](uint32_t node) {
        if (!s.is_free(node)) return 1u;
        s.projects_ = true;
        s.move(node);
        double off = 0, along = 0;
        for (uint32_t c = 0; c < s.n_; ++c) {
            double wanted = 0;
            for (uint32_t a = 0; a < s.k_; ++a) wanted += s.step_ * s.shift_[node][a] * s.basis_of(node)[a * s.n_ + c];
            const double error = s.at(s.trial_, node)[c] - s.at(s.now_, node)[c] - wanted;
            off += error * error;
            along += wanted * wanted;
        }
        if (s.projects_ && std::sqrt(off) <= jump * std::sqrt(along) + rounding) return projection_work;
        s.is_held_[node] = 1;
        ++s.report_.held;
        return projection_work;
    });
    s.step_ = step;
}

Task<void> SplineOptimizer::begin(Pace& pace, SplineOptimizer& s) {
    s.has_begun_ = true;
    const Buffer<double>& softness = s.problem_.softness;
    co_await each(pace, softness.size(), Cost::some_ns, [&](uint32_t k) {
        if (softness[k] > 0) s.pull_ = std::max(s.pull_, 1 / softness[k]);
    });
    co_await each(pace, softness.size(), Cost::some_ns,
                  [&](uint32_t k) { s.pull_shares_[k] = softness[k] > 0 ? 1 / softness[k] / s.pull_ : 0; });
    co_await each_by_work(pace, s.nodes_, Cost::microseconds, [&s](uint32_t node) {
        s.project_first(node);
        return projection_work;
    });
    if (!s.projects_) {
        s.report_.ending = SplineEnding::failed;
        co_return;
    }
    s.report_.length = 0;
    co_await each(pace, s.nodes_, Cost::tens_of_ns, [&s](uint32_t node) { s.measure_length(node); });
    co_await set_parameters(pace, s);
}

// From the lengths of segments, unless they are given.
Task<void> SplineOptimizer::set_parameters(Pace& pace, SplineOptimizer& s) {
    s.span_ = 0;
    co_await each(pace, s.problem_.closed ? s.nodes_ : s.nodes_ - 1, Cost::tens_of_ns,
                  [&s](uint32_t i) { s.set_step(i); });
    if (s.bends()) co_await Moments::factorize(pace, s.moments_);
    co_await measure(pace, s, s.now_);
}

// The curve's moments and energies.
Task<void> SplineOptimizer::measure(Pace& pace, SplineOptimizer& s, Curve& curve) {
    if (s.bends()) {
        if (!s.problem_.closed) {
            s.set_end(false, curve);
            s.set_end(true, curve);
        }
        co_await Moments::solve(pace, s.moments_, curve.points.data(), s.moment_.data());
    }
    curve.bending = curve.stretching = curve.tensed = curve.misfit = 0;
    co_await each(pace, s.nodes_, Cost::tens_of_ns, [&s, &curve](uint32_t node) { s.add_energy(curve, node); });
}

// Forces, bases and curvatures at the present points.
Task<void> SplineOptimizer::find_forces(Pace& pace, SplineOptimizer& s) {
    s.forces_ = s.report_.length = 0;
    co_await each(pace, s.nodes_, Cost::tens_of_ns, [&s](uint32_t node) { s.find_gradient(node); });
    s.tangential_ = s.change_ = 0;
    s.free_nodes_ = s.report_.pressed = 0;
    co_await each_by_work(pace, s.nodes_, Cost::microseconds, [&s](uint32_t node) {
        s.find_frame(node);
        return frame_work;
    });
}

void SplineOptimizer::assess() {
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
}

bool SplineOptimizer::needs_parameters() const {
    return tension_ == problem_.tension && report_.residual <= settled_residual && problem_.parameters.size() == 0 &&
           reparametrizations_ < max_reparametrizations && change_ > heavy_change;
}

bool SplineOptimizer::is_over() {
    if (tension_ == problem_.tension && report_.residual <= problem_.tolerance) {
        report_.ending = SplineEnding::converged;
    } else if (report_.rounds >= problem_.max_rounds || report_.rounds + report_.projections >= problem_.max_work) {
        report_.ending = SplineEnding::rounds;
    }
    return report_.ending != SplineEnding::running;
}

// Blocks that others are subtracted from have to be there before.
Task<void> SplineOptimizer::eliminate(Pace& pace, SplineOptimizer& s) {
    const uint32_t ahead = s.problem_.closed ? 2 : 1, size = s.system_.size();
    for (uint32_t node = 0; node < ahead; ++node) s.assemble(node);
    co_await each_by_work(pace, s.nodes_, Cost::hundreds_of_ns, [&s, ahead, size](uint32_t k) {
        if (k + ahead < s.nodes_) s.assemble(k + ahead);
        s.system_.eliminate(k);
        return 1 + size * size * size / 200;
    });
}

bool SplineOptimizer::is_indefinite() const {
    const uint32_t expected = bends() ? n_ * nodes_ : 0;
    return system_.negative_pivots() != expected || system_.is_singular();
}

Task<void> SplineOptimizer::substitute(Pace& pace, SplineOptimizer& s) {
    s.slope_ = s.largest_ = 0;
    const uint32_t size = s.system_.size();
    co_await each_by_work(pace, s.nodes_, Cost::hundreds_of_ns, [&s, size](uint32_t k) {
        s.system_.substitute(k);
        s.find_shift(s.problem_.closed ? (s.nodes_ - k) % s.nodes_ : s.nodes_ - 1 - k);
        return 1 + size * size / 100;
    });
}

// Whether the step, projected, leads down by Armijo's rule.
Task<bool> SplineOptimizer::try_step(Pace& pace, SplineOptimizer& s) {
    s.projects_ = true;
    co_await each_by_work(pace, s.nodes_, Cost::microseconds, [&s](uint32_t node) {
        s.move(node);
        return projection_work;
    });
    ++s.report_.projections;
    if (!s.projects_) co_return false;
    co_await measure(pace, s, s.trial_);
    co_return s.weighted(s.trial_) <= s.weighted(s.now_) + 2 * armijo* s.step_* s.slope_ + s.noise();
}

// What rounding of the points does to the energy.
double SplineOptimizer::noise() const {
    return 10 * epsilon * problem_.manifold->size() * forces_;
}

// False where it ends with that.
bool SplineOptimizer::accept() {
    // What Newton's method promises is below what can be told from rounding, and it no longer gets nearer.
    const bool idle = -slope_ < noise() && report_.residual > 0.5 * last_residual_ && last_residual_ > 0;
    if (step_ == 1) concave_share_ = std::min(1.0, std::max(2 * concave_share_, min_share));
    std::swap(now_, trial_);
    ++report_.rounds;
    if (tension_ > problem_.tension) {
        tension_ *= tension_fall;
        // Where the weight says less than a hundredth of what bending does it is left out.
        if (tension_ * now_.stretching < 0.01 * now_.bending || tension_ < problem_.tension)
            tension_ = problem_.tension;
    }
    if (idle && tension_ == problem_.tension) report_.ending = SplineEnding::rounding;
    return report_.ending == SplineEnding::running;
}

// Given points are where they were given, to the bit: they are on the manifold, but a projection may round.
void SplineOptimizer::project_first(uint32_t node) {
    if (!remembers_) std::fill_n(hint_of(now_, node), hint_size_, 0.0);
    knot_of_[node] = no_knot;
    if (next_knot_ < problem_.knots.size() && problem_.knots[next_knot_] == node) knot_of_[node] = next_knot_++;
    if (moments_.tension_shares().size() > 0) {
        const size_t segment = std::min<size_t>(next_knot_, problem_.tensions.size());
        moments_.tension_shares()[node] = problem_.tensions[segment - 1];
    }
    double* const x = at(now_, node);
    if (!is_free(node)) std::copy_n(&problem_.given[size_t{knot_of_[node]} * n_], n_, x);
    const bool is_on = problem_.manifold->project(x, hint_of(now_, node));
    if (!is_on || (is_free(node) && !walls_.confine(x, hint_of(now_, node), nullptr))) {
        if (projects_) report_.failed_node = node;
        projects_ = false;
    }
    if (!is_free(node)) std::copy_n(&problem_.given[size_t{knot_of_[node]} * n_], n_, x);
}

uint32_t SplineOptimizer::intervals_of(uint32_t knot) const {
    const uint32_t end = knot + 1 < problem_.knots.size() ? problem_.knots[knot + 1] : nodes_;
    return end - problem_.knots[knot];
}

void SplineOptimizer::measure_length(uint32_t node) {
    if (knot_of_[node] != no_knot) {
        segment_ = knot_of_[node];
        lengths_[segment_] = 0;
    }
    if (!has_next(node)) return;
    const double length = distance_between(at(now_, node), at(now_, next(node)), n_);
    lengths_[segment_] += length;
    report_.length += length;
}

// Steps between two given points are equal, or the problem's shares.
void SplineOptimizer::set_step(uint32_t interval) {
    if (knot_of_[interval] != no_knot) {
        segment_ = knot_of_[interval];
        spans_[segment_] = problem_.parameters.size() > 0
                               ? problem_.parameters[segment_ + 1] - problem_.parameters[segment_]
                               : std::max(lengths_[segment_], 1e-9 * report_.length);
        span_ += spans_[segment_];
    }
    moments_.steps()[interval] = problem_.shares.empty() ? spans_[segment_] / intervals_of(segment_)
                                                         : spans_[segment_] * problem_.shares[interval];
}

void SplineOptimizer::set_end(bool last, Curve& curve) {
    SplineEnd& end = moments_.end(last);
    const bool prescribed = problem_.has_slope[last];
    std::fill_n(end.slope, n_, 0.0);
    std::fill_n(end.normals, n_ * n_, 0.0);
    for (uint32_t c = 0; c < n_; ++c) end.normals[c * n_ + c] = 1;
    if (prescribed) {
        std::copy_n(problem_.slopes[last], n_, end.slope);
        return;
    }
    // An end that moves would turn these directions, which the gradient does not know of: natural in all of them.
    const uint32_t node = last ? nodes_ - 1 : 0;
    if (pull_at(node) > 0) {
        std::fill_n(end.normals, n_ * n_, 0.0);
        return;
    }
    double basis[Manifold::max_dimension * Manifold::max_ambient];
    problem_.manifold->tangent_basis(at(curve, node), hint_of(curve, node), basis);
    for (uint32_t a = 0; a < k_; ++a) {
        for (uint32_t r = 0; r < n_; ++r) {
            for (uint32_t c = 0; c < n_; ++c) end.normals[r * n_ + c] -= basis[a * n_ + r] * basis[a * n_ + c];
        }
    }
}

// The node's share of E2, of E1 (its interval to the next node), and of the distances to given points.
void SplineOptimizer::add_energy(Curve& curve, uint32_t node) {
    const double* const x = at(curve, node);
    if (bends()) curve.bending += moments_.energy(node, curve.points.data(), &moment_[size_t{node} * n_]);
    if (has_next(node)) {
        const double length = distance_between(x, at(curve, next(node)), n_);
        const double stretching = length * length / moments_.step_after(node);
        curve.stretching += stretching;
        curve.tensed +=
            moments_.tension_shares().size() > 0 ? moments_.tension_shares()[node] * stretching : stretching;
    }
    if (pull_at(node) == 0) return;
    const double off = distance_between(x, &problem_.given[size_t{knot_of_[node]} * n_], n_);
    curve.misfit += pull_shares_.size() > 0 ? pull_shares_[knot_of_[node]] * off * off : off * off;
}

void SplineOptimizer::find_gradient(uint32_t node) {
    measure_length(node);
    double* const g = gradient_.make(node);
    const double* const x = at(now_, node);
    std::fill_n(g, n_, 0.0);
    const auto add = [&](uint32_t other, double step, double tension) {
        const double* const y = at(now_, other);
        for (uint32_t c = 0; c < n_; ++c) g[c] += tension / step * (x[c] - y[c]);
        if (!bends()) return;
        const double* const own = &moment_[size_t{node} * n_];
        const double* const its = &moment_[size_t{other} * n_];
        for (uint32_t c = 0; c < n_; ++c) g[c] += (its[c] - own[c]) / step;
    };
    if (has_next(node)) add(next(node), moments_.step_after(node), tension_after(node));
    if (has_previous(node)) add(previous(node), moments_.step_before(node), tension_after(previous(node)));
    forces_ += std::sqrt(inner_product(g, g, n_));
    if (const double pull = pull_at(node); pull > 0) {
        const double* const given = &problem_.given[size_t{knot_of_[node]} * n_];
        for (uint32_t c = 0; c < n_; ++c) g[c] += pull * (x[c] - given[c]);
    }
}

void SplineOptimizer::find_frame(uint32_t node) {
    if (knot_of_[node] != no_knot && has_next(node)) {
        const uint32_t s = knot_of_[node];
        change_ = std::max(change_, std::abs(lengths_[s] / report_.length * span_ / spans_[s] - 1));
    }
    double* const basis = basis_.make(node);
    const double* const g = gradient_[node];
    problem_.manifold->tangent_basis(at(now_, node), hint_of(now_, node), basis);
    if (has_border()) find_wall(node);
    if (!is_free(node)) return;
    const double width = 0.5 * ((has_previous(node) ? moments_.step_before(node) : 0) +
                                (has_next(node) ? moments_.step_after(node) : 0));
    for (uint32_t a = 0; a < k_; ++a) {
        if (!is_free(node, a)) continue;
        const double along = inner_product(g, basis + a * n_, n_) / width;
        tangential_ += along * along;
    }
    ++free_nodes_;
    double* const form = form_.make(node);
    problem_.manifold->second_form(at(now_, node), hint_of(now_, node), basis, g, form);
    if (has_border() && walls_[node].pressed == 1) form[0] += walls_[node].curvature * inner_product(g, basis + n_, n_);
}

void SplineOptimizer::find_wall(uint32_t node) {
    walls_[node] = {};
    if (!is_free(node)) return;
    walls_.find(node, at(now_, node), gradient_[node], basis_[node]);
    if (walls_[node].pressed != 0) ++report_.pressed;
}

void SplineOptimizer::find_base(uint32_t node) {
    const double push = walls_.push(node);
    const double* const x = at(now_, node);
    double* const base = &base_[size_t{node} * n_];
    std::copy_n(x, n_, base);
    for (uint32_t c = 0; push != 0 && c < n_; ++c) base[c] += push * basis_of(node)[n_ + c];
}

// Whether it is pressed or let go.
bool SplineOptimizer::press_node(uint32_t node) {
    BorderWalls::Wall& wall = walls_[node];
    if (!is_free(node) || !wall.is_near || wall.pressed == 2) return false;
    if (wall.pressed == 0) {
        if (!walls_.is_passed(node, shift_[node][1])) return false;
        wall.pressed = 1;
        return true;
    }
    // The force that is left once all have moved.
    const double* const inwards = basis_of(node) + n_;
    double force = 0;
    const double pull = pull_at(node);
    const auto moved = [&](uint32_t of, uint32_t c) {
        const double* const shift = shift_[of];
        return at(now_, of)[c] + shift[0] * basis_of(of)[c] + shift[1] * basis_of(of)[n_ + c];
    };
    const auto add = [&](uint32_t other, double step, double tension) {
        const double *const own = system_.solution(node), *const its = system_.solution(other);
        for (uint32_t c = 0; c < n_; ++c) {
            force += tension / step * inwards[c] * (moved(node, c) - moved(other, c));
            if (bends()) force += inwards[c] * (its[c] - own[c]) / step;
        }
    };
    if (has_next(node)) add(next(node), moments_.step_after(node), tension_after(node));
    if (has_previous(node)) add(previous(node), moments_.step_before(node), tension_after(previous(node)));
    if (pull > 0) {
        const double* const given = &problem_.given[size_t{knot_of_[node]} * n_];
        for (uint32_t c = 0; c < n_; ++c) force += pull * inwards[c] * (moved(node, c) - given[c]);
    }
    force += form_[node][2] * shift_[node][0] + form_[node][3] * shift_[node][1];
    if (force >= -least_force * forces_ / nodes_) return false;
    wall.pressed = 0;
    return true;
}

// Of what bending does not say, at the base.
double SplineOptimizer::force_along(uint32_t node, uint32_t a, const double* direction) const {
    const double* const x = &base_[size_t{node} * n_];
    double force = walls_.push(node) * form_[node][a * k_ + 1];
    const auto add = [&](uint32_t other, double weight) {
        const double* const y = &base_[size_t{other} * n_];
        for (uint32_t c = 0; c < n_; ++c) force += weight * direction[c] * (x[c] - y[c]);
    };
    if (has_next(node)) add(next(node), tension_after(node) / moments_.step_after(node));
    if (has_previous(node)) add(previous(node), tension_after(previous(node)) / moments_.step_before(node));
    if (const double pull = pull_at(node); pull > 0) {
        const double* const given = &problem_.given[size_t{knot_of_[node]} * n_];
        for (uint32_t c = 0; c < n_; ++c) force += pull * direction[c] * (x[c] - given[c]);
    }
    return force;
}

// Moments at the ends of an open curve have only the parts that Moments gives them.
void SplineOptimizer::restrict_moment(uint32_t node, double* vector) const {
    if (problem_.closed || (node > 0 && node + 1 < nodes_)) return;
    const double* const normals = moments_.end(node > 0).normals;
    Vector out;
    for (uint32_t r = 0; r < n_; ++r) out[r] = inner_product(normals + r * n_, vector, n_);
    std::copy_n(out, n_, vector);
}

// A node's rows of
//     [ -R     Q^T B ] [ M ]   [ -Q^T x                           ]
//     [ B^T Q  W + H ] [ v ] = [ -B^T (E1's and the pull's force) ]
// M: moments of the displaced points x + B v; W: E1 and the pull in the basis; H: the surface's curvature times the
// force.
void SplineOptimizer::assemble(uint32_t node) {
    const uint32_t moments = bends() ? n_ : 0, b = system_.size();
    double* const diagonal = system_.diagonal(node);
    double* const coupling = system_.coupling(node);
    double* const right = system_.right_side(node);
    std::fill_n(diagonal, b * b, 0.0);
    std::fill_n(coupling, b * b, 0.0);
    std::fill_n(right, b, 0.0);
    const double before = has_previous(node) ? moments_.step_before(node) : 0;
    const double after = has_next(node) ? moments_.step_after(node) : 0;
    const double stiffness = (before > 0 ? 1 / before : 0) + (after > 0 ? 1 / after : 0);
    const auto direction = [&](uint32_t of, uint32_t a, double* out) { std::copy_n(basis_of(of) + a * n_, n_, out); };
    Vector own, its;
    for (uint32_t c = 0; c < moments; ++c) diagonal[c * b + c] = -moments_.row(node);
    if (bends()) {
        moments_.bend(node, has_border() ? base_.data() : now_.points.data(), own);
        restrict_moment(node, own);
        for (uint32_t c = 0; c < n_; ++c) right[c] = -own[c];
    }
    const bool free = is_free(node);
    const double pull = pull_at(node);
    double taut = tension_ * stiffness;
    if (moments_.tension_shares().size() > 0) {
        taut =
            (before > 0 ? tension_after(previous(node)) / before : 0) + (after > 0 ? tension_after(node) / after : 0);
    }
    double form[Manifold::max_dimension * Manifold::max_dimension];
    if (free) {
        std::copy_n(form_[node], k_ * k_, form);
        if (concave_share_ < 1) scale_negative_part(form, k_, concave_share_);
    }
    for (uint32_t a = 0; a < k_; ++a) {
        double* const row = diagonal + (moments + a) * b;
        row[moments + a] = is_free(node, a) ? taut + pull : 1;
        if (!is_free(node, a)) continue;
        direction(node, a, own);
        // What bending does not say is the rest of the gradient.
        const double* const g = gradient_[node];
        double force = has_border() ? force_along(node, a, own) : inner_product(g, own, n_);
        if (bends() && !has_border()) {
            const double* const m = &moment_[size_t{node} * n_];
            if (after > 0)
                force -=
                    (inner_product(&moment_[size_t{next(node)} * n_], own, n_) - inner_product(m, own, n_)) / after;
            if (before > 0)
                force -= (inner_product(&moment_[size_t{previous(node)} * n_], own, n_) - inner_product(m, own, n_)) /
                         before;
        }
        right[moments + a] = -force;
        for (uint32_t e = 0; e <= a; ++e) row[moments + e] += is_free(node, e) ? form[a * k_ + e] : 0;
        restrict_moment(node, own);
        for (uint32_t c = 0; c < moments; ++c) row[c] = -stiffness * own[c];
    }
    if (after == 0) return;
    const uint32_t other = next(node);
    for (uint32_t c = 0; c < moments; ++c) {
        std::fill_n(its, n_, 0.0);
        its[c] = 1;
        restrict_moment(other, its);
        restrict_moment(node, its);
        for (uint32_t r = 0; r < n_; ++r) coupling[r * b + c] = -moments_.across(node) * its[r];
    }
    for (uint32_t a = 0; a < k_; ++a) {
        if (!is_free(other, a)) continue;
        direction(other, a, its);
        for (uint32_t e = 0; e < k_; ++e) {
            if (!is_free(node, e)) continue;
            direction(node, e, own);
            coupling[(moments + e) * b + moments + a] = -tension_after(node) / after * inner_product(own, its, n_);
        }
        restrict_moment(node, its);
        for (uint32_t r = 0; r < moments; ++r) coupling[r * b + moments + a] = its[r] / after;
    }
    for (uint32_t e = 0; e < k_; ++e) {
        if (!is_free(node, e)) continue;
        direction(node, e, own);
        restrict_moment(other, own);
        for (uint32_t c = 0; c < moments; ++c) coupling[(moments + e) * b + c] = own[c] / after;
    }
}

void SplineOptimizer::find_shift(uint32_t node) {
    const double* const solution = system_.solution(node) + (bends() ? n_ : 0);
    double* const shift = shift_.make(node);
    double square = 0;
    for (uint32_t a = 0; a < k_; ++a) {
        shift[a] = is_free(node, a) ? solution[a] : has_border() && is_free(node) && a == 1 ? walls_.push(node) : 0;
        square += shift[a] * shift[a];
        slope_ += shift[a] * inner_product(gradient_[node], basis_of(node) + a * n_, n_);
    }
    largest_ = std::max(largest_, std::sqrt(square));
}

void SplineOptimizer::move(uint32_t node) {
    const double* const from = at(now_, node);
    double* const to = at(trial_, node);
    std::copy_n(from, n_, to);
    std::copy_n(hint_of(now_, node), hint_size_, hint_of(trial_, node));
    for (uint32_t a = 0; a < k_ && is_free(node); ++a) {
        const double by = step_ * shift_[node][a];
        for (uint32_t c = 0; c < n_; ++c) to[c] += by * basis_of(node)[a * n_ + c];
    }
    if (is_free(node) && (!problem_.manifold->project(to, hint_of(trial_, node)) ||
                          !walls_.confine(to, hint_of(trial_, node), basis_of(node))))
        projects_ = false;
    const auto keeps = [&](uint32_t first) {
        const uint32_t second = next(first);
        return problem_.manifold->keeps_sides(at(now_, first), at(now_, second), at(trial_, first), at(trial_, second));
    };
    if (projects_ && node > 0 && !keeps(node - 1)) projects_ = false;
    if (projects_ && node + 1 == nodes_ && problem_.closed && !keeps(node)) projects_ = false;
}

}  // namespace flg
