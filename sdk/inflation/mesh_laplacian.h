// SPDX-License-Identifier: MIT
// The Laplacian of a triangle mesh by linear elements, as a matrix to solve with: positive semidefinite (it is -div grad), rows
// sum to zero but for Dirichlet vertices and masses. The weight of an edge is half the sum of the cotangents across from it
// (Pinkall, Polthier: Computing discrete minimal surfaces, 1993).
//
//     A_ij = - s_ij w_ij       A_ii = m_i + sum over all neighbours j of s_ij w_ij       s_ij = (s_i + s_j) / 2
#pragma once

#include <array>
#include <span>

#include "inflation/symmetric_matrix.h"

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
    // Weights are made at least this: above zero A is an M-matrix, whose inverse has no negative entries. Left as they are with
    // the default.
    double least_weight = -1e300;
};

class MeshLaplacian {
public:
    // What the spans show outlives the kernel, and `out` too. Memory is taken at once: about 24 bytes a corner.
    MeshLaplacian(const LaplacianInput& input, SymmetricMatrix& out, Memory* memory);

    // A unit is about 0.2 us: 16 corners, or a row.
    bool run(uint32_t count);

private:
    enum class Pass { clear, count, sum, scatter, row, done };
    struct Entry {
        uint32_t vertex;
        double weight;
    };

    uint32_t row_of(uint32_t vertex) const {
        return input_.row_of_vertex.empty() ? vertex : input_.row_of_vertex[vertex];
    }
    template <class Action>
    void each_edge(uint32_t triangle, const Action& action) const;
    void finish_row();

    LaplacianInput input_;
    SymmetricMatrix& out_;
    Buffer<uint32_t> offsets_;
    Buffer<Entry> entries_;
    uint32_t written_ = 0;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
