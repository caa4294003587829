// SPDX-License-Identifier: MIT
#include "surfaces/mesh/region_vertices.h"

#include <bit>

#include "surfaces/mesh/marks.h"
#include "surfaces/mesh/region_cursor.h"

namespace flg {

Task<Buffer<uint32_t>> vertices_of(Pace& pace, const Mesh& mesh, const RegionSet& regions, RegionRim rim) {
    Marks marks = co_await no_marks(pace, mesh.vertex_count());
    uint32_t count = 0;
    const auto mark = [&](uint32_t triangle) {
        for (const uint32_t vertex : mesh.triangles[triangle])
            if (marks.set(vertex)) ++count;
    };
    RegionCursor cursor(mesh, regions);
    co_await repeat(pace, Cost::hundreds_of_ns, [&] {
        cursor.next_64([&](uint32_t triangle) {
            mark(triangle);
            if (rim == RegionRim::without) return;
            for (const uint32_t across : mesh.neighbours[triangle])
                if (across != no_index && !regions.contains(mesh.regions[across])) mark(across);
        });
        return !cursor.at_end();
    });
    Buffer<uint32_t> vertices(count, pace.memory());
    uint32_t filled = 0;
    co_await each(pace, marks.words().size(), Cost::tens_of_ns, [&](uint32_t word) {
        for (uint64_t left = marks.words()[word]; left != 0; left &= left - 1)
            vertices[filled++] = 64 * word + static_cast<uint32_t>(std::countr_zero(left));
    });
    co_return vertices;
}

}  // namespace flg
