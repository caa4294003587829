// SPDX-License-Identifier: MIT
// Symmetric systems of equations whose unknowns form a chain of equal blocks, each coupled with the next, and in a
// cycle the last with the first: L D L^T without pivoting, block by block, so that time and memory grow with the number
// of blocks.
//
// Good for systems that are definite, or quasi-definite in the order given (unknowns of negative pivots before those of
// positive ones that depend on them). The signs of the pivots tell the inertia (Sylvester), so who needs positive
// curvature asks for it.
#pragma once

#include <cstdint>

#include "core/row_blocks.h"

namespace flg {

class BlockTridiagonal {
public:
    // `size`: unknowns a block, at least 1; at least 3 blocks in a cycle, 1 otherwise.
    BlockTridiagonal(uint32_t blocks, uint32_t size, bool cyclic, Memory* memory);

    uint32_t size() const { return size_; }

    // To be written whole before block i is eliminated; then they are used up. Rows of `size` numbers. Of the diagonal
    // block only the lower triangle is read. Coupling: rows are unknowns of block i, columns those of the block after
    // it.
    double* diagonal(uint32_t i) { return diagonal_.make(i); }
    double* coupling(uint32_t i) { return coupling_.make(i); }
    double* right_side(uint32_t i) { return right_.make(i); }

    // The k-th step of elimination, for k = 0 to blocks - 1 in turn; of substitution, for the same k after that. About
    // 2.3 size^3 (5 in a cycle) and 3 size^2 multiplications.
    void eliminate(uint32_t k);
    void substitute(uint32_t k);

    // After elimination: how many pivots are below 0. A pivot that is 0 or not finite makes the system singular.
    uint32_t negative_pivots() const { return negative_; }
    bool is_singular() const { return singular_; }
    // After block i was substituted.
    const double* solution(uint32_t i) const { return right_[i]; }

    // Calls give(rows) for each of its parts: to give their memory back in slices.
    template <class Give>
    void each_part(const Give& give) {
        for (RowBlocks<double>* rows : {&diagonal_, &coupling_, &border_, &right_, &inverse_pivots_}) give(*rows);
    }

private:
    template <uint32_t fixed_size>
    void eliminate_block(uint32_t i, uint32_t next, double* border, double* next_border, bool has_next);
    template <uint32_t fixed_size>
    void substitute_block(uint32_t i, uint32_t next, const double* border, bool has_next);
    void dispatch_eliminate(uint32_t i, uint32_t next, double* border, double* next_border, bool has_next);
    void dispatch_substitute(uint32_t i, uint32_t next, const double* border, bool has_next);
    double* border(uint32_t i) { return border_.make(i); }

    uint32_t blocks_, size_, area_;
    bool cyclic_;
    // In a cycle block 0 comes last, and `border` is what couples each block with it.
    RowBlocks<double> diagonal_, coupling_, border_, right_, inverse_pivots_;
    uint32_t negative_ = 0;
    bool singular_ = false;
};

}  // namespace flg
