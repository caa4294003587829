// SPDX-License-Identifier: MIT
// Other triangles for the same surface, where its own are too obtuse to measure distances with: edges are flipped
// within the surface, whose shape and mesh stay as they are. (Fisher, Springborn, Bobenko, Schroeder: An algorithm for
// the construction of intrinsic Delaunay triangulations, 2006.) Departure: an edge is flipped where the angles opposite
// to it exceed 1.23 half turns together, not 1. The solver copes with the rest; so groups of flips are small on most
// meshes, and changes local.
//
// Invariants
// - A flip takes two triangles and gives two, under the same numbers. Triangles that are not here are the mesh's.
// - What is flipped depends on the mesh's shape and numbers alone, not on its history: flips go in the order in which
//   edges were found, those of the mesh first, by number. Flips that share no triangle do not depend on each other, so
//   a group of triangles that do can be given up and flipped anew by itself.
// - Lengths are double; a decision takes only correctly rounded operations.
#pragma once

#include <array>
#include <deque>

#include "surfaces/mesh/index_table.h"
#include "surfaces/mesh/mesh.h"
#include "surfaces/mesh/region_set.h"

namespace flg {

struct IntrinsicTriangle {
    Triple vertices;
    std::array<Corner, 3> across;   // of edge k: where the same edge starts in the triangle across; no_index: a border
    std::array<double, 3> lengths;  // of edge k, metres

    // Twice its area, metres^2.
    double twice_area() const;
    // Of half the angle at corner k.
    double half_tangent(uint32_t k) const;
};

class IntrinsicTriangles {
public:
    explicit IntrinsicTriangles(Memory* memory) : members_(memory) {}

    // Null: the triangle is the mesh's own.
    const IntrinsicTriangle* find(uint32_t triangle) const {
        const uint32_t slot = table_.find(triangle);
        return slot == no_index || !members_[slot].is_used ? nullptr : &members_[slot].shape;
    }
    // Of the group of a triangle that is found: those that flips join, and those that lie at them. A ring.
    uint32_t next_of_group(uint32_t triangle) const { return members_[members_[table_.find(triangle)].next].triangle; }
    bool empty() const { return members_.empty(); }

private:
    friend class EdgeFlipper;
    struct Member {
        IntrinsicTriangle shape;
        uint32_t triangle;
        uint32_t next;   // of its group, a ring
        uint32_t root;   // of its group, by way of others
        uint32_t flips;  // that it took part in
        uint32_t run;    // in which it became a member
        bool is_used;
    };

    std::pmr::deque<Member> members_;
    IndexTable table_;  // from triangles to members
    uint32_t run_ = 0;
};

// A surface as flips see it. Of regions, what lies beyond them is not there.
struct IntrinsicSurface {
    const Mesh& mesh;
    const GrowingBuffer<Position>& positions;            // of the metric
    const RegionSet* within = nullptr;                   // null: all
    const IntrinsicTriangles* flipped = nullptr;         // null: none
    const IntrinsicTriangles* flipped_before = nullptr;  // what holds of triangles that are not in `flipped`

    bool contains(uint32_t triangle) const { return !within || within->contains(mesh.regions[triangle]); }
    const IntrinsicTriangle* find(uint32_t number) const {
        const IntrinsicTriangle* found = flipped ? flipped->find(number) : nullptr;
        return found || !flipped_before ? found : flipped_before->find(number);
    }
    IntrinsicTriangle triangle(uint32_t number) const;
    // The mesh's.
    IntrinsicTriangle own_triangle(uint32_t number) const;
    uint32_t vertex_at(Corner corner) const {
        const IntrinsicTriangle* found = find(triangle_of(corner));
        return found ? found->vertices[corner % 3] : mesh.vertex_at(corner);
    }
    Corner opposite(Corner corner) const;
    Corner within_or_none(Corner corner) const {
        return corner == no_index || !contains(triangle_of(corner)) ? no_index : corner;
    }
    // As those of a mesh.
    Corner turn(Corner corner) const { return opposite(previous_corner(corner)); }
    Corner turn_back(Corner corner) const {
        const Corner across = opposite(corner);
        return across == no_index ? no_index : next_corner(across);
    }
};

// An angle is obtuse if the edge opposite to it may have to be flipped for it: 110 degrees, by the tangent of its half.
constexpr float obtuse_half_tangent = 1.42f;

// What there is to flip.
struct FlipRequest {
    explicit FlipRequest(Memory* memory) : given_up(memory), restored(memory), edges(memory) {}

    std::pmr::deque<uint32_t> given_up;  // triangles whose groups are dissolved first
    std::pmr::deque<uint32_t> restored;  // triangles that are the mesh's own again, whatever `flipped_before` has
    std::pmr::deque<Corner> edges;       // opposite to obtuse angles; those of triangles above come by themselves
};

// Flips edges until none is left to flip. `flipped` is what `surface.flipped` shows; triangles of `flipped_before` stay
// as they are. Returns the triangles of groups that were dissolved or made: some more than once, some that the mesh has
// no more.
Task<std::pmr::deque<uint32_t>> flip_edges(Pace& pace, const IntrinsicSurface& surface, FlipRequest& request,
                                           IntrinsicTriangles& flipped);

}  // namespace flg
