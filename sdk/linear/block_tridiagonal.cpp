// SPDX-License-Identifier: MIT
#include "linear/block_tridiagonal.h"

#include <algorithm>
#include <cmath>

namespace flg {

BlockTridiagonal::BlockTridiagonal(uint32_t blocks, uint32_t size, bool cyclic, Memory* memory)
    : blocks_(blocks),
      size_(size),
      area_(size * size),
      cyclic_(cyclic),
      diagonal_(blocks, area_, memory),
      coupling_(blocks, area_, memory),
      border_(cyclic ? blocks : 0, area_, memory),
      right_(blocks, size, memory),
      inverse_pivots_(blocks, size, memory) {}

namespace {

// rows := L^-1 rows, for L the unit lower triangle of a block.
template <uint32_t fixed_size>
void solve_lower(const double* lower, double* rows, uint32_t dynamic_size) {
    const uint32_t b = fixed_size ? fixed_size : dynamic_size;
    for (uint32_t j = 0; j < b; ++j) {
        for (uint32_t r = j + 1; r < b; ++r) {
            const double factor = lower[r * b + j];
            for (uint32_t c = 0; c < b; ++c) rows[r * b + c] -= factor * rows[j * b + c];
        }
    }
}

// target -= left^T D^-1 right.
template <uint32_t fixed_size>
void subtract_product(double* target, const double* left, const double* inverse, const double* right,
                      uint32_t dynamic_size) {
    const uint32_t b = fixed_size ? fixed_size : dynamic_size;
    for (uint32_t j = 0; j < b; ++j) {
        for (uint32_t r = 0; r < b; ++r) {
            const double factor = left[j * b + r] * inverse[j];
            for (uint32_t c = 0; c < b; ++c) target[r * b + c] -= factor * right[j * b + c];
        }
    }
}

// target -= rows^T D^-1 values.
template <uint32_t fixed_size>
void subtract_transposed(double* target, const double* rows, const double* inverse, const double* values,
                         uint32_t dynamic_size) {
    const uint32_t b = fixed_size ? fixed_size : dynamic_size;
    for (uint32_t j = 0; j < b; ++j) {
        const double factor = inverse[j] * values[j];
        for (uint32_t c = 0; c < b; ++c) target[c] -= rows[j * b + c] * factor;
    }
}

}  // namespace

template <uint32_t fixed_size>
void BlockTridiagonal::eliminate_block(uint32_t i, uint32_t next, double* border, double* next_border, bool has_next) {
    const uint32_t b = fixed_size ? fixed_size : size_;
    double* const d = diagonal(i);
    double* const inverse = inverse_pivots_.make(i);
    double* const right = right_side(i);
    for (uint32_t j = 0; j < b; ++j) {
        const double pivot = d[j * b + j];
        negative_ += pivot < 0 ? 1 : 0;
        if (pivot == 0 || !std::isfinite(pivot)) singular_ = true;
        inverse[j] = 1 / pivot;
        for (uint32_t r = j + 1; r < b; ++r) {
            const double factor = d[r * b + j] * inverse[j];
            for (uint32_t c = j + 1; c <= r; ++c) d[r * b + c] -= factor * d[c * b + j];
            right[r] -= factor * right[j];
        }
        for (uint32_t r = j + 1; r < b; ++r) d[r * b + j] *= inverse[j];
    }
    if (has_next) {
        solve_lower<fixed_size>(d, coupling(i), b);
        subtract_product<fixed_size>(diagonal(next), coupling(i), inverse, coupling(i), b);
        subtract_transposed<fixed_size>(right_side(next), coupling(i), inverse, right, b);
    }
    if (!border) return;
    solve_lower<fixed_size>(d, border, b);
    subtract_product<fixed_size>(diagonal(0), border, inverse, border, b);
    subtract_transposed<fixed_size>(right_side(0), border, inverse, right, b);
    if (has_next) subtract_product<fixed_size>(next_border, coupling(i), inverse, border, b);
}

template <uint32_t fixed_size>
void BlockTridiagonal::substitute_block(uint32_t i, uint32_t next, const double* border, bool has_next) {
    const uint32_t b = fixed_size ? fixed_size : size_;
    const double* const d = diagonal(i);
    const double* const inverse = inverse_pivots_[i];
    const double* const after = has_next ? right_[next] : nullptr;
    const double* const first = right_[0];
    double* const right = right_side(i);
    for (uint32_t j = 0; j < b; ++j) {
        double sum = right[j];
        if (has_next) {
            const double* const row = coupling(i) + j * b;
            for (uint32_t c = 0; c < b; ++c) sum -= row[c] * after[c];
        }
        if (border) {
            for (uint32_t c = 0; c < b; ++c) sum -= border[j * b + c] * first[c];
        }
        right[j] = sum * inverse[j];
    }
    for (uint32_t j = b; j-- > 0;) {
        for (uint32_t r = j + 1; r < b; ++r) right[j] -= d[r * b + j] * right[r];
    }
}

// The sizes of curves on surfaces in R^3, of barriers over the plane, surfaces and space, image manifolds and rotations
// have their own code.
void BlockTridiagonal::dispatch_eliminate(uint32_t i, uint32_t next, double* border, double* next_border,
                                          bool has_next) {
    switch (size_) {
        case 2: return eliminate_block<2>(i, next, border, next_border, has_next);
        case 5: return eliminate_block<5>(i, next, border, next_border, has_next);
        case 6: return eliminate_block<6>(i, next, border, next_border, has_next);
        case 7: return eliminate_block<7>(i, next, border, next_border, has_next);
        case 8: return eliminate_block<8>(i, next, border, next_border, has_next);
        case 12: return eliminate_block<12>(i, next, border, next_border, has_next);
        default: return eliminate_block<0>(i, next, border, next_border, has_next);
    }
}

void BlockTridiagonal::dispatch_substitute(uint32_t i, uint32_t next, const double* border, bool has_next) {
    switch (size_) {
        case 2: return substitute_block<2>(i, next, border, has_next);
        case 5: return substitute_block<5>(i, next, border, has_next);
        case 6: return substitute_block<6>(i, next, border, has_next);
        case 7: return substitute_block<7>(i, next, border, has_next);
        case 8: return substitute_block<8>(i, next, border, has_next);
        case 12: return substitute_block<12>(i, next, border, has_next);
        default: return substitute_block<0>(i, next, border, has_next);
    }
}

void BlockTridiagonal::eliminate(uint32_t k) {
    if (k == 0) {
        negative_ = 0;
        singular_ = false;
    }
    if (!cyclic_) return dispatch_eliminate(k, k + 1, nullptr, nullptr, k + 1 < blocks_);
    const uint32_t i = k + 1;
    if (i == blocks_) return dispatch_eliminate(0, 0, nullptr, nullptr, false);
    const bool has_next = i + 1 < blocks_;
    double* const own = border(i);
    if (i == 1) {
        for (uint32_t r = 0; r < size_; ++r) {
            for (uint32_t c = 0; c < size_; ++c) own[r * size_ + c] = coupling(0)[c * size_ + r];
        }
    }
    if (has_next) {
        std::fill_n(border(i + 1), area_, 0.0);
    } else {
        for (uint32_t e = 0; e < area_; ++e) own[e] += coupling(i)[e];
    }
    dispatch_eliminate(i, i + 1, own, has_next ? border(i + 1) : nullptr, has_next);
}

void BlockTridiagonal::substitute(uint32_t k) {
    const uint32_t i = cyclic_ ? (blocks_ - k) % blocks_ : blocks_ - 1 - k;
    if (cyclic_ && i == 0) return dispatch_substitute(0, 0, nullptr, false);
    dispatch_substitute(i, i + 1, cyclic_ ? border(i) : nullptr, i + 1 < blocks_);
}

}  // namespace flg
