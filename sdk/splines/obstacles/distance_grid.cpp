// SPDX-License-Identifier: MIT
#include "splines/obstacles/distance_grid.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr double max_step = 4;  // cells
constexpr uint32_t max_rounds = 60;
constexpr double last_step = 1e-9;  // of the box
constexpr uint32_t max_along_an_axis = 65536;
constexpr double max_samples = 2147483648.0;
constexpr uint32_t lanes = 16;  // lines that are filtered side by side

double diagonal(const GridInput& input) {
    double sum = 0;
    for (const uint32_t count : input.counts) sum += (count - 1.0) * (count - 1.0);
    return input.spacing * std::sqrt(sum);
}

}  // namespace

// Four coefficients along an axis, and how much each counts for the value and its derivatives.
struct DistanceGrid::Axis {
    uint32_t first;  // counts of those beyond the grid are 0, and their indices those of others
    uint32_t index[4];
    double weight[3][4];
};

DistanceGrid::DistanceGrid(const GridInput& input, Buffer<float> coefficients)
    : Hypersurface(3, 0, diagonal(input), max_step * input.spacing),
      counts_(input.counts),
      origin_(input.origin),
      spacing_(input.spacing),
      coefficients_(std::move(coefficients)) {}

// Beyond an end coefficients go on linearly: what would count for them counts for the last two.
bool DistanceGrid::locate(double at, uint32_t axis, Axis& result) const {
    const double u = (at - origin_[axis]) / spacing_;
    const uint32_t count = counts_[axis];
    if (!(u >= 0 && u <= count - 1.0)) return false;
    const uint32_t cell = std::min(static_cast<uint32_t>(u), count - 2);
    const double t = u - cell, s = 1 - t, per = 1 / spacing_;
    double* b = result.weight[0];
    b[0] = s * s * s / 6;
    b[1] = (4 - 6 * t * t + 3 * t * t * t) / 6;
    b[2] = (4 - 6 * s * s + 3 * s * s * s) / 6;
    b[3] = t * t * t / 6;
    double* first = result.weight[1];
    first[0] = -0.5 * per * s * s;
    first[1] = per * (1.5 * t * t - 2 * t);
    first[2] = per * (2 * s - 1.5 * s * s);
    first[3] = 0.5 * per * t * t;
    double* second = result.weight[2];
    second[0] = per * per * s;
    second[1] = per * per * (3 * t - 2);
    second[2] = per * per * (3 * s - 2);
    second[3] = per * per * t;
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t index = cell + k;  // of one farther on
        result.index[k] = std::clamp(index, 1u, count) - 1;
    }
    for (auto& weight : result.weight) {
        if (cell == 0) {
            weight[1] += 2 * weight[0];
            weight[2] -= weight[0];
            weight[0] = 0;
        }
        if (cell + 2 == count) {
            weight[2] += 2 * weight[3];
            weight[1] -= weight[3];
            weight[3] = 0;
        }
    }
    return true;
}

bool DistanceGrid::evaluate(const double* x, double*, double* value, double* gradient, double* second) const {
    Axis along[3];
    for (uint32_t axis = 0; axis < 3; ++axis) {
        if (!locate(x[axis], axis, along[axis])) return false;
    }
    // Derivatives along x and y, by their orders: of rows, then of layers.
    double sums[3][3][3] = {};
    for (uint32_t k = 0; k < 4; ++k) {
        double layer[3][3] = {};
        for (uint32_t j = 0; j < 4; ++j) {
            const float* row =
                &coefficients_[(size_t{along[2].index[k]} * counts_[1] + along[1].index[j]) * counts_[0]];
            for (uint32_t a = 0; a < 3; ++a) {
                double sum = 0;
                for (uint32_t i = 0; i < 4; ++i) sum += along[0].weight[a][i] * row[along[0].index[i]];
                for (uint32_t b = 0; a + b < 3; ++b) layer[a][b] += along[1].weight[b][j] * sum;
            }
        }
        for (uint32_t a = 0; a < 3; ++a) {
            for (uint32_t b = 0; a + b < 3; ++b) {
                for (uint32_t c = 0; a + b + c < 3; ++c) sums[a][b][c] += along[2].weight[c][k] * layer[a][b];
            }
        }
    }
    *value = sums[0][0][0];
    gradient[0] = sums[1][0][0];
    gradient[1] = sums[0][1][0];
    gradient[2] = sums[0][0][1];
    if (!second) return true;
    const double xy = sums[1][1][0], xz = sums[1][0][1], yz = sums[0][1][1];
    const double all[] = {sums[2][0][0], xy, xz, xy, sums[0][2][0], yz, xz, yz, sums[0][0][2]};
    std::copy(all, all + 9, second);
    return true;
}

