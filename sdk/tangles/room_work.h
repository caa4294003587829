// SPDX-License-Identifier: MIT
// Work that algorithms of this room have in common, sliced as runtime/each.h says.
#pragma once

#include "runtime/each.h"
#include "surfaces/mesh/region_cursor.h"

namespace flg {

namespace detail {

// Visits what a slice has room for.
template <class Body>
[[gnu::noinline]] void visit_some(RegionCursor& cursor, uint32_t work, uint32_t of_body, Body body) {
    for (uint32_t done = 0; done < work && !cursor.at_end();) {
        uint32_t visited = 0;
        cursor.next_64([&visited, body](uint32_t t) {
            body(t);
            ++visited;
        });
        done += 1 + visited * work / of_body;
    }
}

}  // namespace detail

// body(t) for every triangle t that the cursor has left, rising. `cost`: of one body(t).
template <class Body>
Task<void> each_within(Pace& pace, RegionCursor& cursor, Cost cost, Body body) {
    while (!cursor.at_end()) {
        detail::visit_some(cursor, static_cast<uint32_t>(Cost::tens_of_ns), static_cast<uint32_t>(cost), body);
        co_await pace;
    }
}

// The same for the triangles of regions.
template <class Body>
Task<void> each_within(Pace& pace, const Mesh& mesh, const RegionSet& regions, Cost cost, Body body) {
    RegionCursor cursor(mesh, regions);
    co_await each_within(pace, cursor, cost, body);
}

}  // namespace flg
