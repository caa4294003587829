// SPDX-License-Identifier: MIT
#include "surfaces/solve_field.h"

#include "core/failure.h"

namespace flg {

namespace {

template <class T>
const T& present(const std::optional<T>& made) {
    if (!made) {
        throw Failure(FLG_ERROR_OUT_OF_MEMORY,
                      "memory ran out when what distances are computed with was built, or followed a cut");
    }
    return *made;
}

}  // namespace

const GeodesicBlocks& blocks_of(const Surface& surface) {
    return present(surface.solvers.blocks);
}

const GeodesicGraph& graph_of(const Surface& surface) {
    return present(surface.solvers.graph);
}

Task<const GeodesicRegion*> bound_region(Pace& pace, const Mesh& mesh, const GeodesicBlocks& blocks,
                                         const RegionSet& regions, GeodesicRegion& region) {
    constexpr uint32_t chunk = 200;  // about 10 us
    if (regions.all()) co_return nullptr;
    GeodesicRegionKernel kernel(mesh, blocks, regions, region, pace.memory());
    while (!kernel.run(chunk)) co_await pace;
    co_return &region;
}

Task<Buffer<uint32_t>> flatten(Pace& pace, const std::pmr::deque<uint32_t>& indices) {
    constexpr size_t chunk = 4000;  // about 10 us
    Buffer<uint32_t> flat(indices.size(), pace.memory());
    for (size_t i = 0; i < flat.size(); ++i) {
        flat[i] = indices[i];
        if (i % chunk == 0) co_await pace;
    }
    co_return flat;
}

}  // namespace flg
