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
#pragma once

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/geodesics/distance_field.h"
#include "surfaces/mesh/region_set.h"
#include "surfaces/mesh/surface_curves.h"

namespace flg {

// `cells`: distances and labels. Returns curves of two points each, values 0. Cost: 5 ns a triangle of the regions, 2
// us each that borders cross.
Task<SurfaceCurves> voronoi_borders(Pace& pace, const Mesh& mesh, const RegionSet& regions, const DistanceField& cells);

}  // namespace flg
