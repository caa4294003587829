// SPDX-License-Identifier: MIT
// How much each joint moves each vertex of a surface. Each vertex begins with the nearest bone of the part that it lies
// on; then that is spread over the surface, twice,
//
//     (M + T L) w = M w_before
//
// with areas M, the cotangent Laplacian L (weights of edges at least a little above zero), and T from how thick the
// shape is there. The matrix is an M-matrix whose rows sum to M. So weights stay within [0, 1] and sum to 1 without
// constraints (maximum principle), one factorization serves all joints and both times, and there is nothing to iterate.
// Twice, because that leaves no kink where a bone's region ends (once is the bone heat of Baran, Popovic: Automatic
// rigging and animation of 3D characters, 2007, turned inside out). The paper uses bounded biharmonic weights (Jacobson
// et al. 2011), a quadratic program a bone on a mesh of tetrahedra; in tests/reference they are literal, and the tests
// compare.
#pragma once

#include <array>
#include <span>

#include "inflation/merge_parts.h"
#include "runtime/task.h"
#include "skeletons/bone_tree.h"

namespace flg {

struct BoneWeightOptions {
    // How far weights are spread, by the radius of the shape: across a joint four fifths of the change take about 4.6
    // times this. 0.05 to 2.
    double reach = 0.4;
};

// At most four joints a vertex, the largest weight first. Weights are within [0, 1] and sum to 1 up to rounding; unused
// ones are joint 0 with weight 0.
struct BoneWeights {
    Buffer<std::array<uint16_t, 4>> joints;
    Buffer<std::array<float, 4>> weights;
};

// For a surface whose parts have the bones' numbers. At least one bone; joints below 65536. `mesh` and what `bones`
// shows outlive the task. Takes about 6 us a vertex, and 0.6 us a vertex for each eight joints. Throws, with a
// sentence, if something is out of range or not finite.
Task<BoneWeights> bone_weights(Pace& pace, const MergedMesh& mesh, std::span<const BoneSegment> bones,
                               BoneWeightOptions options);

}  // namespace flg
