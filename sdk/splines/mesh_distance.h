// SPDX-License-Identifier: MIT
// The distance from a triangle mesh on the nodes of a grid, with a sign for what is inside (Tsai: Rapid and accurate
// computation of the distance function using grids, 2002, as Hofer and Pottmann 2004, sec. 5, use it): exact at the
// nodes next to triangles, and further out by sweeping, where a node tries the triangles that are nearest to its
// neighbours, and then walks across the mesh while that leads nearer. A value is the exact distance from a triangle, as
// a rule from the nearest one.
//
// Inside: along the lines of nodes in each of the three directions, triangles that are crossed count by their sense; a
// node is inside if two of the three counts are not 0. An edge's side is decided once for the triangles on both sides,
// so closed meshes are counted exactly, whatever lies on an edge; holes that are small and few are outvoted. Of an open
// mesh take no sign.
#pragma once

#include "splines/sampled_distance.h"
#include "surfaces/mesh.h"

namespace flg {

class MeshDistanceKernel {
public:
    static constexpr uint32_t least_cells = 8, most_cells = 192;

    // reach: metres > 0, how far around the mesh's box the distance is needed. cells: along the longest side of the
    // box, reach included; least_cells to most_cells. has_sign: negative inside. Throws a Failure for values out of
    // their range and, while it runs, for a mesh that is to have an inside and holds no node. The mesh does not change
    // meanwhile; `out` is complete when run() returned true.
    MeshDistanceKernel(const Mesh& mesh, double reach, uint32_t cells, bool has_sign, SampledDistance& out,
                       Memory* memory);

    // A unit is 16 nodes of a triangle's box, or 8 nodes of a sweep, or 64 of simpler passes: about 1 us. Memory: 9
    // bytes a node besides the result's 4, 15 with sign.
    bool run(uint32_t count);

private:
    enum class Pass { box, clear, splat, sweep, polish, cross, count, sign, filter, done };

    void enter(Pass pass);
    void measure();
    void choose_grid();
    void clear();
    void splat();
    void sweep();
    void polish();
    void cross();
    void count_line();
    void sign();
    void filter();
    uint32_t line_count() const { return out_.grid.size() / out_.grid.counts[axis_]; }
    uint32_t line_start() const;
    bool begin_triangle(double wider);
    Vec3 place() const;
    bool try_triangle(uint32_t node, uint32_t triangle, const Vec3& x, double most);

    const Mesh& mesh_;
    double reach_;
    uint32_t cells_;
    bool has_sign_;
    SampledDistance& out_;
    Memory* memory_;
    Buffer<float> values_;      // a node's distance, m
    Buffer<uint32_t> nearest_;  // a node's triangle
    Buffer<uint8_t> changed_;   // the sweep it is from
    std::array<Buffer<int16_t>, 3> windings_;
    Pass pass_ = Pass::box;
    uint32_t at_ = 0, axis_ = 0;
    uint32_t sweep_ = 0,
             last_change_ = 0;  // counted from 8; the order of a sweep is its number, bit k: backwards along axis k
    std::array<uint32_t, 3> cell_{}, first_{}, last_{};  // of the nodes around a triangle, or of a sweep
    bool in_triangle_ = false;
    std::optional<DistanceGridKernel> filter_;
};

}  // namespace flg
