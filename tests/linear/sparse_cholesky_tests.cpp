// SPDX-License-Identifier: MIT
#include "linear/sparse_cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/SparseCholesky>

#include "core/failure.h"
#include "core/random.h"
#include "linear/dissection_order.h"
#include "runtime/run_now.h"

namespace flg::test {
namespace {

Memory* test_memory() {
    return std::pmr::new_delete_resource();
}

struct Problem {
    SymmetricMatrix matrix;
    std::vector<Vec3> places;
};

// Laplacian of a grid with both diagonals, with random weights and a little mass.
Problem grid(uint32_t width, uint32_t height, double mass = 0.01) {
    Problem problem;
    std::vector<uint32_t> offsets = {0}, columns;
    std::vector<double> values, diagonal;
    for (uint32_t i = 0; i < width * height; ++i) {
        const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
        problem.places.emplace_back(x, y, 0);
        double sum = mass;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int u = x + dx, v = y + dy;
                if ((dx == 0 && dy == 0) || u < 0 || v < 0 || u >= static_cast<int>(width) ||
                    v >= static_cast<int>(height))
                    continue;
                const auto j = static_cast<uint32_t>(v) * width + static_cast<uint32_t>(u);
                const double weight = 0.1 + random_unit(1, std::min(i, j), std::max(i, j));
                columns.push_back(j);
                values.push_back(-weight);
                sum += weight;
            }
        offsets.push_back(static_cast<uint32_t>(columns.size()));
        diagonal.push_back(sum);
    }
    const auto copy = [](const auto& from, auto& to) {
        to = std::remove_reference_t<decltype(to)>(from.size(), test_memory());
        std::copy(from.begin(), from.end(), to.begin());
    };
    copy(offsets, problem.matrix.offsets);
    copy(columns, problem.matrix.columns);
    copy(values, problem.matrix.values);
    copy(diagonal, problem.matrix.diagonal);
    return problem;
}

struct Solution {
    std::vector<double> values;
    size_t entries;  // of the factor
};

Task<Solution> solution_of(Pace& pace, const Problem& problem, const std::vector<double>& right) {
    Buffer<uint32_t> order = co_await dissection_order(pace, problem.matrix, problem.places);
    const CholeskyFactor factor = co_await factorize(pace, problem.matrix, std::move(order));
    Solution solution{right, factor.entries()};
    co_await solve(pace, factor, solution.values);
    co_return solution;
}

std::vector<double> solved(const Problem& problem, const std::vector<double>& right, bool haltingly = false,
                           size_t* entries = nullptr) {
    const auto make = [&](Pace& pace) { return solution_of(pace, problem, right); };
    Solution solution = run_now(test_memory(), make, haltingly);
    if (entries) *entries = solution.entries;
    return solution.values;
}

std::vector<double> random_right(uint32_t rows) {
    std::vector<double> right;
    for (uint32_t i = 0; i < solve_width * rows; ++i) right.push_back(random_unit(2, i, 0) - 0.5);
    return right;
}

Eigen::SparseMatrix<double> as_eigen(const SymmetricMatrix& matrix) {
    std::vector<Eigen::Triplet<double>> triplets;
    for (uint32_t i = 0; i < matrix.size(); ++i) {
        triplets.emplace_back(i, i, matrix.diagonal[i]);
        for (uint32_t e = matrix.offsets[i]; e < matrix.offsets[i + 1]; ++e)
            triplets.emplace_back(i, matrix.columns[e], matrix.values[e]);
    }
    Eigen::SparseMatrix<double> all(matrix.size(), matrix.size());
    all.setFromTriplets(triplets.begin(), triplets.end());
    return all;
}

TEST(SparseCholesky, AgreesWithEigen) {
    for (const auto& [width, height] : {std::pair{1u, 1u}, {2u, 1u}, {7u, 5u}, {40u, 3u}, {60u, 50u}}) {
        const Problem problem = grid(width, height);
        const auto right = random_right(problem.matrix.size());
        size_t entries = 0;
        const auto x = solved(problem, right, false, &entries);
        Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> eigen(as_eigen(problem.matrix));
        using Rows = Eigen::Matrix<double, Eigen::Dynamic, solve_width, Eigen::RowMajor>;
        const Eigen::MatrixXd expected = eigen.solve(Eigen::Map<const Rows>(right.data(), problem.matrix.size(), 8));
        const double scale = expected.cwiseAbs().maxCoeff();
        EXPECT_LT((Eigen::Map<const Rows>(x.data(), problem.matrix.size(), 8) - expected).cwiseAbs().maxCoeff(),
                  1e-11 * scale);
        // The order is about as good as minimum degree.
        const auto peer = static_cast<double>(eigen.matrixL().nestedExpression().nonZeros());
        EXPECT_LT(static_cast<double>(entries), 1.35 * peer + 100) << width << " " << height;
    }
}

TEST(SparseCholesky, SameBitsWithPauses) {
    const Problem problem = grid(23, 17);
    const auto right = random_right(problem.matrix.size());
    EXPECT_EQ(solved(problem, right), solved(problem, right, true));
}

TEST(SparseCholesky, RefusesWhatIsNotPositiveDefinite) {
    const Problem problem = grid(5, 5, -1);
    EXPECT_THROW(solved(problem, random_right(25)), Failure);
}

TEST(DissectionOrder, IsAPermutation) {
    const Problem problem = grid(31, 9);
    const Buffer<uint32_t> order = run_haltingly(
        test_memory(), [&](Pace& pace) { return dissection_order(pace, problem.matrix, problem.places); });
    std::vector<bool> seen(order.size());
    for (const uint32_t row : order) {
        ASSERT_LT(row, order.size());
        EXPECT_FALSE(seen[row]);
        seen[row] = true;
    }
}

TEST(DissectionOrder, TakesRowsAtOnePlace) {
    Problem problem = grid(9, 9);
    for (Vec3& place : problem.places) place.setZero();
    const auto right = random_right(81);
    EXPECT_EQ(solved(problem, right).size(), right.size());
}

}  // namespace
}  // namespace flg::test
