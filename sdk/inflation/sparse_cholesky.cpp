// SPDX-License-Identifier: MIT
#include "inflation/sparse_cholesky.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"

namespace flg {

namespace {

constexpr uint32_t batch = 32;  // rows a unit where little is done with each
constexpr uint32_t no_parent = UINT32_MAX;
constexpr double lost = 1e-12;  // of the diagonal: what rounding may leave of a pivot

constexpr uint32_t entries_a_unit = 48;  // of a solution
constexpr uint32_t work_a_unit = 128;    // products of a factorization, about

}  // namespace

SparseCholesky::SparseCholesky(const SymmetricMatrix& matrix, Buffer<uint32_t> order, Memory* memory)
    : matrix_(matrix),
      memory_(memory),
      order_(std::move(order)),
      place_(matrix.size(), memory),
      parent_(matrix.size(), memory),
      mark_(matrix.size(), memory),
      count_(matrix.size(), memory),
      columns_(matrix.size() + size_t{1}, memory),
      filled_(matrix.size(), memory),
      inverse_(matrix.size(), memory),
      row_values_(matrix.size(), memory),
      reach_(matrix.size(), memory) {}

bool SparseCholesky::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) step();
    return pass_ == Pass::done;
}

void SparseCholesky::step() {
    const uint32_t n = size();
    const uint32_t stop = std::min(n, at_ + batch);
    switch (pass_) {
        case Pass::invert:
            for (; at_ < stop; ++at_) {
                place_[order_[at_]] = at_;
                parent_[at_] = mark_[at_] = no_parent;
                count_[at_] = 1;
                filled_[at_] = 0;
                row_values_[at_] = 0;
            }
            if (at_ < n) break;
            at_ = 0;
            pass_ = Pass::tree;
            break;
        case Pass::tree:
            if (at_ < n) {
                tree_row(at_++);
                break;
            }
            at_ = 0;
            columns_[0] = 0;
            pass_ = Pass::sum;
            break;
        case Pass::sum:
            for (; at_ < stop; ++at_) {
                columns_[at_ + 1] = columns_[at_] + count_[at_];
                mark_[at_] = no_parent;
            }
            if (at_ < n) break;
            rows_ = Buffer<uint32_t>(columns_[n], memory_);
            values_ = Buffer<double>(columns_[n], memory_);
            at_ = 0;
            pass_ = Pass::begin_row;
            break;
        case Pass::begin_row:
        case Pass::columns:
            for (uint32_t work = 0; work < work_a_unit && pass_ != Pass::done;)
                work += pass_ == Pass::columns ? take_columns() : begin_row();
            break;
        case Pass::done: break;
    }
}

// Entries of L in a row are those on the ways up the tree from the entries of A in it.
void SparseCholesky::tree_row(uint32_t row) {
    const uint32_t original = order_[row];
    mark_[row] = row;
    for (uint32_t e = matrix_.offsets[original]; e < matrix_.offsets[original + 1]; ++e) {
        for (uint32_t i = place_[matrix_.columns[e]]; i < row && mark_[i] != row; i = parent_[i]) {
            if (parent_[i] == no_parent) parent_[i] = row;
            ++count_[i];
            mark_[i] = row;
        }
    }
}

uint32_t SparseCholesky::begin_row() {
    if (at_ == size()) {
        pass_ = Pass::done;
        return 0;
    }
    const uint32_t original = order_[at_];
    uint32_t top = size();
    mark_[at_] = at_;
    for (uint32_t e = matrix_.offsets[original]; e < matrix_.offsets[original + 1]; ++e) {
        const uint32_t column = place_[matrix_.columns[e]];
        if (column > at_) continue;
        row_values_[column] = matrix_.values[e];
        // The way up is written at the front of reach_, then moved before what is there.
        uint32_t length = 0;
        for (uint32_t i = column; mark_[i] != at_; i = parent_[i]) {
            reach_[length++] = i;
            mark_[i] = at_;
        }
        while (length > 0) reach_[--top] = reach_[--length];
    }
    pivot_ = matrix_.diagonal[original];
    reach_at_ = top;
    pass_ = Pass::columns;
    return size() - top;
}

