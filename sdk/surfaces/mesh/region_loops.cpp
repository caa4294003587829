// SPDX-License-Identifier: MIT
#include "surfaces/mesh/region_loops.h"

#include "surfaces/mesh/index_table.h"
#include "surfaces/mesh/region_cursor.h"

namespace flg {

Task<RegionLoops> find_region_loops(Pace& pace, const Mesh& mesh, const RegionSet& regions) {
    const auto is_border = [&](Corner edge) {
        if (!regions.contains(mesh.regions[triangle_of(edge)])) return false;
        const uint32_t across = mesh.neighbour_at(edge);
        return across == no_index || !regions.contains(mesh.regions[across]);
    };
    RegionLoops loops(pace.memory());
    IndexTable visited;  // by edge
    Slice slice(Cost::tens_of_ns);
    for (RegionCursor cursor(mesh, regions); !cursor.at_end();) {
        if (slice.is_over()) co_await pace;
        const uint32_t triangle = cursor.next();
        if (triangle == no_index) continue;
        for (Corner first = 3 * triangle; first < 3 * triangle + 3; ++first) {
            if (!is_border(first) || visited.find(first) != no_index) continue;
            double length = 0;
            Corner edge = first;
            do {
                length += edge_length(mesh, edge);
                if (!visited.has_room(1)) co_await IndexTable::reserve(pace, visited, 1);
                visited.insert(edge, 0);
                loops.edges.push_back(edge);
                // Turns about the edge's end, through the regions' triangles, until it meets the next one.
                for (edge = next_corner(edge); !is_border(edge); edge = next_corner(mesh.opposite(edge)))
                    if (slice.is_over()) co_await pace;
                if (slice.is_over()) co_await pace;
            } while (edge != first);
            loops.offsets.push_back(static_cast<uint32_t>(loops.edges.size()));
            loops.lengths.push_back(length);
        }
    }
    co_return loops;
}

}  // namespace flg
