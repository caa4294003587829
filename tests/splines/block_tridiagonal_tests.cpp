// SPDX-License-Identifier: MIT
// Chains of blocks against dense matrices.
#include "linear/block_tridiagonal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace flg::test {
namespace {

void expect_dense_agreement(uint32_t blocks, uint32_t size, bool cyclic, bool indefinite) {
    std::mt19937 random(blocks * 100 + size);
    std::normal_distribution<double> draw;
    const uint32_t all = blocks * size;
    Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(all, all);
    Eigen::VectorXd right(all);
    BlockTridiagonal system(blocks, size, cyclic, std::pmr::new_delete_resource());
    for (uint32_t i = 0; i < all; ++i) right[i] = draw(random);
    for (uint32_t b = 0; b < blocks; ++b) {
        const uint32_t next = (b + 1) % blocks;
        for (uint32_t r = 0; r < size; ++r) {
            system.right_side(b)[r] = right[b * size + r];
            for (uint32_t c = 0; c <= r; ++c) {
                // Rows of the first half have negative pivots.
                double value = draw(random);
                if (r == c) value = (indefinite && r < size / 2 ? -1 : 1) * 6.0 * size;
                system.diagonal(b)[r * size + c] = dense(b * size + r, b * size + c) =
                    dense(b * size + c, b * size + r) = value;
            }
            for (uint32_t c = 0; c < size; ++c) {
                const double value = draw(random);
                system.coupling(b)[r * size + c] = value;
                if (!cyclic && b + 1 == blocks) continue;
                dense(b * size + r, next * size + c) = dense(next * size + c, b * size + r) = value;
            }
        }
    }
    for (uint32_t k = 0; k < blocks; ++k) system.eliminate(k);
    for (uint32_t k = 0; k < blocks; ++k) system.substitute(k);
    const Eigen::VectorXd exact = dense.fullPivLu().solve(right);
    for (uint32_t i = 0; i < all; ++i) EXPECT_NEAR(system.solution(i / size)[i % size], exact[i], 1e-12);
    EXPECT_FALSE(system.is_singular());
    const Eigen::VectorXd eigenvalues = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense).eigenvalues();
    EXPECT_EQ(system.negative_pivots(), static_cast<uint32_t>((eigenvalues.array() < 0).count()));
}

TEST(BlockTridiagonal, SolvesWhatADenseMatrixSaysAndCountsNegativePivots) {
    for (const uint32_t size : {1u, 2u, 3u, 5u, 7u, 8u, 12u, 13u}) {
        for (const bool indefinite : {false, true}) {
            expect_dense_agreement(6, size, false, indefinite);
            expect_dense_agreement(6, size, true, indefinite);
            expect_dense_agreement(3, size, true, indefinite);
            expect_dense_agreement(1, size, false, indefinite);
        }
    }
}

TEST(BlockTridiagonal, SaysSoWhenThereIsNoSolution) {
    BlockTridiagonal system(2, 1, false, std::pmr::new_delete_resource());
    for (uint32_t b = 0; b < 2; ++b) *system.diagonal(b) = *system.coupling(b) = *system.right_side(b) = 1;
    system.eliminate(0);
    system.eliminate(1);
    EXPECT_TRUE(system.is_singular());
}

}  // namespace
}  // namespace flg::test
