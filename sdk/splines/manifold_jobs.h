// SPDX-License-Identifier: MIT
// The jobs that make manifolds.
#pragma once

#include "splines/held_manifold.h"

namespace flg {

// The whole of flgManifoldCreateFromSurface: of out->surface.
Task<void> make_mesh_manifold(Pace& pace, std::shared_ptr<HeldManifold> out);

}  // namespace flg
