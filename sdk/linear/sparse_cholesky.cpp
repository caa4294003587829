// SPDX-License-Identifier: MIT
#include "linear/sparse_cholesky.h"

#include <algorithm>
#include <cmath>

#include "core/failure.h"
#include "runtime/each.h"

namespace flg {

namespace {

constexpr uint32_t no_parent = UINT32_MAX;
constexpr double lost = 1e-12;  // of the diagonal: what rounding may leave of a pivot

class Factorization {
public:
    Factorization(const SymmetricMatrix& matrix, CholeskyFactor& out, Memory* memory)
        : matrix_(matrix),
          out_(out),
          place_(matrix.size(), memory),
          parent_(matrix.size(), memory),
          mark_(matrix.size(), memory),
          count_(matrix.size(), memory),
          filled_(matrix.size(), memory),
          row_values_(matrix.size(), memory),
          reach_(matrix.size(), memory) {}

    void clear(uint32_t row) {
        place_[out_.order[row]] = row;
        parent_[row] = mark_[row] = no_parent;
        count_[row] = 1;
        filled_[row] = 0;
        row_values_[row] = 0;
    }

    // Entries of L in a row are those on the ways up the tree from the entries of A in it. Returns how many.
    uint32_t climb(uint32_t row) {
        const uint32_t original = out_.order[row];
        uint32_t entries = 1;
        mark_[row] = row;
        for (uint32_t e = matrix_.offsets[original]; e < matrix_.offsets[original + 1]; ++e) {
            for (uint32_t i = place_[matrix_.columns[e]]; i < row && mark_[i] != row; i = parent_[i]) {
                if (parent_[i] == no_parent) parent_[i] = row;
                ++count_[i];
                ++entries;
                mark_[i] = row;
            }
        }
        return entries;
    }

    void end_column(uint32_t column) {
        out_.offsets[column + 1] = out_.offsets[column] + count_[column];
        mark_[column] = no_parent;
    }

    // Work is told in products.
    uint32_t begin_row(uint32_t row) {
        const uint32_t original = out_.order[row];
        uint32_t top = out_.size();
        mark_[row] = row;
        for (uint32_t e = matrix_.offsets[original]; e < matrix_.offsets[original + 1]; ++e) {
            const uint32_t column = place_[matrix_.columns[e]];
            if (column > row) continue;
            row_values_[column] = matrix_.values[e];
            // The way up is written at the front of reach_, then moved before what is there.
            uint32_t length = 0;
            for (uint32_t i = column; mark_[i] != row; i = parent_[i]) {
                reach_[length++] = i;
                mark_[i] = row;
            }
            while (length > 0) reach_[--top] = reach_[--length];
        }
        row_ = row;
        pivot_ = matrix_.diagonal[original];
        reach_at_ = top;
        return out_.size() - top;
    }

    bool row_has_more() const { return reach_at_ < out_.size(); }

    // Takes the next columns out of the row until that was about as many products, or all. Returns how many.
    uint32_t take_columns(uint32_t products) {
        uint32_t done = 0;
        while (row_has_more() && done < products) done += take_supernode();
        return done;
    }

    uint32_t end_row() {
        // Below the rounding of what was taken from it nothing is known of a pivot: a trace of the diagonal takes its
        // place.
        const double diagonal = matrix_.diagonal[out_.order[row_]];
        if (std::abs(pivot_) <= lost * diagonal) pivot_ = lost * diagonal;
        if (!(pivot_ > 0))
            throw Failure(FLG_ERROR_INTERNAL, "cholesky: pivot %u of %u is %g, not above zero", row_, out_.size(),
                          pivot_);
        const size_t place = out_.offsets[row_];
        out_.rows[place] = row_;
        out_.values[place] = std::sqrt(pivot_);
        out_.inverses[row_] = 1 / out_.values[place];
        filled_[row_] = 1;
        return 4;
    }

private:
    // The next one to four or eight columns.
    uint32_t take_supernode() {
        const uint32_t first = reach_[reach_at_];
        uint32_t length = 1;
        while (length < 8 && reach_at_ + length < out_.size() && reach_[reach_at_ + length] == first + length &&
               parent_[first + length - 1] == first + length &&
               count_[first + length - 1] == count_[first + length] + 1)
            ++length;
        if (length > 4 && length < 8) length = 4;
        double factors[8];
        const double* entries[8];
        for (uint32_t k = 0; k < length; ++k) {
            const uint32_t column = first + k;
            double value = row_values_[column];
            for (uint32_t m = 0; m < k; ++m) value -= factors[m] * out_.values[out_.offsets[first + m] + (k - m)];
            value *= out_.inverses[column];
            factors[k] = value;
            row_values_[column] = 0;
            pivot_ -= value * value;
            entries[k] = out_.values.data() + out_.offsets[column] + (length - k);
        }
        // All have the same rows after the last of them, and as many of them so far.
        const uint32_t last = first + length - 1, below = filled_[last] - 1;
        const uint32_t* rows = out_.rows.data() + out_.offsets[last] + 1;
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
                    out[rows[p]] -=
                        entries[0][p] * factors[0] + entries[1][p] * factors[1] + entries[2][p] * factors[2];
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
            const size_t place = out_.offsets[first + k] + filled_[first + k]++;
            out_.rows[place] = row_;
            out_.values[place] = factors[k];
        }
        reach_at_ += length;
        return 8 + below * length;
    }

