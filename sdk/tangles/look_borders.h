// SPDX-License-Identifier: MIT
// The borders that are seen, as curves on the surface: chains of edges between regions that look different.
//
// Invariants
// - Each such edge is in one curve. A curve begins and ends where three or more chains or a border of the surface meet;
//   those that meet none are closed.
// - Open curves first, by the edge they begin with, then closed ones.
#pragma once

#include "surfaces/surface_curves.h"
#include "tangles/region_tree.h"

namespace flg {

class LookBordersKernel {
public:
    // Labels of the mesh are the tree's leaves. Appends to `out`, values being lengths in metres. All outlive the kernel.
    // Memory: a byte a vertex, a bit an edge.
    LookBordersKernel(const Mesh& mesh, const RegionTree& tree, SurfaceCurves& out, Memory* memory);

    // Spends `count` units of about 20 ns; true when done. 16 vertices, a triangle, an edge of a curve or a turn about a
    // vertex take one.
    bool run(uint32_t count);

private:
    enum class Pass { clear_vertices, clear_edges, count, open, closed, done };

    bool is_border(Corner edge) const;
    bool is_taken(Corner edge) const { return (taken_[edge / 64] >> edge % 64 & 1) != 0; }
    void take(Corner edge) { taken_[edge / 64] |= uint64_t{1} << edge % 64; }
    bool step();
    void count_ends(uint32_t triangle);
    void look_for_start(uint32_t triangle);
    void begin(Corner edge);
    void walk();
    void end(bool closed);

    const Mesh& mesh_;
    const RegionTree& tree_;
    SurfaceCurves& out_;
    Buffer<uint8_t> ends_;    // by vertex: how many border edges meet there, 3 for more
    Buffer<uint64_t> taken_;  // a bit an edge, for both its corners
    Pass pass_ = Pass::clear_vertices;
    size_t at_ = 0;
    Corner edge_ = no_index;     // the curve's last one, in its direction
    Corner turning_ = no_index;  // at its end, on the way to the next one
    uint32_t first_vertex_ = no_index;
    double length_ = 0;
};

}  // namespace flg
