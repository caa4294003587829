// SPDX-License-Identifier: MIT
// Work that algorithms of this room have in common, sliced as runtime/each.h says.
#pragma once

#include "runtime/each.h"
#include "surfaces/mesh/region_cursor.h"

namespace flg {

// body(t) for every triangle t of regions, rising. `cost`: of one body(t); 64 labels outside cost tens of ns together.
template <class Body>
Task<void> each_within(Pace& pace, const Mesh& mesh, const RegionSet& regions, Cost cost, Body body) {
    RegionCursor cursor(mesh, regions);
    const auto slice = static_cast<uint32_t>(Cost::tens_of_ns), of_body = static_cast<uint32_t>(cost);
    co_await each_by_work(pace, (size_t{mesh.triangle_count()} + 63) / 64, Cost::tens_of_ns, [&](uint32_t) {
        uint32_t visited = 0;
        cursor.next_64([&visited, body](uint32_t t) {
            body(t);
            ++visited;
        });
        return 1 + visited * slice / of_body;
    });
}

}  // namespace flg
