// SPDX-License-Identifier: MIT
#include "splines/sampled_distance.h"

#include <algorithm>
#include <cmath>

namespace flg {

namespace {

const double pole = std::sqrt(3.0) - 2;
constexpr uint32_t horizon = 28;  // the pole's power is below rounding

// The cubic B-spline's four weights in a cell, and their derivatives.
struct Weights {
    double w[4], d[4], dd[4];

    Weights(double u, double h) {
        const double v = 1 - u;
        w[0] = v * v * v / 6;
        w[1] = (4 - 6 * u * u + 3 * u * u * u) / 6;
        w[2] = (4 - 6 * v * v + 3 * v * v * v) / 6;
        w[3] = u * u * u / 6;
        d[0] = -0.5 * v * v / h;
        d[1] = (-2 * u + 1.5 * u * u) / h;
        d[2] = (2 * v - 1.5 * v * v) / h;
        d[3] = 0.5 * u * u / h;
        dd[0] = v / (h * h);
        dd[1] = (3 * u - 2) / (h * h);
        dd[2] = (3 * v - 2) / (h * h);
        dd[3] = u / (h * h);
    }
};

// Beyond its ends a line is mirrored at the last node.
uint32_t mirrored(int32_t i, uint32_t count) {
    const auto last = static_cast<int32_t>(count) - 1;
    return static_cast<uint32_t>(i < 0 ? -i : i > last ? 2 * last - i : i);
}

}  // namespace

uint32_t SampledDistance::line_start(uint32_t axis, uint32_t index) const {
    const std::array<uint32_t, 3>& n = grid.counts;
    if (axis == 0) return index * n[0];
    if (axis == 1) return index / n[0] * n[0] * n[1] + index % n[0];
    return index;
}

void SampledDistance::filter_line(uint32_t axis, uint32_t index) {
    const uint32_t count = grid.counts[axis], stride = grid.stride(axis);
    double* c = values.data() + line_start(axis, index);
    double first = 0, power = 1;
    for (uint32_t k = 0; k < horizon; ++k, power *= pole) {
        const uint32_t period = 2 * (count - 1), i = k % period;
        first += power * c[(i < count ? i : period - i) * stride];
    }
    c[0] = 6 * first;
    for (uint32_t k = 1; k < count; ++k) c[k * stride] = 6 * c[k * stride] + pole * c[(k - 1) * stride];
    double* last = c + (count - 1) * stride;
    *last = pole / (pole * pole - 1) * (*last + pole * last[-static_cast<ptrdiff_t>(stride)]);
    for (uint32_t k = count - 1; k-- > 0;) c[k * stride] = pole * (c[(k + 1) * stride] - c[k * stride]);
}

bool SampledDistance::evaluate(const double* x, double* value, double* gradient, double* second) const {
    int32_t cell[3];
    double u[3];
    for (uint32_t k = 0; k < 3; ++k) {
        const double t = (x[k] - grid.origin[k]) / grid.spacing;
        if (!(t >= 0 && t <= grid.counts[k] - 1)) return false;
        cell[k] = std::min(static_cast<int32_t>(t), static_cast<int32_t>(grid.counts[k]) - 2);
        u[k] = t - cell[k];
    }
    const Weights a(u[0], grid.spacing), b(u[1], grid.spacing), c(u[2], grid.spacing);
    uint32_t across[4];
    for (int32_t i = 0; i < 4; ++i) across[i] = mirrored(cell[0] + i - 1, grid.counts[0]);
    double sum = 0, g[3] = {}, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    for (int32_t k = 0; k < 4; ++k) {
        const uint32_t layer = mirrored(cell[2] + k - 1, grid.counts[2]) * grid.counts[1];
        double p = 0, px = 0, pxx = 0, py = 0, pxy = 0, pyy = 0;
        for (int32_t j = 0; j < 4; ++j) {
            const double* row = values.data() + (layer + mirrored(cell[1] + j - 1, grid.counts[1])) * grid.counts[0];
            double q = 0, qx = 0, qxx = 0;
            for (int32_t i = 0; i < 4; ++i) {
                const double f = row[across[i]];
                q += a.w[i] * f;
                qx += a.d[i] * f;
                qxx += a.dd[i] * f;
            }
            p += b.w[j] * q;
            px += b.w[j] * qx;
            pxx += b.w[j] * qxx;
            py += b.d[j] * q;
            pxy += b.d[j] * qx;
            pyy += b.dd[j] * q;
        }
        sum += c.w[k] * p;
        g[0] += c.w[k] * px;
        g[1] += c.w[k] * py;
        g[2] += c.d[k] * p;
        xx += c.w[k] * pxx;
        xy += c.w[k] * pxy;
        yy += c.w[k] * pyy;
        xz += c.d[k] * px;
        yz += c.d[k] * py;
        zz += c.dd[k] * p;
    }
    *value = sum;
    if (gradient != nullptr) std::copy_n(g, 3, gradient);
    if (second != nullptr) {
        const double all[9] = {xx, xy, xz, xy, yy, yz, xz, yz, zz};
        std::copy_n(all, 9, second);
    }
    return true;
}

}  // namespace flg
