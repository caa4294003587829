// SPDX-License-Identifier: MIT
// What pulling at a surface needs of the surface alone, made once: as-rigid-as-possible deformation (Sorkine, Alexa:
// As-rigid-as-possible surface modeling, 2007) minimizes
//
//     E(x) = sum over i and neighbours j of w_ij |(x_i - x_j) - R_i (q_i - q_j)|^2
//
// with cotangent weights w, rest positions q and a rotation R_i per vertex; positions solve a linear system whose
// matrix depends on w alone.
//
// Departures: the weights of edges are at least a little above zero, so E is never negative. The matrix has a mass of a
// thousand millionth on its diagonal, which draws positions to where they were: it is definite without handles, and one
// factor serves all of them. Handles are constraints (pulling.h).
#pragma once

#include <array>
#include <span>

#include "linear/sparse_cholesky.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

struct PullSystem {
    uint32_t count() const { return factor.size(); }
    double mass(uint32_t place) const { return masses[place]; }
    double size = 0;  // metres: the diagonal of the box around the mesh

    // Vertices in the order in which they are eliminated.
    CholeskyFactor factor;
    Buffer<uint32_t> place_of;             // by vertex of the mesh
    Buffer<Vec3> rest;                     // by place: where it is at rest
    Buffer<double> masses;                 // by place: shares of the area
    Buffer<uint32_t> offsets, neighbours;  // by place: where its neighbours begin; their places
    Buffer<float> weights;                 // by neighbour: w
};

// About 5 us a vertex, and 0.5 KB.
Task<PullSystem> make_pull_system(Pace& pace, const Mesh& mesh);

// Solves for points: four numbers each, in the order of elimination, in place and without memory. About 0.1 us a vertex
// of 10,000.
Task<void> solve_points(Pace& pace, const CholeskyFactor& factor, std::span<double> values);

}  // namespace flg
