// SPDX-License-Identifier: MIT
// Points of R^n as n numbers.
#pragma once

#include <cmath>
#include <cstdint>

namespace flg {

inline double inner_product(const double* a, const double* b, uint32_t n) {
    double sum = 0;
    for (uint32_t c = 0; c < n; ++c) sum += a[c] * b[c];
    return sum;
}

inline double distance_between(const double* a, const double* b, uint32_t n) {
    double sum = 0;
    for (uint32_t c = 0; c < n; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
    return std::sqrt(sum);
}

}  // namespace flg
