// SPDX-License-Identifier: MIT
// A = L L' of sparse positive definite matrices, row by row (up-looking: Davis, Direct Methods for Sparse Linear Systems, 2006,
// chapter 4), in units small enough to stop between any two of them.
//
// Invariants
// - Column j of L begins with its diagonal entry; rows ascend.
// - The row that is being made takes columns in topological order of the elimination tree. Columns that follow each other there
//   and have the same rows below (a supernode: what separates two halves of a mesh is one) are taken up to eight at a
//   time, which is what makes it faster than one by one.
#pragma once

#include <span>

#include "inflation/symmetric_matrix.h"

namespace flg {

class SparseCholesky {
public:
    // `order`: the row of the matrix at each place (dissection_order.h). The matrix outlives the factorization, not the factor.
    SparseCholesky(const SymmetricMatrix& matrix, Buffer<uint32_t> order, Memory* memory);

    // A unit is about 0.3 us. Throws if a pivot is below zero by more than
    // rounding: the matrix is not positive definite.
    bool run(uint32_t count);

    uint32_t size() const { return static_cast<uint32_t>(order_.size()); }
    size_t entries() const { return columns_.empty() ? 0 : columns_[size()]; }

private:
    friend class CholeskySolve;
    enum class Pass { invert, tree, sum, begin_row, columns, done };

    void step();
    void tree_row(uint32_t row);
    // What they did, in products.
    uint32_t begin_row();
    uint32_t take_columns();

    const SymmetricMatrix& matrix_;
    Memory* memory_;
    Buffer<uint32_t> order_, place_;
    Buffer<uint32_t> parent_, mark_, count_;
    Buffer<size_t> columns_;   // where each column begins, and the end
    Buffer<uint32_t> filled_;  // entries that each column has so far
    Buffer<uint32_t> rows_;
    Buffer<double> values_;
    Buffer<double> inverse_;     // of the diagonal of L
    Buffer<double> row_values_;  // of the row that is being made, by column
    Buffer<uint32_t> reach_;     // its columns in topological order, at the end
    double pivot_ = 0;
    uint32_t reach_at_ = 0;
    Pass pass_ = Pass::invert;
    uint32_t at_ = 0;
};

// Solves for up to eight right-hand sides at once.
class CholeskySolve {
public:
    static constexpr uint32_t width = 8;

    // `values[width * i + k]`: entry i of right-hand side k, replaced by the solution. The factor is done; all outlive the kernel.
    CholeskySolve(const SparseCholesky& factor, std::span<double> values, Memory* memory);

    // A unit is at most about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { gather, forward, backward, scatter, done };

    void forward();
    void backward();

    const SparseCholesky& factor_;
    std::span<double> values_;
    Buffer<double> x_;
    Pass pass_ = Pass::gather;
    uint32_t at_ = 0;
    size_t entry_ = 0;
};

}  // namespace flg