// Takes the next one to four or eight columns out of the row; at their end writes the diagonal.
uint32_t SparseCholesky::take_columns() {
    if (reach_at_ == size()) {
        // Below the rounding of what was taken from it nothing is known of a pivot: a trace of the diagonal takes its place.
        const double diagonal = matrix_.diagonal[order_[at_]];
        if (std::abs(pivot_) <= lost * diagonal) pivot_ = lost * diagonal;
        if (!(pivot_ > 0))
            throw Failure(FLG_ERROR_INTERNAL, "cholesky: pivot %u of %u is %g, not above zero", at_, size(), pivot_);
        const size_t place = columns_[at_];
        rows_[place] = at_;
        values_[place] = std::sqrt(pivot_);
        inverse_[at_] = 1 / values_[place];
        filled_[at_] = 1;
        ++at_;
        pass_ = Pass::begin_row;
        return 4;
    }
    const uint32_t first = reach_[reach_at_];
    uint32_t length = 1;
    while (length < 8 && reach_at_ + length < size() && reach_[reach_at_ + length] == first + length &&
           parent_[first + length - 1] == first + length && count_[first + length - 1] == count_[first + length] + 1)
        ++length;
    if (length > 4 && length < 8) length = 4;
    double factors[8];
    const double* entries[8];
    for (uint32_t k = 0; k < length; ++k) {
        const uint32_t column = first + k;
        const size_t begin = columns_[column];
        double value = row_values_[column];
        for (uint32_t m = 0; m < k; ++m) value -= factors[m] * values_[columns_[first + m] + (k - m)];
        value *= inverse_[column];
        factors[k] = value;
        row_values_[column] = 0;
        pivot_ -= value * value;
        entries[k] = values_.data() + begin + (length - k);
    }
    // All have the same rows after the last of them, and as many of them so far.
    const uint32_t last = first + length - 1, below = filled_[last] - 1;
    const uint32_t* rows = rows_.data() + columns_[last] + 1;
    double* out = row_values_.data();
    switch (length) {
        case 1:
            for (uint32_t p = 0; p < below; ++p) out[rows[p]] -= entries[0][p] * factors[0];
            break;
        case 2:
            for (uint32_t p = 0; p < below; ++p)
                out[rows[p]] -= entries[0][p] * factors[0] + entries[1][p] * factors[1];
            break;
        case 3:
            for (uint32_t p = 0; p < below; ++p)
                out[rows[p]] -= entries[0][p] * factors[0] + entries[1][p] * factors[1] + entries[2][p] * factors[2];
            break;
        case 4:
            for (uint32_t p = 0; p < below; ++p)
                out[rows[p]] -= (entries[0][p] * factors[0] + entries[1][p] * factors[1]) +
                                (entries[2][p] * factors[2] + entries[3][p] * factors[3]);
            break;
        default:
            for (uint32_t p = 0; p < below; ++p)
                out[rows[p]] -= ((entries[0][p] * factors[0] + entries[1][p] * factors[1]) +
                                 (entries[2][p] * factors[2] + entries[3][p] * factors[3])) +
                                ((entries[4][p] * factors[4] + entries[5][p] * factors[5]) +
                                 (entries[6][p] * factors[6] + entries[7][p] * factors[7]));
            break;
    }
    for (uint32_t k = 0; k < length; ++k) {
        const size_t place = columns_[first + k] + filled_[first + k]++;
        rows_[place] = at_;
        values_[place] = factors[k];
    }
    reach_at_ += length;
    return 8 + below * length;
}

CholeskySolve::CholeskySolve(const SparseCholesky& factor, std::span<double> values, Memory* memory)
    : factor_(factor), values_(values), x_(size_t{width} * factor.size(), memory) {}

bool CholeskySolve::run(uint32_t count) {
    const uint32_t n = factor_.size();
    for (; count > 0 && pass_ != Pass::done; --count) {
        switch (pass_) {
            case Pass::gather:
                for (const uint32_t stop = std::min(n, at_ + batch); at_ < stop; ++at_)
                    std::copy_n(&values_[size_t{width} * factor_.order_[at_]], width, &x_[size_t{width} * at_]);
                if (at_ < n) break;
                at_ = 0;
                pass_ = Pass::forward;
                break;
            case Pass::forward:
                if (at_ == n) {
                    pass_ = Pass::backward;
                } else {
                    forward();
                }
                break;
            case Pass::backward:
                if (at_ == 0 && entry_ == 0) {
                    pass_ = Pass::scatter;
                } else {
                    backward();
                }
                break;
            case Pass::scatter:
                for (const uint32_t stop = std::min(n, at_ + batch); at_ < stop; ++at_)
                    std::copy_n(&x_[size_t{width} * at_], width, &values_[size_t{width} * factor_.order_[at_]]);
                if (at_ == n) pass_ = Pass::done;
                break;
            case Pass::done: break;
        }
    }
    return pass_ == Pass::done;
}

// Some entries of a column; entry_ is where it goes on, 0 at its beginning.
void CholeskySolve::forward() {
    const size_t begin = factor_.columns_[at_], end = factor_.columns_[at_ + 1];
    double* x = &x_[size_t{width} * at_];
    if (entry_ == 0) {
        const double pivot = factor_.inverse_[at_];
        for (uint32_t k = 0; k < width; ++k) x[k] *= pivot;
        entry_ = begin + 1;
    }
    double own[width];
    std::copy_n(x, width, own);
    for (const size_t stop = std::min(end, entry_ + entries_a_unit); entry_ < stop; ++entry_) {
        double* to = &x_[size_t{width} * factor_.rows_[entry_]];
        const double entry = factor_.values_[entry_];
        for (uint32_t k = 0; k < width; ++k) to[k] -= entry * own[k];
    }
    if (entry_ < end) return;
    entry_ = 0;
    ++at_;
}

void CholeskySolve::backward() {
    if (entry_ == 0) entry_ = factor_.columns_[--at_] + 1;
    const size_t end = factor_.columns_[at_ + 1];
    double* x = &x_[size_t{width} * at_];
    double own[width];
    std::copy_n(x, width, own);
    for (const size_t stop = std::min(end, entry_ + entries_a_unit); entry_ < stop; ++entry_) {
        const double* from = &x_[size_t{width} * factor_.rows_[entry_]];
        const double entry = factor_.values_[entry_];
        for (uint32_t k = 0; k < width; ++k) own[k] -= entry * from[k];
    }
    const bool whole = entry_ == end;
    const double pivot = whole ? factor_.inverse_[at_] : 1;
    for (uint32_t k = 0; k < width; ++k) x[k] = own[k] * pivot;
    if (whole) entry_ = 0;
}

}  // namespace flg
