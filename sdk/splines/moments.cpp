// SPDX-License-Identifier: MIT
#include "splines/moments.h"

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

Moments::Moments(uint32_t nodes, uint32_t ambient, bool closed, Memory* memory)
    : nodes_(nodes),
      ambient_(ambient),
      intervals_(closed ? nodes : nodes - 1),
      closed_(closed),
      steps_(intervals_, memory),
      inverse_(intervals_, memory),
      upper_(intervals_, memory),
      from_first_(intervals_, memory),
      from_last_(intervals_, memory),
      inner_(size_t{intervals_} * ambient, memory) {}

// Thomas's algorithm: down the rows, then up.
void Moments::measure(uint32_t k) {
    const uint32_t inner = intervals_ - 1;
    if (k < inner) {
        const uint32_t i = k + 1;
        const double before = steps_[i - 1] / 6, after = steps_[i] / 6;
        const double pivot = row(i) - (i > 1 ? before * upper_[i - 1] : 0);
        inverse_[i] = 1 / pivot;
        upper_[i] = after / pivot;
        from_first_[i] = (i > 1 ? -before * from_first_[i - 1] : before) / pivot;
        from_last_[i] = i == inner ? after / pivot : 0;
    } else {
        const uint32_t i = 2 * inner - k;
        if (i == inner) return;
        from_first_[i] -= upper_[i] * from_first_[i + 1];
        from_last_[i] -= upper_[i] * from_last_[i + 1];
    }
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

void Moments::solve(uint32_t k, const double* points) {
    const uint32_t inner = intervals_ - 1, n = ambient_;
    if (k < inner) {
        const uint32_t i = k + 1;
        double* const y = &inner_[size_t{i} * n];
        bend(i, points, y);
        const double* const last = y - n;
        for (uint32_t c = 0; c < n; ++c) y[c] = (y[c] - (i > 1 ? steps_[i - 1] / 6 * last[c] : 0)) * inverse_[i];
    } else if (k < 2 * inner) {
        const uint32_t i = 2 * inner - k;
        if (i == inner) return;
        double* const y = &inner_[size_t{i} * n];
        for (uint32_t c = 0; c < n; ++c) y[c] -= upper_[i] * y[c + n];
    } else {
        solve_ends(points);
    }
}

// The first and the last row, with what lies between put in; closed curves have one row there, as both are one node.
void Moments::solve_ends(const double* points) {
    const uint32_t inner = intervals_ - 1, n = ambient_;
    const double first_step = steps_[0] / 6, last_step = steps_[inner] / 6;
    double first[Manifold::max_ambient], last[Manifold::max_ambient];
    bend(0, points, first);
    if (!closed_) bend(nodes_ - 1, points, last);
    double own_first = row(0), own_last = row(closed_ ? 0 : nodes_ - 1), across = -first_step;
    if (inner > 0) {
        double* const to_last = closed_ ? first : last;
        for (uint32_t c = 0; c < n; ++c) first[c] -= first_step * inner_[n + c];
        for (uint32_t c = 0; c < n; ++c) to_last[c] -= last_step * inner_[size_t{inner} * n + c];
        own_first -= first_step * from_first_[1];
        own_last -= last_step * from_last_[inner];
        across = first_step * from_last_[1];
    }
    double* const at_first = end_moments_[0];
    double* const at_last = end_moments_[1];
    if (closed_) {
        const double own = own_first + own_last - row(0) - 2 * across;
        for (uint32_t c = 0; c < n; ++c) at_first[c] = at_last[c] = first[c] / own;
        return;
    }
    std::fill_n(at_first, n, 0.0);
    std::fill_n(at_last, n, 0.0);
    double sum[Manifold::max_ambient];
    for (uint32_t round = 0; round < end_rounds; ++round) {
        for (uint32_t c = 0; c < n; ++c) sum[c] = (first[c] + across * at_last[c]) / own_first;
        apply(ends_[0].normals, sum, n, at_first);
        for (uint32_t c = 0; c < n; ++c) sum[c] = (last[c] + across * at_first[c]) / own_last;
        apply(ends_[1].normals, sum, n, at_last);
    }
}

void Moments::moment(uint32_t node, double* out) const {
    const uint32_t n = ambient_;
    if (node == 0 || node == intervals_) {
        std::copy_n(end_moments_[node != 0], n, out);
        return;
    }
    const double* const y = &inner_[size_t{node} * n];
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
