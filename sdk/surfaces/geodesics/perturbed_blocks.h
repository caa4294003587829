// SPDX-License-Identifier: MIT
// The metric of perturbed_metric.h for some regions, at the cost of these: with what distances are computed with. They
// have the bits of those of the whole surface, but where flipped edges reach the regions' ends.
#pragma once

#include <array>
#include <deque>

#include "surfaces/geodesics/geodesic_blocks.h"
#include "surfaces/geodesics/perturbed_metric.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

// perlin_noise() at many places. As long as these stay in one cell its gradients are drawn once: so neighbours should
// follow one another. About 15 ns each.
class PerlinNoise {
public:
    explicit PerlinNoise(uint64_t seed);
    double operator()(const Vec3& place);

private:
    static constexpr uint32_t corner_count = 8;  // of a cell: bit a of a corner's number is its coordinate on axis a

    void enter(const std::array<int64_t, 3>& cell);

    uint64_t mixed_seed_;
    bool inside_ = false;  // of any cell
    std::array<int64_t, 3> cell_{};
    std::array<std::array<double, corner_count>, 3> gradients_;  // by axis
};

struct PerturbedMetric {
    explicit PerturbedMetric(Memory* memory) : positions(memory), blocks(memory) {}

    // By vertex, in place of the mesh's: of the regions' triangles, and of those that touch them. Others are not
    // written.
    GrowingBuffer<Position> positions;
    // Of the regions' vertices. bound_region() closes them where the regions end.
    GeodesicBlocks blocks;
};

// `blocks`: the surface's own. `also`: further vertices whose positions are asked for. Departure: normals are those of
// chord_normal.h. About 0.3 us a vertex of the regions.
Task<PerturbedMetric> perturb_metric(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks,
                                     const RegionSet& regions, const std::pmr::deque<uint32_t>& also,
                                     const Perturbation& perturbation);

}  // namespace flg
