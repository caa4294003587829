// SPDX-License-Identifier: MIT
#include "surfaces/perturbed_metric.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/random.h"

namespace flg {

namespace {

// Cells are counted up to here; beyond, floats have no fractions any more.
constexpr double furthest_cell = 0x1p52;

// The gradients lead from the middle of a cube to the middles of its twelve edges; four of them count twice, so that there
// are sixteen.
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

PerturbedMetricKernel::PerturbedMetricKernel(const Mesh& mesh, const Buffer<Position>& normals, float amount,
                                             float frequency, uint64_t seed, GrowingBuffer<Position>& positions,
                                             Memory* memory)
    : mesh_(mesh), normals_(normals), amount_(amount), frequency_(frequency), seed_(seed), positions_(positions) {
    positions = GrowingBuffer<Position>(mesh.vertex_count(), memory);
}

bool PerturbedMetricKernel::run(uint32_t count) {
    constexpr double most = std::numeric_limits<float>::max();
    for (; count > 0 && at_ < mesh_.vertex_count(); --count, ++at_) {
        const Vec3 start = mesh_.position(at_);
        const double height = amount_ * perlin_noise(frequency_ * start, seed_);
        const Vec3 moved = start + height * load_vec3(normals_[at_].data());
        store_vec3(moved.cwiseMax(-most).cwiseMin(most), positions_[at_].data());
    }
    return at_ == mesh_.vertex_count();
}

}  // namespace flg
