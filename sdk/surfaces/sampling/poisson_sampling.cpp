// SPDX-License-Identifier: MIT
#include "surfaces/sampling/poisson_sampling.h"

#include "surfaces/mesh/region_cursor.h"

namespace flg::detail {

Task<std::pmr::deque<uint32_t>> sample_candidates(Pace& pace, const Mesh& mesh, const RegionSet& regions) {
    Buffer<uint8_t> inside(mesh.vertex_count(), pace.memory());
    co_await each(pace, inside.size(), Cost::some_ns, [&](uint32_t v) { inside[v] = 0; });
    RegionCursor cursor(mesh, regions);
    co_await repeat(pace, Cost::hundreds_of_ns, [&] {
        cursor.next_64([&](uint32_t triangle) {
            for (const uint32_t vertex : mesh.triangles[triangle]) inside[vertex] = 1;
        });
        return !cursor.at_end();
    });
    std::pmr::deque<uint32_t> candidates(pace.memory());
    co_await each(pace, inside.size(), Cost::some_ns, [&](uint32_t v) {
        if (inside[v] != 0) candidates.push_back(v);
    });
    co_return candidates;
}

}  // namespace flg::detail
