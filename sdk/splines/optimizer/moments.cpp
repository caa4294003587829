// SPDX-License-Identifier: MIT
#include "splines/optimizer/moments.h"

#include <algorithm>

namespace flg {

namespace {

// Rounds until the moments of both ends agree: each divides what is missing by 4 at least.
constexpr uint32_t end_rounds = 30;

void apply(const double* matrix, const double* vector, uint32_t n, double* out) {
    for (uint32_t i = 0; i < n; ++i) {
        double sum = 0;
        for (uint32_t j = 0; j < n; ++j) sum += matrix[i * n + j] * vector[j];
        out[i] = sum;
    }
}

}  // namespace

Moments::Moments(uint32_t nodes, uint32_t ambient, bool closed, double tension, Memory* memory)
    : nodes_(nodes),
      ambient_(ambient),
      intervals_(closed ? nodes : nodes - 1),
      closed_(closed),
      stiffness_(std::sqrt(tension)),
      steps_(intervals_, memory),
      pieces_(tension > 0 ? intervals_ : 0, memory),
      inverse_(intervals_, memory),
      upper_(intervals_, memory),
      from_first_(intervals_, memory),
      from_last_(intervals_, memory),
      inner_(intervals_, ambient, memory) {}

// Thomas's algorithm: down the rows, then up.
Task<void> Moments::factorize(Pace& pace, Moments& m) {
    const uint32_t inner = m.intervals_ - 1;
    co_await each(pace, m.pieces_.size(), Cost::tens_of_ns,
                  [&m](uint32_t i) { m.pieces_[i] = cubic_piece(m.steps_[i], m.stiffness(i)); });
    co_await each(pace, 1, m.intervals_, Cost::tens_of_ns, [&m, inner](uint32_t i) {
        const double before = m.across(i - 1), after = m.across(i);
        const double pivot = m.row(i) - (i > 1 ? before * m.upper_[i - 1] : 0);
        m.inverse_[i] = 1 / pivot;
        m.upper_[i] = after / pivot;
        m.from_first_[i] = (i > 1 ? -before * m.from_first_[i - 1] : before) / pivot;
        m.from_last_[i] = i == inner ? after / pivot : 0;
    });
    co_await each(pace, 1, inner, Cost::tens_of_ns, [&m, inner](uint32_t k) {
        const uint32_t i = inner - k;
        m.from_first_[i] -= m.upper_[i] * m.from_first_[i + 1];
        m.from_last_[i] -= m.upper_[i] * m.from_last_[i + 1];
    });
}

double Moments::row(uint32_t node) const {
    if (pieces_.empty()) return (step_before(node) + step_after(node)) / 3;
    const bool first = !closed_ && node == 0, last = node == intervals_;
    const double before = first ? 0 : pieces_[node == 0 ? intervals_ - 1 : node - 1].own;
    return before + (last ? 0 : pieces_[node].own);
}

void Moments::bend(uint32_t node, const double* points, double* out) const {
    const uint32_t n = ambient_;
    const double* const x = points + size_t{node} * n;
    const bool first = !closed_ && node == 0, last = !closed_ && node + 1 == nodes_;
    const double* const before = points + size_t{node == 0 ? nodes_ - 1 : node - 1} * n;
    const double* const after = points + size_t{node + 1 == nodes_ ? 0 : node + 1} * n;
    const double to_next = last ? 0 : 1 / step_after(node), to_previous = first ? 0 : 1 / step_before(node);
    for (uint32_t c = 0; c < n; ++c) {
        const double slope_after = last ? ends_[1].slope[c] : (after[c] - x[c]) * to_next;
        const double slope_before = first ? ends_[0].slope[c] : (x[c] - before[c]) * to_previous;
        out[c] = slope_after - slope_before;
    }
}

Task<void> Moments::solve(Pace& pace, Moments& m, const double* points, double* moments) {
    const uint32_t inner = m.intervals_ - 1, n = m.ambient_;
    co_await each(pace, 1, m.intervals_, Cost::tens_of_ns, [&m, n, points](uint32_t i) {
        double* const y = m.inner_.make(i);
        m.bend(i, points, y);
        const double* const last = i > 1 ? m.inner_[i - 1] : y;
        for (uint32_t c = 0; c < n; ++c) y[c] = (y[c] - (i > 1 ? m.across(i - 1) * last[c] : 0)) * m.inverse_[i];
    });
    co_await each(pace, 1, inner, Cost::tens_of_ns, [&m, n, inner](uint32_t k) {
        const uint32_t i = inner - k;
        double* const y = m.inner_[i];
        const double* const next = m.inner_[i + 1];
        for (uint32_t c = 0; c < n; ++c) y[c] -= m.upper_[i] * next[c];
    });
    m.solve_ends(points);
    co_await each(pace, m.nodes_, Cost::tens_of_ns,
                  [&m, n, moments](uint32_t i) { m.moment(i, moments + size_t{i} * n); });
}

// The first and the last row, with what lies between put in; closed curves have one row there, as both are one node.
void Moments::solve_ends(const double* points) {
    const uint32_t inner = intervals_ - 1, n = ambient_;
    const double first_step = across(0), last_step = across(inner);
    double first[Manifold::max_ambient], last[Manifold::max_ambient];
    bend(0, points, first);
    if (!closed_) bend(nodes_ - 1, points, last);
    double own_first = row(0), own_last = row(closed_ ? 0 : nodes_ - 1), coupled = -first_step;
    if (inner > 0) {
        double* const to_last = closed_ ? first : last;
        for (uint32_t c = 0; c < n; ++c) first[c] -= first_step * inner_[1][c];
        for (uint32_t c = 0; c < n; ++c) to_last[c] -= last_step * inner_[inner][c];
        own_first -= first_step * from_first_[1];
        own_last -= last_step * from_last_[inner];
        coupled = first_step * from_last_[1];
    }
    double* const at_first = end_moments_[0];
    double* const at_last = end_moments_[1];
    if (closed_) {
        const double own = own_first + own_last - row(0) - 2 * coupled;
        for (uint32_t c = 0; c < n; ++c) at_first[c] = at_last[c] = first[c] / own;
        return;
    }
    std::fill_n(at_first, n, 0.0);
    std::fill_n(at_last, n, 0.0);
    double sum[Manifold::max_ambient];
    for (uint32_t round = 0; round < end_rounds; ++round) {
        for (uint32_t c = 0; c < n; ++c) sum[c] = (first[c] + coupled * at_last[c]) / own_first;
        apply(ends_[0].normals, sum, n, at_first);
        for (uint32_t c = 0; c < n; ++c) sum[c] = (last[c] + coupled * at_first[c]) / own_last;
        apply(ends_[1].normals, sum, n, at_last);
    }
}

void Moments::moment(uint32_t node, double* out) const {
    const uint32_t n = ambient_;
    if (node == 0 || node == intervals_) {
        std::copy_n(end_moments_[node != 0], n, out);
        return;
    }
    const double* const y = inner_[node];
    for (uint32_t c = 0; c < n; ++c) {
        out[c] = y[c] - from_first_[node] * end_moments_[0][c] - from_last_[node] * end_moments_[1][c];
    }
}

double Moments::energy(uint32_t node, const double* points, const double* moment) const {
    double change[Manifold::max_ambient], sum = 0;
    bend(node, points, change);
    for (uint32_t c = 0; c < ambient_; ++c) sum += moment[c] * change[c];
    return sum;
}

}  // namespace flg
