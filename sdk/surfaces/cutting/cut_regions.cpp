// SPDX-License-Identifier: MIT
#include "surfaces/cutting/cut_regions.h"

#include "core/failure.h"
#include "filigree/filigree_surface.h"
#include "runtime/each.h"

namespace flg {

namespace {

struct Component {
    uint32_t joined;  // one it was joined with before, the one of the lowest number in the end
    uint32_t size;    // once joined: of how many components
    uint32_t label, old_label;
};

using Components = std::pmr::deque<Component>;

uint32_t root_of(Components& components, uint32_t component) {
    while (components[component].joined != component) {
        component = components[component].joined = components[components[component].joined].joined;
    }
    return component;
}

// Floods from both sides of each edge, one side after the other. `cells`, a triangle: bits 0 to 2, the edge is of a
// chain; above: 1 + component, 0 before it is flooded.
Task<Components> flood(Pace& pace, const Mesh& mesh, const std::pmr::deque<Corner>& edges, Buffer<uint32_t>& cells) {
    Components components(pace.memory());
    Buffer<uint32_t> waiting(mesh.triangle_count(),
                             pace.memory());  // whose neighbours are to be looked at; the last next
    uint32_t waiting_count = 0, side = 0;
    // Takes a triangle into the last component.
    const auto visit = [&](uint32_t triangle) {
        cells[triangle] |= static_cast<uint32_t>(8 * components.size());
        waiting[waiting_count++] = triangle;
    };
    co_await repeat(pace, Cost::tens_of_ns, [&] {
        if (waiting_count > 0) {
            const uint32_t triangle = waiting[--waiting_count];
            for (uint32_t k = 0; k < 3; ++k) {
                const uint32_t other = mesh.neighbours[triangle][k];
                if (other == no_index || (cells[triangle] >> k & 1) != 0 || cells[other] >= 8) continue;
                if (mesh.regions[other] == mesh.regions[triangle]) visit(other);
            }
            return true;
        }
        if (side == 2 * edges.size()) return false;
        const Corner edge = edges[side / 2];
        const uint32_t triangle = side % 2 == 0 ? triangle_of(edge) : mesh.neighbour_at(edge);
        ++side;
        if (triangle == no_index || cells[triangle] >= 8) return true;
        const auto index = static_cast<uint32_t>(components.size());
        components.push_back({index, 1, no_index, mesh.regions[triangle]});
        visit(triangle);
        return true;
    });
    co_return components;
}

}  // namespace

Task<void> divide_regions(Pace& pace, Mesh& mesh, const std::pmr::deque<Corner>& edges, uint32_t first_label,
                          MeshEdit& edit, std::pmr::deque<RegionPart>& parts) {
    Buffer<uint32_t> cells(mesh.triangle_count(), pace.memory());
    co_await each(pace, cells.size(), Cost::some_ns, [&](uint32_t t) { cells[t] = 0; });
    co_await each(pace, edges.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const Corner edge = edges[i], across = mesh.opposite(edge);
        cells[edge / 3] |= 1u << edge % 3;
        if (across != no_index) cells[across / 3] |= 1u << across % 3;
    });
    Components components = co_await flood(pace, mesh, edges, cells);
    const auto component_of = [&](uint32_t triangle) { return cells[triangle] / 8 - 1; };
    // What a chain separates was one before.
    co_await each(pace, edges.size(), Cost::tens_of_ns, [&](uint32_t i) {
        const uint32_t triangle = triangle_of(edges[i]), other = mesh.neighbour_at(edges[i]);
        if (other == no_index || mesh.regions[other] != mesh.regions[triangle]) return;
        const uint32_t a = root_of(components, component_of(triangle)), b = root_of(components, component_of(other));
        if (a == b) return;
        components[std::max(a, b)].joined = std::min(a, b);
        components[std::min(a, b)].size += components[std::max(a, b)].size;
    });
    uint32_t next_label = first_label;
    co_await each(pace, components.size(), Cost::tens_of_ns, [&](uint32_t c) {
        if (components[root_of(components, c)].size == 1) return;
        if (next_label > FLG_REGION_MAX) {
            throw Failure(FLG_ERROR_LIMIT, "the parts of regions that fall apart need more labels than up to %u",
                          FLG_REGION_MAX);
        }
        components[c].label = next_label++;
        parts.push_back({components[c].label, components[c].old_label});
    });
    co_await each(pace, cells.size(), Cost::tens_of_ns, [&](uint32_t t) {
        if (cells[t] < 8) return;
        const uint32_t label = components[component_of(t)].label;
        if (label != no_index) edit.set_region(mesh, t, label);
    });
}

}  // namespace flg
