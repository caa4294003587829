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

Task<void> SweepDistance::solve(Pace& pace, SweepDistance& of, SweepRange range, std::span<const Seed> seeds) {
    double* const values = of.values_.data();
    const SweepGrid& grid = of.grid_;
    uint8_t* const is_due = of.is_due_.data();
    co_await each(pace, grid.size(), Cost::some_ns, [values, is_due](uint32_t node) {
        values[node] = infinite;
        is_due[node] = 0;
    });
    co_await each(pace, seeds.size(), Cost::some_ns, [&of, values, seeds](uint32_t i) {
        const uint32_t node = seeds[i].node;
        values[node] = std::min(values[node], seeds[i].value);
        of.call_neighbours(node, of.grid_.cell(node));
    });
    // The order of a sweep, bit k: backwards along axis k. Ends when a sweep in each order has changed nothing.
    const uint32_t orders = 1u << grid.dimension;
    const double change = min_change * grid.spacing;
    for (uint32_t order = 0, idle = 0; idle < orders; order = (order + 1) % orders) {
        bool changed = false;
        std::array<uint32_t, 3> cell;
        for (uint32_t k = 0; k < 3; ++k) cell[k] = (order >> k & 1) != 0 ? range.upper[k] : range.lower[k];
        co_await each(pace, range.size(), Cost::tens_of_ns, [&, values, is_due, order, change](uint32_t) {
            const uint32_t node = grid.node(cell);
            if (is_due[node] != 0 && (of.flags_[node] & unused) == 0) {
                is_due[node] = 0;
                const double value = of.updated(node, cell[0], cell[1], cell[2]);
                if (value < values[node]) {
                    const bool matters = values[node] - value > change;
                    changed = changed || matters;
                    values[node] = value;
                    if (matters) of.call_neighbours(node, cell);
                }
            }
            for (uint32_t axis = 0; axis < 3; ++axis) {
                const bool back = (order >> axis & 1) != 0;
                if (cell[axis] != (back ? range.lower[axis] : range.upper[axis])) {
                    cell[axis] += back ? -1u : 1u;
                    break;
                }
                cell[axis] = back ? range.upper[axis] : range.lower[axis];
            }
        });
        idle = changed ? 0 : idle + 1;
    }
}

void SweepDistance::call_neighbours(uint32_t node, const std::array<uint32_t, 3>& cell) {
    for (uint32_t k = 0; k < grid_.dimension; ++k) {
        const uint32_t stride = grid_.stride(k);
        if (cell[k] > 0 && values_[node - stride] > values_[node]) is_due_[node - stride] = 1;
        if (cell[k] + 1 < grid_.counts[k] && values_[node + stride] > values_[node]) is_due_[node + stride] = 1;
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
