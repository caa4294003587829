// SPDX-License-Identifier: MIT
// The edges of triangles that are being repaired, joined two by two. Unlike a mesh's neighbours mates need no vertices to
// be followed, so that they hold while windings differ and vertices are still to be split.
#pragma once

#include "surfaces/mesh.h"

namespace flg {

// Of each corner, the corner whose edge is joined to the one that starts here; no_index at a border. They take the place
// where the mesh's neighbours will be.
class Mates {
public:
    explicit Mates(GrowingBuffer<Triple>& place) : mates_(place) {}

    Corner operator[](Corner corner) const { return mates_[corner / 3][corner % 3]; }
    void leave_open(Corner corner) { mates_[corner / 3][corner % 3] = no_index; }
    void join(Corner a, Corner b) {
        mates_[a / 3][a % 3] = b;
        mates_[b / 3][b % 3] = a;
    }
    // Makes the edge, and what it was joined to, a border.
    void cut(Corner corner) {
        leave_open((*this)[corner]);
        leave_open(corner);
    }

    // The next corner of the same vertex counter-clockwise, clockwise; no_index at the end of an open fan. Between
    // triangles whose windings agree.
    Corner turn(Corner corner) const { return (*this)[previous_corner(corner)]; }
    Corner turn_back(Corner corner) const {
        const Corner across = (*this)[corner];
        return across == no_index ? no_index : next_corner(across);
    }

private:
    GrowingBuffer<Triple>& mates_;
};

}  // namespace flg
