// SPDX-License-Identifier: MIT
#include "surfaces/mesh_measures_borders.h"

namespace flg {

BordersKernel::BordersKernel(const Mesh& mesh, Memory* memory)
    : mesh_(mesh), loops_(memory), visited_((size_t{mesh.vertex_count()} + 63) / 64, memory) {}

// True at a border vertex that was not visited before; it is then part of the loop.
bool BordersKernel::visit(uint32_t vertex) {
    if (mesh_.neighbour_at(mesh_.corner_of_vertex[vertex]) != no_index) return false;
    uint64_t& word = visited_[vertex / 64];
    const uint64_t bit = uint64_t{1} << (vertex % 64);
    if (word & bit) return false;
    word |= bit;
    loops_.vertices.push_back(vertex);
    return true;
}

bool BordersKernel::run(uint32_t count) {
    for (; cleared_ < visited_.size(); --count) {
        if (count == 0) return false;
        visited_[cleared_++] = 0;
    }
    for (; at_ < mesh_.vertex_count(); --count) {
        if (count == 0) return false;
        if (walker_ == no_index) {
            if (visit(at_)) {
                walker_ = at_;
            } else {
                ++at_;
            }
            continue;
        }
        // The first corner of a border vertex is where the border edge leaves.
        walker_ = mesh_.vertex_at(next_corner(mesh_.corner_of_vertex[walker_]));
        if (!visit(walker_)) {
            loops_.offsets.push_back(loops_.vertex_count());
            walker_ = no_index;
        }
    }
    return true;
}

}  // namespace flg
