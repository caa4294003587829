// SPDX-License-Identifier: MIT
// A = L L' of sparse positive definite matrices, row by row (up-looking: Davis, Direct Methods for Sparse Linear
// Systems, 2006, chapter 4).
//
// Invariants
// - Column j of L begins with its diagonal entry; rows ascend.
// - A row takes columns in topological order of the elimination tree. Columns that follow each other there and have the
//   same rows below (a supernode: what separates two halves of a mesh is one) are taken up to eight at a time, which is
//   faster than one by one.
#pragma once

#include <span>

#include "linear/symmetric_matrix.h"
#include "runtime/task.h"

namespace flg {

struct CholeskyFactor {
    uint32_t size() const { return static_cast<uint32_t>(order.size()); }
    size_t entries() const { return offsets.empty() ? 0 : offsets[size()]; }

    Buffer<uint32_t> order;   // the row of the matrix at each place
    Buffer<size_t> offsets;   // where each column of L begins, and the end
    Buffer<uint32_t> rows;    // of entries
    Buffer<double> values;    // of entries
    Buffer<double> inverses;  // of the diagonal of L
};

// `order`: the row of the matrix at each place (dissection_order.h). The factor doesn't need the matrix. Takes about 1
// ns a product. Throws if a pivot is below zero by more than rounding: the matrix is not positive definite.
Task<CholeskyFactor> factorize(Pace& pace, const SymmetricMatrix& matrix, Buffer<uint32_t> order);

// Right-hand sides that are solved for at once.
inline constexpr uint32_t solve_width = 8;

// `values[solve_width * i + k]`: entry i of right-hand side k, which the solution replaces.
Task<void> solve(Pace& pace, const CholeskyFactor& factor, std::span<double> values);

}  // namespace flg
