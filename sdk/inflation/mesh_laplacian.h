// SPDX-License-Identifier: MIT
// The Laplacian of a triangle mesh by linear elements, as a matrix to solve with: positive semidefinite (it is -div
// grad), rows sum to zero but for Dirichlet vertices and masses. The weight of an edge is half the sum of the
// cotangents across from it (Pinkall, Polthier: Computing discrete minimal surfaces, 1993).
//
//     A_ij = - s_ij w_ij       A_ii = m_i + sum over all neighbours j of s_ij w_ij       s_ij = (s_i + s_j) / 2
#pragma once

#include <array>
#include <span>

#include "core/vec.h"
#include "linear/sparse_cholesky.h"

namespace flg {

using TriangleVertices = std::array<uint32_t, 3>;

inline constexpr uint32_t no_row = UINT32_MAX;  // of vertices whose value is given, as zero

struct LaplacianInput {
    std::span<const TriangleVertices> triangles;
    std::span<const std::array<double, 3>> cotangents;  // half of them, at the corners
    std::span<const uint32_t> row_of_vertex = {};       // ascending but for no_row; empty: each vertex its number
    uint32_t row_count = 0;
    std::span<const double> mass = {};   // a row; empty: 0
    std::span<const double> scale = {};  // s, a row; empty: 1
    // Weights are made at least this: above zero A is an M-matrix, whose inverse has no negative entries. The default
    // leaves them as they are.
    double min_weight = -1e300;
};

// Takes about 0.2 us and 48 bytes a corner.
Task<SymmetricMatrix> mesh_laplacian(Pace& pace, LaplacianInput input);

// The factor of that matrix, to solve with. `places`: one a row. Takes about 1.3 us a row of a mesh of 10,000 vertices.
Task<CholeskyFactor> factorize_laplacian(Pace& pace, LaplacianInput input, std::span<const Vec3> places);

}  // namespace flg
