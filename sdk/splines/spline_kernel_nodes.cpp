// SPDX-License-Identifier: MIT
// What the optimization does at one node.
#include <cmath>

#include "splines/coordinates.h"
#include "splines/positive_part.h"
#include "splines/spline_kernel.h"

namespace flg {

namespace {

using Vector = double[Manifold::max_ambient];

}  // namespace

// Given points are where they were given, to the bit: they are on the manifold, but a projection may round.
void SplineKernel::project_first(uint32_t node) {
    if (!remembers_) std::fill_n(memory_of(now_, node), memory_size_, 0.0);
    knot_of_[node] = no_knot;
    if (next_knot_ < problem_.knots.size() && problem_.knots[next_knot_] == node) knot_of_[node] = next_knot_++;
    double* const x = at(now_, node);
    if (!is_free(node)) std::copy_n(&problem_.given[size_t{knot_of_[node]} * n_], n_, x);
    if (!problem_.manifold->project(x, memory_of(now_, node))) {
        if (projects_) report_.failed_node = node;
        projects_ = false;
    }
    if (!is_free(node)) std::copy_n(&problem_.given[size_t{knot_of_[node]} * n_], n_, x);
}

uint32_t SplineKernel::intervals_of(uint32_t knot) const {
    const uint32_t end = knot + 1 < problem_.knots.size() ? problem_.knots[knot + 1] : nodes_;
    return end - problem_.knots[knot];
}

void SplineKernel::measure_length(uint32_t node) {
    if (knot_of_[node] != no_knot) {
        segment_ = knot_of_[node];
        lengths_[segment_] = 0;
    }
    if (!has_next(node)) return;
    const double length = distance_between(at(now_, node), at(now_, next(node)), n_);
    lengths_[segment_] += length;
    report_.length += length;
}

// Steps between two given points are equal.
void SplineKernel::set_step(uint32_t interval) {
    if (knot_of_[interval] != no_knot) {
        segment_ = knot_of_[interval];
        spans_[segment_] = problem_.parameters.size() > 0
                               ? problem_.parameters[segment_ + 1] - problem_.parameters[segment_]
                               : std::max(lengths_[segment_], 1e-9 * report_.length);
        span_ += spans_[segment_];
    }
    moments_.steps()[interval] = spans_[segment_] / intervals_of(segment_);
}

void SplineKernel::set_end(bool last, double* points, double* memory, bool with_slope) {
    SplineEnd& end = moments_.end(last);
    const bool prescribed = problem_.has_slope[last];
    std::fill_n(end.slope, n_, 0.0);
    std::fill_n(end.normals, n_ * n_, 0.0);
    for (uint32_t c = 0; c < n_; ++c) end.normals[c * n_ + c] = 1;
    if (prescribed) {
        if (with_slope) std::copy_n(problem_.slopes[last], n_, end.slope);
        return;
    }
    // An end that moves would turn these directions, which the gradient does not know of: natural in all of them.
    if (pull_ > 0) {
        std::fill_n(end.normals, n_ * n_, 0.0);
        return;
    }
    double basis[Manifold::max_dimension * Manifold::max_ambient];
    problem_.manifold->tangent_basis(points, memory, basis);
    for (uint32_t a = 0; a < k_; ++a) {
        for (uint32_t r = 0; r < n_; ++r) {
            for (uint32_t c = 0; c < n_; ++c) end.normals[r * n_ + c] -= basis[a * n_ + r] * basis[a * n_ + c];
        }
    }
}

// The node's share of E2, of E1 (its interval to the next node), and of the distances to given points.
void SplineKernel::collect(uint32_t node) {
    const double* const points = measured_points();
    const double* const x = points + size_t{node} * n_;
    if (bends()) sums_[0] += moments_.energy(node, points, &moment_[size_t{node} * n_]);
    if (has_next(node)) {
        const double length = distance_between(x, points + size_t{next(node)} * n_, n_);
        sums_[1] += length * length / moments_.step_after(node);
    }
    if (knot_of_[node] == no_knot || pull_ == 0) return;
    if (measured_ == Measured::now || measured_ == Measured::trial) {
        const double off = distance_between(x, &problem_.given[size_t{knot_of_[node]} * n_], n_);
        sums_[2] += off * off;
    } else {
        sums_[2] += inner_product(x, x, n_);
    }
}

void SplineKernel::find_gradient(uint32_t node) {
    measure_length(node);
    double* const g = &gradient_[size_t{node} * n_];
    const double* const x = at(now_, node);
    std::fill_n(g, n_, 0.0);
    const auto add = [&](uint32_t other, double step) {
        const double* const y = at(now_, other);
        for (uint32_t c = 0; c < n_; ++c) g[c] += tension_ / step * (x[c] - y[c]);
        if (!bends()) return;
        const double* const own = &moment_[size_t{node} * n_];
        const double* const its = &moment_[size_t{other} * n_];
        for (uint32_t c = 0; c < n_; ++c) g[c] += (its[c] - own[c]) / step;
    };
    if (has_next(node)) add(next(node), moments_.step_after(node));
    if (has_previous(node)) add(previous(node), moments_.step_before(node));
    forces_ += std::sqrt(inner_product(g, g, n_));
    if (knot_of_[node] != no_knot && pull_ > 0) {
        const double* const given = &problem_.given[size_t{knot_of_[node]} * n_];
        for (uint32_t c = 0; c < n_; ++c) g[c] += pull_ * (x[c] - given[c]);
    }
}

void SplineKernel::find_frame(uint32_t node) {
    if (knot_of_[node] != no_knot && has_next(node)) {
        const uint32_t s = knot_of_[node];
        change_ = std::max(change_, std::abs(lengths_[s] / report_.length * span_ / spans_[s] - 1));
    }
    double* const basis = &basis_[size_t{node} * k_ * n_];
    const double* const g = &gradient_[size_t{node} * n_];
    problem_.manifold->tangent_basis(at(now_, node), memory_of(now_, node), basis);
    if (!is_free(node)) return;
    const double width = 0.5 * ((has_previous(node) ? moments_.step_before(node) : 0) +
                                (has_next(node) ? moments_.step_after(node) : 0));
    for (uint32_t a = 0; a < k_; ++a) {
        const double along = inner_product(g, basis + a * n_, n_) / width;
        tangential_ += along * along;
    }
    ++free_nodes_;
    if (problem_.method == SplineMethod::newton) {
        problem_.manifold->second_form(at(now_, node), memory_of(now_, node), basis, g, &form_[size_t{node} * k_ * k_]);
    }
}

// Moments at the ends of an open curve have only the parts that Moments gives them.
void SplineKernel::restrict_moment(uint32_t node, double* vector) const {
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
void SplineKernel::assemble(BlockTridiagonal& system, uint32_t node, bool unrestricted) {
    const uint32_t moments = bends() ? n_ : 0, moving = unrestricted ? n_ : k_, b = system.size();
    double* const diagonal = system.diagonal(node);
    double* const coupling = system.coupling(node);
    double* const right = system.right_side(node);
    std::fill_n(diagonal, b * b, 0.0);
    std::fill_n(coupling, b * b, 0.0);
    std::fill_n(right, b, 0.0);
    const double before = has_previous(node) ? moments_.step_before(node) : 0;
    const double after = has_next(node) ? moments_.step_after(node) : 0;
    const double stiffness = (before > 0 ? 1 / before : 0) + (after > 0 ? 1 / after : 0);
    const auto direction = [&](uint32_t of, uint32_t a, double* out) {
        if (unrestricted) {
            std::fill_n(out, n_, 0.0);
            out[a] = 1;
        } else {
            std::copy_n(basis_of(of) + a * n_, n_, out);
        }
    };
    Vector own, its;
    for (uint32_t c = 0; c < moments; ++c) diagonal[c * b + c] = -(before + after) / 3;
    if (bends()) {
        moments_.bend(node, now_.points.data(), own);
        restrict_moment(node, own);
        for (uint32_t c = 0; c < n_; ++c) right[c] = -own[c];
    }
    const bool free = is_free(node);
    const double pull = knot_of_[node] != no_knot ? pull_ : 0;
    double form[Manifold::max_dimension * Manifold::max_dimension];
    const bool has_form = free && !unrestricted && problem_.method == SplineMethod::newton;
    if (has_form) {
        std::copy_n(&form_[size_t{node} * k_ * k_], k_ * k_, form);
        if (concave_share_ < 1) scale_negative_part(form, k_, concave_share_);
    }
    for (uint32_t a = 0; a < moving; ++a) {
        double* const row = diagonal + (moments + a) * b;
        row[moments + a] = free ? tension_ * stiffness + pull : 1;
        if (!free) continue;
        direction(node, a, own);
        // What bending does not say is the rest of the gradient.
        const double* const g = &gradient_[size_t{node} * n_];
        double force = inner_product(g, own, n_);
        if (bends()) {
            const double* const m = &moment_[size_t{node} * n_];
            if (after > 0)
                force -=
                    (inner_product(&moment_[size_t{next(node)} * n_], own, n_) - inner_product(m, own, n_)) / after;
            if (before > 0)
                force -= (inner_product(&moment_[size_t{previous(node)} * n_], own, n_) - inner_product(m, own, n_)) /
                         before;
        }
        right[moments + a] = -force;
        for (uint32_t e = 0; has_form && e <= a; ++e) row[moments + e] += form[a * k_ + e];
        restrict_moment(node, own);
        for (uint32_t c = 0; c < moments; ++c) row[c] = -stiffness * own[c];
    }
    if (after == 0) return;
    const uint32_t other = next(node);
    const bool other_free = is_free(other);
    for (uint32_t c = 0; c < moments; ++c) {
        std::fill_n(its, n_, 0.0);
        its[c] = 1;
        restrict_moment(other, its);
        restrict_moment(node, its);
        for (uint32_t r = 0; r < n_; ++r) coupling[r * b + c] = -after / 6 * its[r];
    }
    for (uint32_t a = 0; other_free && a < moving; ++a) {
        direction(other, a, its);
        for (uint32_t e = 0; free && e < moving; ++e) {
            direction(node, e, own);
            coupling[(moments + e) * b + moments + a] = -tension_ / after * inner_product(own, its, n_);
        }
        restrict_moment(node, its);
        for (uint32_t r = 0; r < moments; ++r) coupling[r * b + moments + a] = its[r] / after;
    }
    for (uint32_t e = 0; free && e < moving; ++e) {
        direction(node, e, own);
        restrict_moment(other, own);
        for (uint32_t c = 0; c < moments; ++c) coupling[(moments + e) * b + c] = own[c] / after;
    }
}

void SplineKernel::substitute(uint32_t k) {
    system_.substitute(k);
    const uint32_t node = problem_.closed ? (nodes_ - k) % nodes_ : nodes_ - 1 - k;
    const double* const solution = system_.solution(node) + (bends() ? n_ : 0);
    double* const shift = &shift_[size_t{node} * k_];
    double square = 0;
    for (uint32_t a = 0; a < k_; ++a) {
        shift[a] = is_free(node) ? solution[a] : 0;
        square += shift[a] * shift[a];
        slope_ += shift[a] * inner_product(&gradient_[size_t{node} * n_], basis_of(node) + a * n_, n_);
    }
    largest_ = std::max(largest_, std::sqrt(square));
}

void SplineKernel::substitute_free(uint32_t k) {
    free_system_->substitute(k);
    const uint32_t node = problem_.closed ? (nodes_ - k) % nodes_ : nodes_ - 1 - k;
    if (is_free(node))
        slope_ += inner_product(free_system_->solution(node) + (bends() ? n_ : 0), &gradient_[size_t{node} * n_], n_);
}

void SplineKernel::move(uint32_t node) {
    const double* const from = at(now_, node);
    double* const to = at(trial_, node);
    std::copy_n(from, n_, to);
    std::copy_n(memory_of(now_, node), memory_size_, memory_of(trial_, node));
    for (uint32_t a = 0; a < k_ && is_free(node); ++a) {
        const double by = step_ * shift_[size_t{node} * k_ + a];
        for (uint32_t c = 0; c < n_; ++c) to[c] += by * basis_of(node)[a * n_ + c];
    }
    if (is_free(node) && !problem_.manifold->project(to, memory_of(trial_, node))) projects_ = false;
    const auto keeps = [&](uint32_t first) {
        const uint32_t second = next(first);
        return problem_.manifold->keeps_sides(at(now_, first), at(now_, second), at(trial_, first), at(trial_, second));
    };
    if (projects_ && node > 0 && !keeps(node - 1)) projects_ = false;
    if (projects_ && node + 1 == nodes_ && problem_.closed && !keeps(node)) projects_ = false;
}

}  // namespace flg
