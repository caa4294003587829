// SPDX-License-Identifier: MIT
// A mesh as exact distances see it: each triangle laid out in the plane, from each of its edges.
#pragma once

#include <array>

#include "runtime/pace.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

// In the coordinates of an edge its first end is the origin, the second lies on the x axis, the triangle above.
struct ExactFace {
    std::array<double, 3> lengths;  // of edge k, metres; the same bits in both of its triangles
    std::array<double, 3> along;    // x and y of the corner opposite to edge k, in its coordinates: also the direction
    std::array<double, 3> above;    // in which corner k sees its second edge, if its first one is the x axis
    Triple vertices;                // no_index: not within the regions
    std::array<Corner, 3> across;   // edge k seen from its other triangle; no_index: none within the regions

    bool is_within() const { return vertices[0] != no_index; }
};

// Where a shortest path may turn.
enum class Bend : uint8_t {
    none,
    half_turns,  // by half a turn or more on both sides: the angles exceed a full turn, or a border is there
    any          // the vertex lies where a neighbour does, and has its angles too
};

struct ExactFaces {
    ExactFaces(const Mesh& mesh, Memory* memory)
        : faces(mesh.triangle_count(), memory), bends(mesh.vertex_count(), memory) {}

    Buffer<ExactFace> faces;
    Buffer<Bend> bends;            // by vertex
    double longest = 0, mean = 0;  // edge
    uint32_t narrow_count = 0;     // triangles with an edge that they are narrow above
};

// A triangle that is so flat above edge k can be crossed with next to no way.
constexpr double narrow_height = 1e-4;  // of the edge
inline bool is_narrow(const ExactFace& face, uint32_t k) {
    return face.above[k] < narrow_height * face.lengths[k];
}

Task<void> lay_out_faces(Pace& pace, const Mesh& mesh, const RegionSet& within, ExactFaces& out);

}  // namespace flg
