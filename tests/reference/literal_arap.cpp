// SPDX-License-Identifier: MIT
#include "reference/literal_arap.h"

#include <Eigen/SVD>
#include <Eigen/SparseCholesky>
#include <algorithm>

namespace flg::reference {

LiteralArap::LiteralArap(std::vector<Vec3> rest, const std::vector<std::array<uint32_t, 3>>& triangles)
    : rest_(std::move(rest)), at_(rest_), weights_(rest_.size()) {
    for (const auto& t : triangles) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t apex = t[k], i = t[(k + 1) % 3], j = t[(k + 2) % 3];
            const Vec3 a = rest_[i] - rest_[apex], b = rest_[j] - rest_[apex];
            const double half = 0.5 * a.dot(b) / a.cross(b).norm();
            weights_[i][j] += half;
            weights_[j][i] += half;
        }
    }
    // Weights below zero have no energy to speak of.
    for (auto& row : weights_)
        for (auto& [j, weight] : row) weight = std::max(weight, 1e-3);
}

const std::vector<Vec3>& LiteralArap::iterate() {
    const size_t count = rest_.size();
    std::vector<Eigen::Matrix3d> rotations(count);
    for (uint32_t i = 0; i < count; ++i) {
        Eigen::Matrix3d s = Eigen::Matrix3d::Zero();
        for (const auto& [j, weight] : weights_[i]) s += weight * (rest_[i] - rest_[j]) * (at_[i] - at_[j]).transpose();
        const Eigen::JacobiSVD<Eigen::Matrix3d> svd(s, Eigen::ComputeFullU | Eigen::ComputeFullV);
        Eigen::Matrix3d u = svd.matrixU();
        if ((svd.matrixV() * u.transpose()).determinant() < 0) u.col(2) *= -1;
        rotations[i] = svd.matrixV() * u.transpose();
    }
    std::vector<int> row_of(count, -1);
    int rows = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (!fixed_.contains(i)) row_of[i] = rows++;
    Eigen::SparseMatrix<double> matrix(rows, rows);
    Eigen::MatrixX3d right = Eigen::MatrixX3d::Zero(rows, 3);
    std::vector<Eigen::Triplet<double>> entries;
    for (uint32_t i = 0; i < count; ++i) {
        if (row_of[i] < 0) continue;
        for (const auto& [j, weight] : weights_[i]) {
            entries.emplace_back(row_of[i], row_of[i], weight);
            right.row(row_of[i]) += 0.5 * weight * ((rotations[i] + rotations[j]) * (rest_[i] - rest_[j])).transpose();
            if (row_of[j] >= 0)
                entries.emplace_back(row_of[i], row_of[j], -weight);
            else
                right.row(row_of[i]) += weight * fixed_[j].transpose();
        }
    }
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    const Eigen::MatrixX3d solved = solver.solve(right);
    for (uint32_t i = 0; i < count; ++i) at_[i] = row_of[i] < 0 ? fixed_[i] : Vec3(solved.row(row_of[i]));
    return at_;
}

}  // namespace flg::reference
