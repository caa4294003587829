// SPDX-License-Identifier: MIT
#include "splines/obstacles/sweep_distance.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Of the spacing: smaller changes are not followed up.
constexpr double min_change = 1e-9;

}  // namespace

std::array<uint32_t, 3> SweepGrid::nearest(const double* x) const {
    std::array<uint32_t, 3> at{};
    for (uint32_t k = 0; k < dimension; ++k) {
        const double t = std::floor((x[k] - origin[k]) / spacing + 0.5);
        at[k] = static_cast<uint32_t>(std::clamp(t, 0.0, counts[k] - 1.0));
    }
    return at;
}

Task<uint64_t> SweepDistance::solve(Pace& pace, SweepDistance& of, SweepRange range, std::span<const Seed> seeds,
                                    SweepGoal goal) {
    double* const values = of.values_.data();
    const SweepGrid& grid = of.grid_;
    uint8_t* const is_due = of.is_due_.data();
    co_await each(pace, grid.size(), Cost::some_ns, [values, is_due](uint32_t node) {
        values[node] = infinite;
        is_due[node] = 0;
    });
    co_await each(pace, of.row_is_due_.size(), Cost::some_ns, [&of](uint32_t row) { of.row_is_due_[row] = 0; });
    co_await each(pace, seeds.size(), Cost::some_ns, [&of, values, seeds](uint32_t i) {
        const uint32_t node = seeds[i].node;
        values[node] = std::min(values[node], seeds[i].value);
        of.call_neighbours(node, of.grid_.cell(node));
    });
    // The order of a sweep, bit k: backwards along axis k. Ends when a sweep in each order has changed nothing.
    const uint32_t orders = 1u << grid.dimension;
    const double change = min_change * grid.spacing;
    uint64_t passed = 0;
    for (uint32_t order = 0, idle = 0; idle < orders; order = (order + 1) % orders) {
        bool changed = false;
        const uint32_t across = range.upper[1] - range.lower[1] + 1, deep = range.upper[2] - range.lower[2] + 1;
        co_await each_by_work(pace, across * deep, Cost::tens_of_ns, [&, order, change, across](uint32_t row) {
            std::array<uint32_t, 3> cell{0, row % across, row / across};
            for (uint32_t k = 1; k < 3; ++k)
                cell[k] = (order >> k & 1) != 0 ? range.upper[k] - cell[k] : range.lower[k] + cell[k];
            uint8_t& row_is_due = of.row_is_due_[cell[2] * grid.counts[1] + cell[1]];
            if (row_is_due == 0) return 1u;
            row_is_due = 0;
            passed += range.upper[0] - range.lower[0] + 1;
            if (of.sweep_row(cell, range, (order & 1) != 0, change, goal)) changed = true;
            return 1 + range.upper[0] - range.lower[0];
        });
        idle = changed ? 0 : idle + 1;
    }
    co_return passed;
}

// The nodes of a row that are due, whether one of them changed.
bool SweepDistance::sweep_row(std::array<uint32_t, 3> cell, const SweepRange& range, bool backwards, double change,
                              const SweepGoal& goal) {
    bool changed = false;
    const uint32_t count = range.upper[0] - range.lower[0] + 1;
    for (uint32_t i = 0; i < count; ++i) {
        cell[0] = backwards ? range.upper[0] - i : range.lower[0] + i;
        const uint32_t node = grid_.node(cell);
        if (is_due_[node] == 0 || (flags_[node] & unused) != 0) continue;
        is_due_[node] = 0;
        const double value = updated(node, cell[0], cell[1], cell[2]);
        if (!(value < values_[node])) continue;
        const bool matters = values_[node] - value > change;
        changed = changed || matters;
        values_[node] = value;
        if (matters && leads_to(goal, node, cell)) call_neighbours(node, cell);
    }
    return changed;
}

// Whether a way through a node may be short enough.
bool SweepDistance::leads_to(const SweepGoal& goal, uint32_t node, const std::array<uint32_t, 3>& cell) const {
    const double left = goal.longest - values_[node];
    if (!(left < infinite)) return true;
    double square = 0;
    for (uint32_t k = 0; k < grid_.dimension; ++k) {
        const double away = grid_.origin[k] + grid_.spacing * cell[k] - goal.at[k];
        square += away * away;
    }
    return left > 0 && square <= left * left;
}

void SweepDistance::call_neighbours(uint32_t node, const std::array<uint32_t, 3>& cell) {
    const auto call = [this, node](uint32_t other) {
        if (!(values_[other] > values_[node])) return;
        is_due_[other] = 1;
        row_is_due_[other / grid_.counts[0]] = 1;
    };
    for (uint32_t k = 0; k < grid_.dimension; ++k) {
        const uint32_t stride = grid_.stride(k);
        if (cell[k] > 0) call(node - stride);
        if (cell[k] + 1 < grid_.counts[k]) call(node + stride);
    }
}

// The least u with sum over axes of max(u - a, 0)^2 = h^2, a the lesser neighbour along an axis.
double SweepDistance::updated(uint32_t node, uint32_t x, uint32_t y, uint32_t z) const {
    const uint32_t at[3] = {x, y, z};
    double a[3] = {infinite, infinite, infinite};
    uint32_t count = 0;
    for (uint32_t k = 0; k < grid_.dimension; ++k) {
        const uint32_t stride = grid_.stride(k);
        double least = infinite;
        if (at[k] > 0 && (flags_[node - stride] & closed(k)) == 0) least = values_[node - stride];
        if (at[k] + 1 < grid_.counts[k] && (flags_[node] & closed(k)) == 0) {
            least = std::min(least, values_[node + stride]);
        }
        uint32_t place = count++;
        for (; place > 0 && a[place - 1] > least; --place) a[place] = a[place - 1];
        a[place] = least;
    }
    const double h = grid_.spacing;
    double u = a[0] + h, sum = a[0], squares = a[0] * a[0];
    for (uint32_t k = 1; k < count && u > a[k]; ++k) {
        sum += a[k];
        squares += a[k] * a[k];
        const double n = k + 1;
        u = (sum + std::sqrt(std::max(sum * sum - n * (squares - h * h), 0.0))) / n;
    }
    return u;
}

}  // namespace flg
