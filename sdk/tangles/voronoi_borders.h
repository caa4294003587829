// SPDX-License-Identifier: MIT
// The borders between Voronoi cells as curves: sec. 4.2 of Nazzaro, Puppo, Pellacini: geoTangle (2021).
//
// Departure. The paper solves a bounded field for each generator, to know distances to the three nearest at each vertex.
// Here one field with labels is enough: where a triangle's corners are of different cells, the distances to the neighbours'
// generators are carried over by one ring of vertices, each unfolded from two of the neighbour's own.
//
// Invariants
// - Two triangles of an edge see the same crossing on it. Borders of two cells are one segment a triangle, those of three
//   meet in a point within it.
// - Triangles with a corner that no generator reaches have no borders.
#pragma once

#include <deque>

#include "surfaces/distance_field.h"
#include "surfaces/region_cursor.h"
#include "surfaces/surface_curves.h"

namespace flg {

class VoronoiBordersKernel {
public:
    // `cells`: distances and labels. Appends to `curves`: of two points each, values 0. All outlive the kernel.
    VoronoiBordersKernel(const Mesh& mesh, const RegionSet& regions, const DistanceField& cells, SurfaceCurves& curves,
                         Memory* memory);

    // Spends `count` units of about 0.1 us; true when done. 64 triangles take one to three, each that borders cross five
    // more, of about 0.3 us.
    bool run(uint32_t count);

private:
    enum class Pass { scan, size, clear, list, carry, carry_again, carry_on, trace, done };
    // The distance from a vertex to a generator other than its own.
    struct Far {
        uint32_t vertex, label;
        float distance;
    };

    bool step();
    void scan(uint32_t triangle);
    void list(uint32_t triangle);
    void carry(uint32_t triangle);
    void trace(uint32_t triangle);
    Far& find(uint32_t vertex, uint32_t label);
    float distance(uint32_t vertex, uint32_t label);
    float place_on_edge(uint32_t from, uint32_t to);
    SurfacePoint crossing(Corner edge);
    void add_segment(const SurfacePoint& a, const SurfacePoint& b);

    const Mesh& mesh_;
    const DistanceField& cells_;
    SurfaceCurves& curves_;
    Memory* memory_;
    std::pmr::deque<uint32_t> crossed_;  // triangles
    Buffer<Far> table_;                  // open addressing; a power of two
    RegionCursor cursor_;
    Pass pass_ = Pass::scan;
    size_t at_ = 0;
};

}  // namespace flg
