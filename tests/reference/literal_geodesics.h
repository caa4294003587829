// SPDX-License-Identifier: MIT
// Geodesic distances the slow way: exact ones, the oracle of sdk/surfaces/geodesics/refined_solver.h, and those of
// geoTangle's graph, which it is measured against.
#pragma once

#include <span>
#include <vector>

#include "surfaces/geodesics/distance_field.h"
#include "surfaces/mesh/mesh.h"
#include "surfaces/mesh/region_set.h"

namespace flg::literal {

// The geodesic graph of Nazzaro, Puppo, Pellacini: geoTangle (2021), sec. 4.2: a node a vertex, its arcs to the other
// ends of its edges and to the vertices opposite to the edges across from it, as long as the straight way in the plane
// of the two triangles. Departure: where that way would leave the two triangles there is no such arc.
struct Arc {
    uint32_t target;
    float length;
};
using GeodesicGraph = std::vector<std::vector<Arc>>;
// Of the triangles within these regions alone.
GeodesicGraph geodesic_graph(const Mesh& mesh, const RegionSet& within = RegionSet(std::pmr::new_delete_resource()));

// Dijkstra's algorithm in floats. Of distances that are the same, the one with the least label counts.
struct GraphField {
    GraphField(const GeodesicGraph& graph, const std::vector<Seed>& seeds);
    // To the field of more sources.
    void extend(const GeodesicGraph& graph, std::span<const Seed> seeds);

    std::vector<float> distances;
    std::vector<uint32_t> labels;
};

// The paper's algorithm 1 as it stands there: a deque, small labels first, large ones last. From one vertex.
std::vector<float> visit_graph(const GeodesicGraph& graph, uint32_t source);

// The lengths of the shortest paths over the triangles from a vertex to all others, by Mitchell, Mount, Papadimitriou:
// The discrete geodesic problem (1987), but for the search in sorted lists: good for some ten thousand triangles, which
// must not be degenerate. Infinite where no path leads.
std::vector<double> exact_distances(const Mesh& mesh, uint32_t source);

}  // namespace flg::literal
