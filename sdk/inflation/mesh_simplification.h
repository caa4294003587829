// SPDX-License-Identifier: MIT
// Fewer vertices for a skinned surface: edges are collapsed, the cheapest first (Garland, Heckbert: Surface
// simplification using quadric error metrics, 1997).
//
// Invariants
// - Closed and a manifold as before, with the same components and holes (link condition; Dey et al.: Topology
//   preserving edge contraction, 1999). No triangle turns over.
// - Borders between parts stay chains of edges. Their vertices move along them only; where three parts meet, and where
//   vertices are fixed, nothing moves.
// - A new vertex has the weights of the place on the edge that is nearest to it, in at most four joints.
//
// Costs: the quadric, and for edges along which weights change, and for long ones, a share of their length to the
// fourth power. So bends keep vertices, and flat places get even triangles.
#pragma once

#include "inflation/bone_weights.h"

namespace flg {

struct SimplifiedMesh {
    MergedMesh mesh;
    BoneWeights weights;  // none if none were given
};

// To `vertices`, or as far as that goes. `weights`: of the mesh, or none. All outlive the task. Takes about 2 us a
// vertex of the mesh and 20 us for each that goes.
Task<SimplifiedMesh> simplify_mesh(Pace& pace, const MergedMesh& mesh, const BoneWeights& weights, uint32_t vertices);

}  // namespace flg
