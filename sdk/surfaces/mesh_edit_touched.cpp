// SPDX-License-Identifier: MIT
#include "surfaces/mesh_edit_touched.h"

namespace flg {

TouchedVertexSearch::TouchedVertexSearch(const Mesh& mesh, const MeshEdit& edit, TouchedVertices& out, Memory* memory)
    : mesh_(mesh), edit_(edit), out_(out), touched_((size_t{edit.before().vertices} + 63) / 64, memory) {}

void TouchedVertexSearch::touch(uint32_t vertex, std::pmr::deque<uint32_t>& list) {
    if (vertex >= edit_.before().vertices) return;
    uint64_t& word = touched_[vertex / 64];
    const uint64_t bit = uint64_t{1} << vertex % 64;
    if ((word & bit) != 0) return;
    word |= bit;
    list.push_back(vertex);
}

void TouchedVertexSearch::visit(uint32_t triangle) {
    for (Corner corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
        if (pass_ == Pass::changed) {
            touch(mesh_.vertex_at(corner), out_.changed);
        } else if (const Corner across = mesh_.opposite(corner); across != no_index) {
            touch(mesh_.vertex_at(previous_corner(across)), out_.facing);
        }
    }
}

void TouchedVertexSearch::visit_around(uint32_t vertex) {
    const Corner first = mesh_.corner_of_vertex[vertex];
    Corner corner = first;
    do {
        visit(triangle_of(corner));
        corner = mesh_.turn(corner);
    } while (corner != first && corner != no_index);
}

// Overwritten triangles are found by their words, then come those added.
size_t TouchedVertexSearch::size_of(Pass pass) const {
    if (pass == Pass::clear) return touched_.size();
    return edit_.words().size() + edit_.after().triangles - edit_.before().triangles;
}

bool TouchedVertexSearch::run(uint32_t count) {
    const size_t words = edit_.words().size();
    while (count > 0 && pass_ != Pass::done) {
        for (; count > 0 && at_ < size_of(pass_); ++at_, --count) {
            if (pass_ == Pass::clear) {
                touched_[at_] = 0;
            } else if (at_ >= words) {
                visit(edit_.before().triangles + static_cast<uint32_t>(at_ - words));
            } else if (const MeshEdit::Word& word = edit_.words()[at_]; word.array == array_triangles) {
                if (word.index % 3 == 0) visit(word.index / 3);
            } else if (word.array == array_positions) {
                if (word.index % 3 == 0) visit_around(word.index / 3);
            }
        }
        if (at_ < size_of(pass_)) break;
        at_ = 0;
        pass_ = static_cast<Pass>(static_cast<int>(pass_) + 1);
    }
    return pass_ == Pass::done;
}

}  // namespace flg
