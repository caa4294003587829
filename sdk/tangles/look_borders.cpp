// SPDX-License-Identifier: MIT
#include "tangles/look_borders.h"

#include <algorithm>

#include "runtime/each.h"
#include "surfaces/mesh/region_loops.h"

namespace flg {

namespace {

class Chains {
public:
    Chains(const Mesh& mesh, const RegionTree& tree, Memory* memory)
        : ends(mesh.vertex_count(), memory),
          taken((3 * size_t{mesh.triangle_count()} + 63) / 64, memory),
          curves(memory),
          mesh_(mesh),
          tree_(tree) {}

    void count_ends(uint32_t triangle) {
        for (Corner edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
            if (mesh_.neighbour_at(edge) == no_index) {
                // Curves end at borders of the surface.
                ends[mesh_.vertex_at(edge)] = ends[mesh_.vertex_at(next_corner(edge))] = 3;
            } else if (triangle < mesh_.neighbour_at(edge) && is_border(edge)) {
                for (const uint32_t v : {mesh_.vertex_at(edge), mesh_.vertex_at(next_corner(edge))})
                    ends[v] = std::min<uint8_t>(3, static_cast<uint8_t>(ends[v] + 1));
            }
        }
    }

    // A triangle's edge that a curve begins with: of open ones an edge that leaves an end, of closed ones any; or
    // no_index.
    Corner find_start(uint32_t triangle, bool open) const {
        for (Corner edge = 3 * triangle; edge < 3 * triangle + 3; ++edge)
            if (is_border(edge) && !is_taken(edge) && !(open && ends[mesh_.vertex_at(edge)] == 2)) return edge;
        return no_index;
    }
    void begin(Corner edge) {
        first_vertex_ = mesh_.vertex_at(edge);
        length_ = 0;
        turning_ = edge;
    }
    // Takes the curve's next edge, or turns on about its end; false once it is whole.
    bool walk() {
        if (!is_border(turning_) || is_taken(turning_)) {
            turning_ = mesh_.turn(turning_);
            return true;
        }
        const Corner edge = turning_;
        take(edge);
        take(mesh_.opposite(edge));
        add_point(edge, edge % 3);
        length_ += edge_length(mesh_, edge);
        const uint32_t vertex = mesh_.vertex_at(next_corner(edge));
        const bool goes_on = ends[vertex] == 2, closed = goes_on && vertex == first_vertex_;
        turning_ = next_corner(edge);
        if (goes_on && !closed) return true;
        // The last point of an open curve is in the triangle of the stretch before it.
        if (!closed) add_point(edge, turning_ % 3);
        curves.offsets.push_back(static_cast<uint32_t>(curves.points.size()));
        curves.closed.push_back(closed);
        curves.values.push_back(static_cast<float>(length_));
        return false;
    }

    Buffer<uint8_t> ends;    // by vertex: how many border edges meet there, 3 for more
    Buffer<uint64_t> taken;  // a bit an edge, for both its corners
    SurfaceCurves curves;

private:
    bool is_border(Corner edge) const {
        const uint32_t across = mesh_.neighbour_at(edge);
        if (across == no_index) return false;
        const uint32_t here = mesh_.regions[triangle_of(edge)], there = mesh_.regions[across];
        return here != there && tree_[here].look != tree_[there].look;
    }
    bool is_taken(Corner edge) const { return (taken[edge / 64] >> edge % 64 & 1) != 0; }
    void take(Corner edge) { taken[edge / 64] |= uint64_t{1} << edge % 64; }
    void add_point(Corner edge, uint32_t k) {
        curves.points.push_back({triangle_of(edge), k == 1 ? 1.0f : 0.0f, k == 2 ? 1.0f : 0.0f});
    }

    const Mesh& mesh_;
    const RegionTree& tree_;
    Corner turning_ = no_index;  // starts where the curve has come to: its next edge, or one to turn on from
    uint32_t first_vertex_ = no_index;
    double length_ = 0;
};

Task<void> trace(Pace& pace, uint32_t triangles, bool open, Chains& chains) {
    Slice slice(Cost::tens_of_ns);
    for (uint32_t t = 0; t < triangles; ++t) {
        for (Corner start = chains.find_start(t, open); start != no_index; start = chains.find_start(t, open)) {
            chains.begin(start);
            while (chains.walk())
                if (slice.is_over()) co_await pace;
        }
        if (slice.is_over()) co_await pace;
    }
}

}  // namespace

Task<SurfaceCurves> look_borders(Pace& pace, const Mesh& mesh, const RegionTree& tree) {
    Chains chains(mesh, tree, pace.memory());
    co_await each(pace, chains.ends.size(), Cost::some_ns, [&](uint32_t v) { chains.ends[v] = 0; });
    co_await each(pace, chains.taken.size(), Cost::some_ns, [&](uint32_t i) { chains.taken[i] = 0; });
    co_await each(pace, mesh.triangle_count(), Cost::tens_of_ns, [&](uint32_t t) { chains.count_ends(t); });
    co_await trace(pace, mesh.triangle_count(), true, chains);
    co_await trace(pace, mesh.triangle_count(), false, chains);
    co_return std::move(chains.curves);
}

}  // namespace flg
