// SPDX-License-Identifier: MIT
// Positions and columns of a mesh that was refined, by the weights of a rule (mesh_refine.h). All weights are positive:
// values stay within those around them.
#pragma once

#include <vector>

#include "surfaces/mesh_growth.h"

namespace flg {

enum class RefineRule { midpoint, loop };

// Edges are numbered by one of their corners: the one of the triangle with the lesser index.
inline bool is_edge_owner(const Mesh& mesh, Corner corner) {
    return mesh.neighbour_at(corner) > triangle_of(corner);  // no_index is greater, too
}

// A unit is a corner: about 30 ns, and 3 ns a component of the columns.
class RefineValuesKernel {
public:
    // `fine` comes from RefineTrianglesKernel, `fine_columns` is empty. All but `memory` outlive the kernel.
    RefineValuesKernel(const Mesh& coarse, const MeshColumns& columns, RefineRule rule, Mesh& fine,
                       MeshColumns& fine_columns, Memory* memory);
    bool run(uint32_t count);

private:
    struct Channel {
        uint32_t components;
        const float* in;
        float* out;
    };
    void clear();
    void add(uint32_t vertex, double weight);
    void store(uint32_t vertex);
    void place_edge(Corner corner);
    void keep_vertex();
    void step_vertex();
    void end_vertex(Corner last);

    const Mesh& coarse_;
    RefineRule rule_;
    const Mesh& fine_;
    std::pmr::vector<Channel> channels_;  // the position, then the columns
    std::pmr::vector<double> sums_;       // of all channels' components, for the vertex at hand
    uint32_t vertex_ = 0;
    Corner corner_ = no_index;  // of vertex_, the one that was added last; no_index before the first
    uint32_t valence_ = 0;
    Corner edge_ = 0;
};

}  // namespace flg
