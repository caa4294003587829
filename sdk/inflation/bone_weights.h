// SPDX-License-Identifier: MIT
// How much each joint moves each vertex of a surface. Each vertex begins with the nearest bone of the part that it lies on;
// then that is spread over the surface, twice,
//
//     (M + T L) w = M w_before
//
// with areas M, the cotangent Laplacian L (weights of edges at least a little above zero), and T from how thick the shape is there. The
// matrix is an M-matrix whose rows sum to M: so weights stay within [0, 1] and sum to 1 without constraints (maximum principle), one
// factorization serves all joints and both times, and there is nothing to iterate. Twice, because that leaves no kink where a
// bone's region ends (once is the bone heat of Baran, Popovic: Automatic rigging and animation of 3D characters, 2007, turned inside out).
// The paper uses bounded biharmonic weights (Jacobson et al. 2011), a quadratic program a bone on a mesh of tetrahedra; in
// tests/reference they are literal, and the tests compare.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "inflation/dissection_order.h"
#include "inflation/merged_mesh.h"
#include "inflation/sparse_cholesky.h"
#include "skeletons/bone_tree.h"

namespace flg {

struct BoneWeightOptions {
    // How far weights are spread, by the radius of the shape: across a joint four fifths of the change take about 4.6 times this.
    // 0.05 to 2.
    double reach = 0.4;
};

// At most four joints a vertex, the largest weight first; weights are within [0, 1], sum to 1 up to rounding; unused ones are joint 0 with weight 0.
struct BoneWeights {
    Buffer<std::array<uint16_t, 4>> joints;
    Buffer<std::array<float, 4>> weights;
};

class BoneWeightsKernel {
public:
    // At least one bone; joints below 65536. All outlive the kernel. Throws, with a sentence, if something is out of range or not finite.
    BoneWeightsKernel(const MergedMesh& mesh, std::span<const BoneSegment> bones, const BoneWeightOptions& options,
                      BoneWeights& out, Memory* memory);

    // A unit is about 0.4 us. About 40 units a vertex, and 5 a vertex for each eight joints.
    bool run(uint32_t count);

private:
    static constexpr uint32_t kept = 5;  // the largest of each vertex: four, and what they are above
    enum class Pass {
        clear_joints,
        mark_joints,
        number_joints,
        clear,
        measure,
        nearest,
        assemble,
        order,
        factor,
        load,
        solve,
        load_again,
        solve_again,
        collect,
        finish,
        done
    };
    // The nearest joints of a vertex.
    struct Near {
        uint32_t column = 0;
        double distance = 0;  // later its weight
        double radius = 0;
    };

    void step();
    void mark_joint(const BoneSegment& bone, uint32_t number);
    void measure(uint32_t triangle);
    void nearest();
    void offer(const BoneSegment& bone);
    void end_nearest(uint32_t vertex);
    void load(uint32_t vertex);
    void collect(uint32_t vertex);
    void finish(uint32_t vertex);

    const MergedMesh& mesh_;
    std::span<const BoneSegment> bones_;
    BoneWeightOptions options_;
    BoneWeights& out_;
    Memory* memory_;
    Buffer<uint32_t> column_of_joint_;
    std::pmr::vector<uint16_t> joint_of_column_;
    Buffer<std::array<double, 3>> cotangents_;
    Buffer<double> area_, spread_;
    std::array<Near, 4> near_{};
    uint32_t near_count_ = 0, bone_ = 0;
    bool any_part_ = false;                          // the vertex's own part has no bones: those of all are looked at
    Buffer<std::array<uint32_t, 4>> first_columns_;  // of a vertex, with the weights it begins with
    Buffer<std::array<float, 4>> first_weights_;
    SymmetricMatrix matrix_;
    std::optional<MeshLaplacian> laplacian_;
    std::optional<DissectionOrder> order_;
    std::optional<SparseCholesky> cholesky_;
    std::optional<CholeskySolve> solve_;
    Buffer<double> values_;  // eight columns
    uint32_t column_ = 0;    // the first of them
    Buffer<std::array<float, kept>> largest_;
    Buffer<std::array<uint16_t, kept>> largest_joints_;
    Pass pass_ = Pass::clear_joints;
    uint32_t at_ = 0;
};

}  // namespace flg
