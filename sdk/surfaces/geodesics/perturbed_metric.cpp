// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/perturbed_metric.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"
#include "runtime/each.h"

namespace flg {

namespace {

// Cells are counted up to here; beyond, floats have no fractions any more.
constexpr double furthest_cell = 0x1p52;

// The gradients lead from the middle of a cube to the middles of its twelve edges; four of them count twice, so that
// there are sixteen.
double along_gradient(uint64_t bits, double x, double y, double z) {
    const uint32_t choice = static_cast<uint32_t>(bits >> 60);
    const double u = choice < 8 ? x : y;
    const double v = choice < 4 ? y : choice == 12 || choice == 14 ? x : z;
    return ((choice & 1) != 0 ? -u : u) + ((choice & 2) != 0 ? -v : v);
}

double fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

}  // namespace

double perlin_noise(const Vec3& place, uint64_t seed) {
    int64_t cell[3];
    double inside[3], weight[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double x = std::clamp(place[axis], -furthest_cell, furthest_cell);
        cell[axis] = static_cast<int64_t>(std::floor(x));
        inside[axis] = x - std::floor(x);
        weight[axis] = fade(inside[axis]);
    }
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const uint64_t column =
            random_bits(seed, static_cast<uint64_t>(cell[0] + i), static_cast<uint64_t>(cell[1] + j));
        const uint64_t bits = random_bits(seed, column, static_cast<uint64_t>(cell[2] + k));
        const double share =
            (i ? weight[0] : 1 - weight[0]) * (j ? weight[1] : 1 - weight[1]) * (k ? weight[2] : 1 - weight[2]);
        sum += share * along_gradient(bits, inside[0] - i, inside[1] - j, inside[2] - k);
    }
    return std::clamp(sum, -1.0, 1.0);
}

Task<GrowingBuffer<Position>> perturb_positions(Pace& pace, const Mesh& mesh, const Buffer<Position>& normals,
                                                Perturbation perturbation) {
    constexpr double most = std::numeric_limits<float>::max();
    const double amount = perturbation.amount, frequency = perturbation.frequency;
    GrowingBuffer<Position> positions(mesh.vertex_count(), pace.memory());
    co_await each(pace, mesh.vertex_count(), Cost::hundreds_of_ns, [&](uint32_t v) {
        const Vec3 start = mesh.position(v);
        const double height = amount * perlin_noise(frequency * start, perturbation.seed);
        const Vec3 moved = start + height * load_vec3(normals[v].data());
        store_vec3(moved.cwiseMax(-most).cwiseMin(most), positions[v].data());
    });
    co_return positions;
}

}  // namespace flg
