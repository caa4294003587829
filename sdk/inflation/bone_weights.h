// SPDX-License-Identifier: MIT
// How much each joint moves each vertex of a surface. Each vertex begins with the bone of its part that is nearest
// within the body (bone_regions.h, or whoever knows); then that is spread over the surface, twice,
//
//     (M + T L) w = M w_before        w minimizes  integral of (w - w_before)^2 + T |grad w|^2
//
// with areas M and the cotangent Laplacian L (weights of edges at least a little above zero). The matrix is an M-matrix
// whose rows sum to M. So weights stay within [0, 1] and sum to 1 without constraints (maximum principle), one
// factorization serves all joints and both times, and there is nothing to iterate. Twice, because that leaves no kink
// where a bone's region ends (once is the bone heat of Baran, Popovic: Automatic rigging and animation of 3D
// characters, 2007, turned inside out). The paper uses bounded biharmonic weights (Jacobson et al. 2011), a quadratic
// program a bone on a mesh of tetrahedra; in tests/reference they are literal, and the tests compare.
//
// How far: sqrt(T). A joint that turns moves what is at a distance d from it by d times the angle, so the surface
// stretches by that times the slope of the weights, which is at most about 1 / (4 sqrt(T)). So wherever regions of
// bones meet, sqrt(T) is a share of the distance to the farthest joint that moves one and not the other, and less
// farther off. It is at least a share of the radius of the shape, and of the longest edge at the vertex.
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

using VertexJoints = std::array<uint16_t, 4>;
using VertexWeights = std::array<float, 4>;

// At most four joints a vertex, the largest weight first. Weights are within [0, 1] and sum to 1 up to rounding; unused
// ones are joint 0 with weight 0.
struct BoneWeights {
    Buffer<VertexJoints> joints;
    Buffer<VertexWeights> weights;
};

// The largest weights of a vertex, in descending order; 0 and any joint behind the last.
struct ManyJoints {
    static constexpr uint32_t limit = 12;
    std::array<float, limit> weights;
    std::array<uint16_t, limit> joints;
};

// Before all but four a vertex are given up (four_joints.h).
struct ManyWeights {
    Buffer<ManyJoints> of_vertex;
    Buffer<double> spread;  // T: the square of how far they are spread
};

// Makes the first's weights (1 - share) of them and `share` of the second's, in the twelve largest.
void mix_weights(ManyJoints& a, const ManyJoints& b, double share);

// Makes the first's weights (1 - share) of them and `share` of the second's, in the four largest, continuously.
void mix_weights(VertexJoints& joints_a, VertexWeights& a, const VertexJoints& joints_b, const VertexWeights& b,
                 double share);

// What a surface is bound to.
struct BoneRig {
    std::span<const BoneSegment> bones;         // at least one; joints below 65536
    std::span<const uint32_t> joint_parents{};  // by joint, lower than its own number; no_joint: a root. Empty: all are
};

// For a surface of these parts, whose numbers the bones have. `mesh` and what the others show outlive the task. Takes
// about 7 us a vertex, and 0.6 us a vertex for each eight joints. Throws, with a sentence, if something is out of range
// or not finite.
Task<ManyWeights> many_weights(Pace& pace, const MergedMesh& mesh, std::span<const PlacedPart> parts, BoneRig rig,
                               BoneWeightOptions options);

// The same, of four joints a vertex.
Task<BoneWeights> bone_weights(Pace& pace, const MergedMesh& mesh, std::span<const PlacedPart> parts, BoneRig rig,
                               BoneWeightOptions options);

// What begins where, as somebody knows it who knows the body.
struct NearestBones {
    std::span<const uint32_t> of_vertex;  // the bone that is nearest within the body
    std::span<const uint32_t> ends;       // the joint at each bone's `to`
};

// The same for any mesh. Bones that have an end in common with a vertex' nearest one share in its beginning where they
// are about as near, by the distance from the shape around them. Takes what the other takes.
Task<BoneWeights> bone_weights(Pace& pace, const MergedMesh& mesh, NearestBones nearest, BoneRig rig,
                               BoneWeightOptions options);

}  // namespace flg
