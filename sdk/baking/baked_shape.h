// SPDX-License-Identifier: MIT
// A surface's vertices on the mesh that it was made of, and how far displacement moved them off it.
#pragma once

#include "baking/bake_request.h"
#include "surfaces/surface.h"

namespace flg {

struct BakedShape {
    Buffer<Position> places;  // on the mesh, by vertex
    // By vertex, metres along the mesh's smooth normals, and the gradient along the mesh, without unit. Empty: nothing
    // was displaced.
    Buffer<float> heights;
    Buffer<Position> slopes;
};

// Refuses a mesh that isn't the surface's. Heights that are rounding are 0: those below a millionth of the mesh's size.
Task<BakedShape> find_shape(Pace& pace, const Surface& surface, const BakeRequest& request);

}  // namespace flg
