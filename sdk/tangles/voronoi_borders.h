// SPDX-License-Identifier: MIT
// The borders between Voronoi cells as curves: sec. 4.2 of Nazzaro, Puppo, Pellacini: geoTangle (2021).
//
// Departure. The paper solves a bounded field for each generator, to know distances to the three nearest at each
// vertex. Here one field with labels is enough: where a triangle's corners are of different cells, the distances to
// the neighbours' generators are carried over by one ring of vertices, each unfolded from two of the neighbour's own.
//
// Invariants
// - Two triangles of an edge see the same crossing on it. Borders of two cells are one segment a triangle, those of
//   three meet in a point within it.
// - Triangles with a corner that no generator reaches have no borders.
//
// The same makes ridges, where distances from far apart meet, of cells of many small generators: borders of those that
// are not apart are left out.
#pragma once

#include <functional>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/geodesics/distance_field.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// Whether two vertices of an edge, whose cells differ, have a border between them; symmetric.
using CellsApart = std::function<bool(uint32_t, uint32_t)>;

// `cells`: distances and labels. `apart`: which cells have borders; empty: all. Returns curves of two points each,
// values 0; those of a triangle one behind the other. Cost: 5 ns a triangle of the regions, 2 us each that borders
// cross.
Task<SurfaceCurves> voronoi_borders(Pace& pace, const Mesh& mesh, const RegionSet& regions, const DistanceField& cells,
                                    CellsApart apart = {});

}  // namespace flg
