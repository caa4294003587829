// SPDX-License-Identifier: MIT
#include "splines/distance_grid.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

constexpr double longest_step = 4;  // cells
constexpr uint32_t most_rounds = 60;
constexpr double last_step = 1e-9;  // of the box

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
    : Hypersurface(3, 0, diagonal(input), longest_step * input.spacing),
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

bool DistanceGrid::project(double* x, double* memory) const {
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
    for (uint32_t round = 0; round < most_rounds; ++round) {
        if (!evaluate(at, memory, &value, gradient, nullptr)) return false;
        const double square = gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2];
        if (!(square > 0)) return false;
        const double length = std::abs(value) / std::sqrt(square), most = longest_step * spacing_;
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

}  // namespace flg
