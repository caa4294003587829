// SPDX-License-Identifier: MIT
// The jobs that make manifolds.
#pragma once

#include "splines/manifolds/manifold_product.h"
#include "splines/obstacles/distance_grid.h"

namespace flg {

// The whole of flgManifoldCreateFromSurface: of out->surface.
Task<void> make_mesh_manifold(Pace& pace, double smoothing_scale, std::shared_ptr<ManifoldProduct> out);

// The whole of flgManifoldCreateFromPoints; normals may be empty.
Task<void> make_cloud_manifold(Pace& pace, Buffer<Position> points, Buffer<Position> normals,
                               FlgManifoldFromPointsDesc desc, std::shared_ptr<ManifoldProduct> out);

// The whole of flgManifoldCreateFromGrid; input.values are those.
Task<void> make_grid_manifold(Pace& pace, Buffer<float> values, GridInput input, std::shared_ptr<ManifoldProduct> out);

}  // namespace flg
