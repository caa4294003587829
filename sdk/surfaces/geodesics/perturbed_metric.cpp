// SPDX-License-Identifier: MIT
#include "surfaces/geodesics/perturbed_metric.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/random.h"
#include "runtime/each.h"
#include "surfaces/geodesics/local_blocks.h"
#include "surfaces/geodesics/perturbed_blocks.h"
#include "surfaces/mesh/chord_normal.h"
#include "surfaces/mesh/marks.h"
#include "surfaces/mesh/region_cursor.h"

namespace flg {

namespace {

// Cells are counted up to here; beyond, floats have no fractions any more.
constexpr double furthest_cell = 0x1p52;

// The gradients lead from the middle of a cube to the middles of its twelve edges; four of them count twice, so that
// there are sixteen.
constexpr std::array<std::array<double, 3>, 16> gradient_table = {{{1, 1, 0},
                                                                   {-1, 1, 0},
                                                                   {1, -1, 0},
                                                                   {-1, -1, 0},
                                                                   {1, 0, 1},
                                                                   {-1, 0, 1},
                                                                   {1, 0, -1},
                                                                   {-1, 0, -1},
                                                                   {0, 1, 1},
                                                                   {0, -1, 1},
                                                                   {0, 1, -1},
                                                                   {0, -1, -1},
                                                                   {1, 1, 0},
                                                                   {0, -1, 1},
                                                                   {-1, 1, 0},
                                                                   {0, -1, -1}}};

double fade(double t) {
    return t * t * t * (t * (t * 6 - 15) + 10);
}

using Corners = double __attribute__((vector_size(64)));

}  // namespace

PerlinNoise::PerlinNoise(uint64_t seed) : mixed_seed_(mix64(seed)) {}

// The bits of a corner are random_bits(seed, random_bits(seed, x, y), z).
void PerlinNoise::enter(const std::array<int64_t, 3>& cell) {
    cell_ = cell;
    inside_ = true;
    const auto at = [&](int axis, uint32_t bit) { return static_cast<uint64_t>(cell[axis]) + bit; };
    for (uint32_t corner = 0; corner < corner_count; corner += 4) {
        const uint32_t k = corner / 4;
        for (uint32_t i = 0; i < 2; ++i) {
            const uint64_t row = mix64(mixed_seed_ ^ at(0, i));
            for (uint32_t j = 0; j < 2; ++j) {
                const uint64_t column = mix64(row ^ at(1, j));
                const uint64_t bits = mix64(mix64(mixed_seed_ ^ column) ^ at(2, k));
                for (int axis = 0; axis < 3; ++axis)
                    gradients_[axis][corner + 2 * j + i] = gradient_table[bits >> 60][axis];
            }
        }
    }
}

double PerlinNoise::operator()(const Vec3& place) {
    std::array<int64_t, 3> cell;
    std::array<double, 3> inside, weight;
    for (int axis = 0; axis < 3; ++axis) {
        const double x = std::clamp(place[axis], -furthest_cell, furthest_cell);
        const auto toward_zero = static_cast<int64_t>(x);
        cell[axis] = toward_zero - (static_cast<double>(toward_zero) > x ? 1 : 0);
        inside[axis] = x - static_cast<double>(cell[axis]);
        weight[axis] = fade(inside[axis]);
    }
    if (!inside_ || cell != cell_) enter(cell);
    constexpr Corners at_x = {0, 1, 0, 1, 0, 1, 0, 1}, at_y = {0, 0, 1, 1, 0, 0, 1, 1}, at_z = {0, 0, 0, 0, 1, 1, 1, 1};
    Corners gradient_x, gradient_y, gradient_z;
    std::memcpy(&gradient_x, gradients_[0].data(), sizeof gradient_x);
    std::memcpy(&gradient_y, gradients_[1].data(), sizeof gradient_y);
    std::memcpy(&gradient_z, gradients_[2].data(), sizeof gradient_z);
    const Corners along =
        gradient_x * (inside[0] - at_x) + gradient_y * (inside[1] - at_y) + gradient_z * (inside[2] - at_z);
    const Corners share = (at_x * weight[0] + (1 - at_x) * (1 - weight[0])) *
                          (at_y * weight[1] + (1 - at_y) * (1 - weight[1])) *
                          (at_z * weight[2] + (1 - at_z) * (1 - weight[2]));
    const Corners parts = share * along;
    double sum = 0;
    for (uint32_t corner = 0; corner < corner_count; ++corner) sum += parts[corner];
    return std::clamp(sum, -1.0, 1.0);
}

double perlin_noise(const Vec3& place, uint64_t seed) {
    return PerlinNoise(seed)(place);
}

namespace {

// Vertices of regions, and those that edges join to them, as marks on the ranks of the surface's blocks: near in space
// is near in the order.
struct RegionRanks {
    Marks inside, beyond;
};

Task<RegionRanks> mark_ranks(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks, const RegionSet& regions,
                             const std::pmr::deque<uint32_t>& also) {
    // What may fail comes first: GCC 12 frees members of an aggregate twice if a later one throws.
    Marks inside = co_await no_marks(pace, blocks.rank_count()), beyond = co_await no_marks(pace, blocks.rank_count());
    Marks around = co_await no_marks(pace, blocks.rank_count());
    // Once for each vertex; returns how many it has marked.
    const auto mark_around = [&](uint32_t vertex) -> uint32_t {
        uint32_t count = 0;
        if (!around.set(blocks.rank_of_vertex[vertex])) return count;
        visit_fan(mesh, vertex, [&](uint32_t neighbour, Corner) {
            beyond.set(blocks.rank_of_vertex[neighbour]);
            ++count;
        });
        return count;
    };
    co_await each(pace, also.size(), Cost::tens_of_ns, [&](uint32_t i) { beyond.set(blocks.rank_of_vertex[also[i]]); });
    RegionCursor cursor(mesh, regions);
    const auto mark_next = [&]() -> uint32_t {
        const uint32_t triangle = cursor.next();
        if (triangle == no_index) return 1;
        const Triple& corners = mesh.triangles[triangle];
        uint32_t work = 1;
        for (uint32_t k = 0; k < 3; ++k) {
            inside.set(blocks.rank_of_vertex[corners[k]]);
            const uint32_t across = mesh.neighbours[triangle][k];
            if (across == no_index || regions.contains(mesh.regions[across])) continue;
            work += mark_around(corners[k]) + mark_around(corners[following_corner(k)]);
        }
        return work;
    };
    for (Slice slice(Cost::tens_of_ns); !cursor.at_end();) {
        if (slice.is_over(mark_next())) co_await pace;
    }
    co_return RegionRanks{std::move(inside), std::move(beyond)};
}

}  // namespace

Task<PerturbedMetric> perturb_metric(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks,
                                     const RegionSet& regions, const std::pmr::deque<uint32_t>& also,
                                     const Perturbation& perturbation) {
    constexpr double most = std::numeric_limits<float>::max();
    PerturbedMetric metric(pace.memory());
    metric.positions = GrowingBuffer<Position>(mesh.vertex_count(), pace.memory());
    RegionRanks ranks = co_await mark_ranks(pace, mesh, blocks, regions, also);
    uint32_t count = 0;
    const auto marked = [&](uint32_t word) { return ranks.inside.words()[word] | ranks.beyond.words()[word]; };
    const size_t words = ranks.inside.words().size();
    co_await each(pace, words, Cost::some_ns,
                  [&](uint32_t word) { count += static_cast<uint32_t>(std::popcount(marked(word))); });
    Buffer<BlockVertex> vertices(count, pace.memory());
    count = 0;
    co_await each(pace, words, Cost::tens_of_ns, [&](uint32_t word) {
        for (uint64_t left = marked(word); left != 0; left &= left - 1) {
            const uint32_t rank = 64 * word + static_cast<uint32_t>(std::countr_zero(left));
            vertices[count++] = {blocks.vertex_of_rank[rank], ranks.inside.has(rank)};
        }
    });
    const double amount = perturbation.amount, frequency = perturbation.frequency;
    PerlinNoise noise(perturbation.seed);
    co_await each(pace, vertices.size(), Cost::hundreds_of_ns, [&](uint32_t i) {
        if (i % fans_fetched == 0) {
            fetch_fans(
                mesh, [at = &vertices[i]](uint32_t k) { return at[k].vertex; },
                static_cast<uint32_t>(vertices.size()) - i,
                [&](uint32_t vertex) __attribute__((always_inline)) { __builtin_prefetch(&mesh.positions[vertex]); });
        }
        const Vec3 start = mesh.position(vertices[i].vertex);
        const Vec3 moved = start + amount * noise(frequency * start) * chord_normal(mesh, vertices[i].vertex);
        store_vec3(moved.cwiseMax(-most).cwiseMin(most), metric.positions[vertices[i].vertex].data());
    });
    metric.blocks = co_await make_blocks(pace, mesh, metric.positions, vertices, regions);
    // Buckets are as wide as on the surface, whatever the regions.
    EdgeScale scale = blocks.edges;
    const float longest = metric.blocks.edges.longest();
    scale.add(longest);
    scale.remove(longest);
    metric.blocks.edges = scale;
    co_return metric;
}

}  // namespace flg