bool DistanceGrid::project(double* x, double* hint) const {
    const auto hold = [&](double* at) {
        for (size_t k = 0; k < 3; ++k) {
            const double upper = origin_[k] + spacing_ * (counts_[k] - 1);
            at[k] = std::clamp(at[k], origin_[k], upper);
            // Rounding may put the upper side beyond itself.
            if ((at[k] - origin_[k]) / spacing_ > counts_[k] - 1.0) at[k] = std::nextafter(at[k], origin_[k]);
        }
    };
    double at[3], gradient[3], value = 0;
    std::copy_n(x, 3, at);
    hold(at);
    for (uint32_t round = 0; round < max_rounds; ++round) {
        if (!evaluate(at, hint, &value, gradient, nullptr)) return false;
        const double square = gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2];
        if (!(square > 0)) return false;
        const double length = std::abs(value) / std::sqrt(square), most = max_step * spacing_;
        const double share = length > most ? most / length : 1;
        for (size_t k = 0; k < 3; ++k) at[k] -= share * value / square * gradient[k];
        hold(at);
        if (length <= last_step * size()) {
            std::copy_n(at, 3, x);
            return true;
        }
    }
    return false;
}

namespace {

// Coefficients of the B-splines through samples: c[i - 1] + 4 c[i] + c[i + 1] = 6 v[i] along each axis in turn, with c
// = v at both ends, where second derivatives are 0. Eliminated forwards, and back.

// What elimination leaves of the upper diagonal in row i >= 1: from 1/4 on it converges quickly to 2 - sqrt(3).
constexpr uint32_t pivots = 16;
constexpr auto pivot_table = [] {
    std::array<double, pivots> table{};
    for (double last = 0; double& pivot : table) last = pivot = 1 / (4 - last);
    return table;
}();

double pivot(uint32_t row) {
    return pivot_table[std::min(row, pivots) - 1];
}

// Lines of samples that lie side by side: along y and z these are neighbours in x, along x they are neighbours in y.
struct Lines {
    void forward(uint32_t begin, uint32_t end) {
        for (uint32_t i = begin; i < end; ++i) {
            float* const row = samples + i * stride;
            if (i == 0 || i + 1 == count) {
                for (uint32_t lane = 0; lane < width; ++lane) carried[lane] = row[lane * side];
                continue;
            }
            const double share = pivot(i);
            for (uint32_t lane = 0; lane < width; ++lane) {
                carried[lane] = (6.0 * row[lane * side] - carried[lane]) * share;
                row[lane * side] = static_cast<float>(carried[lane]);
            }
        }
    }
    // Of the rows between the ends, the last one first.
    void back(uint32_t begin, uint32_t end) {
        for (uint32_t k = begin; k < end; ++k) {
            const uint32_t i = count - 2 - k;
            float* const row = samples + i * stride;
            const double share = pivot(i);
            for (uint32_t lane = 0; lane < width; ++lane) {
                carried[lane] = row[lane * side] - share * carried[lane];
                row[lane * side] = static_cast<float>(carried[lane]);
            }
        }
    }

    float* samples;
    size_t stride, side;    // from a row to the next, from a line to the next
    uint32_t count, width;  // rows, lines
    std::array<double, lanes> carried{};
};

Task<void> filter(Pace& pace, const GridInput& input, uint32_t axis, float* samples) {
    const size_t strides[] = {1, input.counts[0], size_t{input.counts[0]} * input.counts[1]};
    const uint32_t side = axis == 0 ? 1 : 0, other = axis == 2 ? 1 : 2, count = input.counts[axis];
    Slice slice(Cost::tens_of_ns);
    for (uint32_t second = 0; second < input.counts[other]; ++second) {
        for (uint32_t first = 0; first < input.counts[side]; first += lanes) {
            Lines lines{.samples = samples + first * strides[side] + second * strides[other],
                        .stride = strides[axis],
                        .side = strides[side],
                        .count = count,
                        .width = std::min(lanes, input.counts[side] - first)};
            for (Portion part(slice, 0, count); part.next();) {
                lines.forward(part.begin, part.end);
                if (part.is_over()) co_await pace;
            }
            for (Portion part(slice, 0, count - 2); part.next();) {
                lines.back(part.begin, part.end);
                if (part.is_over()) co_await pace;
            }
        }
    }
}

}  // namespace

Task<DistanceGrid> interpolate(Pace& pace, GridInput input) {
    double samples = 1;
    for (const uint32_t count : input.counts) {
        if (count < 2 || count > max_along_an_axis) {
            throw Failure(FLG_ERROR_INVALID_ARGUMENT, "a grid has 2 to %u samples along each axis, not %u",
                          max_along_an_axis, count);
        }
        samples *= count;
    }
    if (samples > max_samples) throw Failure(FLG_ERROR_LIMIT, "a grid has at most 2^31 samples, not %.0f", samples);
    Buffer<float> coefficients(static_cast<size_t>(samples), pace.memory());
    bool positive = false, negative = false;
    co_await each(pace, coefficients.size(), Cost::some_ns, [&](uint32_t i) {
        const float value = input.values[i];
        coefficients[i] = value;
        positive = positive || value > 0;
        negative = negative || value < 0;
    });
    if (!positive || !negative) {
        throw Failure(FLG_ERROR_INVALID_ARGUMENT, "the grid's values are nowhere %s: it has no zero level",
                      positive ? "negative" : "positive");
    }
    for (uint32_t axis = 0; axis < 3; ++axis) co_await filter(pace, input, axis, coefficients.data());
    DistanceGrid grid(input, std::move(coefficients));
    co_return grid;
}

}  // namespace flg
