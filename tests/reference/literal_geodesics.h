// SPDX-License-Identifier: MIT
// Geodesic distances the slow way: the oracles of sdk/surfaces/graph_solver.h and refined_solver.h.
#pragma once

#include <vector>

#include "surfaces/distance_field.h"
#include "surfaces/mesh.h"

namespace flg::literal {

// The geodesic graph of Nazzaro, Puppo, Pellacini: geoTangle (2021), sec. 4.2: a node a vertex, its arcs to the other
// ends of its edges and to the vertices opposite to the edges across from it, as long as the straight way in the plane
// of the two triangles. Departure: where that way would leave the two triangles there is no such arc.
struct Arc {
    uint32_t target;
    float length;
};
using GeodesicGraph = std::vector<std::vector<Arc>>;
GeodesicGraph geodesic_graph(const Mesh& mesh);

// Dijkstra's algorithm in floats.
std::vector<float> graph_distances(const GeodesicGraph& graph, const std::vector<Seed>& seeds);

// The lengths of the shortest paths over the triangles from a vertex to all others, by Mitchell, Mount, Papadimitriou:
// The discrete geodesic problem (1987), but for the search in sorted lists: good for some ten thousand triangles, which must
// not be degenerate. Infinite where no path leads.
std::vector<double> exact_distances(const Mesh& mesh, uint32_t source);

}  // namespace flg::literal
