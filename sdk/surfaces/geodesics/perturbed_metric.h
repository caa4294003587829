// SPDX-License-Identifier: MIT
// Another metric on the same surface, sec. 3.4 of Nazzaro, Puppo, Pellacini: geoTangle (2021): distances are measured
// as if the vertices were moved along their normals by Perlin noise (Perlin: Improving noise, 2002). Departure: the
// gradient of a lattice point is drawn by core/random.h from its seed and place, not from a table of 256.
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

// In [-1, 1], 0 at the corners of unit cells, with continuous second derivatives.
double perlin_noise(const Vec3& place, uint64_t seed);

struct Perturbation {
    float amount = 0;     // metres, >= 0: how far vertices move at most; 0: none
    float frequency = 1;  // cells of the noise a metre, > 0
    uint64_t seed = 1;
};

}  // namespace flg
