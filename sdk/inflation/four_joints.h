// SPDX-License-Identifier: MIT
// Smooth weights of many joints become those of four a vertex, and stay as smooth as four can be.
//
// Each vertex chooses its four by itself: the joint whose motion others make up for best gives its weight to these,
// until four are left. Choices end at lines on the surface. There, weights would jump, or fall steeply where five are
// about alike. So near such lines they are spread again, each joint only among the vertices that chose it: what
// neighbours have of others goes to those that move alike. The less a vertex lost, the more it keeps what it had.
#pragma once

#include <array>

#include "inflation/bone_weights.h"
#include "inflation/pivots.h"
#include "runtime/each.h"

namespace flg {

// The largest weights of a vertex, in descending order; 0 and any joint behind the last.
struct ManyJoints {
    static constexpr uint32_t limit = 12;
    std::array<float, limit> weights;
    std::array<uint16_t, limit> joints;
};

struct ManyWeights {
    std::span<const ManyJoints> of_vertex;
    std::span<const double> spread;  // the square of how far they are spread
};

// `corners`: of the mesh's triangles, by vertex. Takes about 1 us a vertex, 5 where more than four joints matter.
Task<BoneWeights> keep_four_joints(Pace& pace, const MergedMesh& mesh, const Groups& corners, ManyWeights many,
                                   const Pivots& pivots);

}  // namespace flg