    const SymmetricMatrix& matrix_;
    CholeskyFactor& out_;
    Buffer<uint32_t> place_;          // of each row of the matrix in the order
    Buffer<uint32_t> parent_, mark_;  // in the elimination tree; the row that last came by
    Buffer<uint32_t> count_;          // entries of each column
    Buffer<uint32_t> filled_;         // entries that each column has so far
    Buffer<double> row_values_;       // of the row that is being made, by column
    Buffer<uint32_t> reach_;          // its columns in topological order, at the end
    uint32_t row_ = 0, reach_at_ = 0;
    double pivot_ = 0;
};

}  // namespace

Task<CholeskyFactor> factorize(Pace& pace, const SymmetricMatrix& matrix, Buffer<uint32_t> order) {
    Memory* memory = pace.memory();
    const uint32_t size = matrix.size();
    CholeskyFactor factor;
    factor.order = std::move(order);
    factor.offsets = Buffer<size_t>(size + size_t{1}, memory);
    factor.inverses = Buffer<double>(size, memory);
    Factorization rows(matrix, factor, memory);
    co_await each(pace, size, Cost::some_ns, [&](uint32_t row) { rows.clear(row); });
    co_await each_by_work(pace, size, Cost::some_ns, [&](uint32_t row) { return rows.climb(row); });
    factor.offsets[0] = 0;
    co_await each(pace, size, Cost::some_ns, [&](uint32_t column) { rows.end_column(column); });
    factor.rows = Buffer<uint32_t>(factor.offsets[size], memory);
    factor.values = Buffer<double>(factor.offsets[size], memory);
    Slice slice(Cost::some_ns);
    for (uint32_t row = 0; row < size; ++row) {
        uint32_t work = rows.begin_row(row);
        while (rows.row_has_more()) {
            if (slice.is_over(work)) co_await pace;
            work = rows.take_columns(slice.left());
        }
        if (slice.is_over(work + rows.end_row())) co_await pace;
    }
    co_return factor;
}

Task<void> solve(Pace& pace, const CholeskyFactor& factor, std::span<double> values) {
    const uint32_t size = factor.size();
    Buffer<double> solution(size_t{solve_width} * size, pace.memory());
    double* const x = solution.data();
    const auto entries_of = [&](uint32_t column) {
        return static_cast<uint32_t>(factor.offsets[column + 1] - factor.offsets[column]);
    };
    co_await each(pace, size, Cost::tens_of_ns, [&, x](uint32_t i) {
        std::copy_n(&values[size_t{solve_width} * factor.order[i]], solve_width, &x[size_t{solve_width} * i]);
    });
    // L y = b
    co_await each_by_work(pace, size, Cost::some_ns, [&, x](uint32_t column) {
        double own[solve_width];
        for (uint32_t k = 0; k < solve_width; ++k)
            own[k] = x[size_t{solve_width} * column + k] *= factor.inverses[column];
        for (size_t e = factor.offsets[column] + 1; e < factor.offsets[column + 1]; ++e) {
            double* to = &x[size_t{solve_width} * factor.rows[e]];
            for (uint32_t k = 0; k < solve_width; ++k) to[k] -= factor.values[e] * own[k];
        }
        return entries_of(column);
    });
    // L' x = y
    co_await each_by_work(pace, size, Cost::some_ns, [&, x](uint32_t step) {
        const uint32_t column = size - 1 - step;
        double own[solve_width];
        std::copy_n(&x[size_t{solve_width} * column], solve_width, own);
        for (size_t e = factor.offsets[column] + 1; e < factor.offsets[column + 1]; ++e) {
            const double* from = &x[size_t{solve_width} * factor.rows[e]];
            for (uint32_t k = 0; k < solve_width; ++k) own[k] -= factor.values[e] * from[k];
        }
        for (uint32_t k = 0; k < solve_width; ++k)
            x[size_t{solve_width} * column + k] = own[k] * factor.inverses[column];
        return entries_of(column);
    });
    co_await each(pace, size, Cost::tens_of_ns, [&, x](uint32_t i) {
        std::copy_n(&x[size_t{solve_width} * i], solve_width, &values[size_t{solve_width} * factor.order[i]]);
    });
}

}  // namespace flg
