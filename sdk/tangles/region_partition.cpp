// SPDX-License-Identifier: MIT
#include "tangles/region_partition.h"

#include <array>
#include <utility>

#include "tangles/room_work.h"

namespace flg {

namespace {

// Marks both sides of the curves' edges.
Task<void> mark_edges(Pace& pace, const std::pmr::deque<Corner>& edges, RegionPartition& partition) {
    return each(pace, edges.size(), Cost::tens_of_ns, [&](uint32_t i) {
        for (const Corner side : {edges[i], partition.mesh.opposite(edges[i])})
            if (side != no_index && partition.is_within(triangle_of(side)))
                partition.cells[triangle_of(side)] |= 1u << side % 3;
    });
}

// Finds the components. Returns the edges between leaves, but those of curves.
Task<std::pmr::deque<Corner>> flood_components(Pace& pace, RegionPartition& partition) {
    const Mesh& mesh = partition.mesh;
    Buffer<uint32_t>& cells = partition.cells;
    std::pmr::deque<Corner> borders(pace.memory());
    Buffer<uint32_t> waiting(mesh.triangle_count(),
                             pace.memory());  // for a look at their neighbours; the last one next
    uint32_t waiting_count = 0;
    const auto take_in = [&](uint32_t triangle) {
        cells[triangle] |= static_cast<uint32_t>(8 * partition.components.size());
        waiting[waiting_count++] = triangle;
    };
    const auto look_around = [&](uint32_t triangle) {
        for (uint32_t k = 0; k < 3; ++k) {
            const uint32_t other = mesh.neighbours[triangle][k];
            if (other == no_index || (cells[triangle] >> k & 1) != 0) continue;
            if (mesh.regions[other] == mesh.regions[triangle]) {
                if (cells[other] < 8) take_in(other);
            } else if (other < triangle && partition.is_within(other)) {
                borders.push_back(3 * triangle + k);
            }
        }
    };
    RegionCursor cursor(mesh, partition.leaves);
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (waiting_count > 0) {
            look_around(waiting[--waiting_count]);
            return true;
        }
        const uint32_t triangle = cursor.next();
        if (triangle == no_index || cells[triangle] >= 8) return !cursor.at_end();
        partition.components.push_back({mesh.regions[triangle], no_index, triangle});
        take_in(triangle);
        return true;
    });
    co_return borders;
}

// Sets of components. The larger of two takes the other one in, so none is more than 32 steps deep.
class JoinedComponents {
public:
    JoinedComponents(uint32_t count, Memory* memory) : above_(count, memory), size_(count, memory) {}

    void clear(uint32_t component) {
        above_[component] = component;
        size_[component] = 1;
    }
    uint32_t root_of(uint32_t component) {
        while (above_[component] != component) component = above_[component] = above_[above_[component]];
        return component;
    }
    void join(uint32_t a, uint32_t b) {
        a = root_of(a);
        b = root_of(b);
        if (a == b) return;
        if (size_[a] < size_[b]) std::swap(a, b);
        above_[b] = a;
        size_[a] += size_[b];
    }

private:
    Buffer<uint32_t> above_;  // one of the same set, or itself
    Buffer<uint32_t> size_;   // of the set, at its root
};

// Parts go on across the borders between leaves.
Task<void> number_parts(Pace& pace, const std::pmr::deque<Corner>& borders, RegionPartition& partition) {
    std::pmr::deque<RegionComponent>& components = partition.components;
    const auto count = static_cast<uint32_t>(components.size());
    JoinedComponents joined(count, pace.memory());
    co_await each(pace, count, Cost::some_ns, [&](uint32_t c) { joined.clear(c); });
    co_await each(pace, borders.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t here = triangle_of(borders[i]), across = partition.mesh.neighbour_at(borders[i]);
        joined.join(partition.component_of(here), partition.component_of(across));
    });
    co_await each(pace, count, Cost::tens_of_ns, [&](uint32_t c) {
        uint32_t& part = components[joined.root_of(c)].part;
        if (part == no_index) part = partition.part_count++;
        components[c].part = part;
    });
}

}  // namespace

Task<RegionPartition> partition_regions(Pace& pace, const Mesh& mesh, const RegionSet& leaves,
                                        const std::pmr::deque<Corner>& edges, Parts parts) {
    RegionPartition partition(mesh, leaves, pace.memory());
    co_await each_within(pace, mesh, leaves, Cost::some_ns, [&](uint32_t t) { partition.cells[t] = 0; });
    co_await mark_edges(pace, edges, partition);
    std::pmr::deque<Corner> borders = co_await flood_components(pace, partition);
    if (parts == Parts::within_leaves) borders.clear();
    co_await number_parts(pace, borders, partition);
    co_return partition;
}

}  // namespace flg
