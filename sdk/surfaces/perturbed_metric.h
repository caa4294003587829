// SPDX-License-Identifier: MIT
// Another metric on the same surface, sec. 3.4 of Nazzaro, Puppo, Pellacini: geoTangle (2021): distances are measured as if
// the vertices were moved along their normals by Perlin noise (Perlin: Improving noise, 2002).
// Departure: the gradient of a lattice point is drawn by core/random.h from its seed and place, not from a table of 256.
#pragma once

#include "surfaces/mesh.h"

namespace flg {

// In [-1, 1], 0 at the corners of unit cells, with continuous second derivatives.
double perlin_noise(const Vec3& place, uint64_t seed);

// Vertices move by `amount` metres at most, >= 0; the noise has `frequency` cells a metre, > 0. A unit is a vertex, about 100 ns.
class PerturbedMetricKernel {
public:
    // `normals` of the vertices; all outlive the kernel. `positions` take the place of the mesh's.
    PerturbedMetricKernel(const Mesh& mesh, const Buffer<Position>& normals, float amount, float frequency,
                          uint64_t seed, GrowingBuffer<Position>& positions, Memory* memory);
    bool run(uint32_t count);

private:
    const Mesh& mesh_;
    const Buffer<Position>& normals_;
    const double amount_, frequency_;
    const uint64_t seed_;
    GrowingBuffer<Position>& positions_;
    uint32_t at_ = 0;
};

}  // namespace flg
