// SPDX-License-Identifier: MIT
// What a cable's straight pieces keep above: planes that part them from solids, placed anew where these are nearest.
//
// Of a mesh some planes part all of a piece from its triangles within reach: what keeps above with both ends passes
// through nothing. Of a convex solid one plane does, and the place where the piece is nearest keeps above; its ends may
// come nearer to the solid by a share of their way, so that the piece can turn about an edge that it lies on, as the
// plane does when it is placed anew. Of other solids, and where a piece is in one, it is its end that keeps above, and
// where it is deepest.
#pragma once

#include <deque>

#include "core/vec.h"
#include "runtime/each.h"
#include "splines/obstacles/obstacle.h"

namespace flg {

struct ContactPlane {
    enum class Of : uint8_t { piece, node, middle };

    uint32_t obstacle = 0;
    Of of = Of::piece;
    // Places of the piece that keep above it.
    static constexpr uint32_t most = 3;
    uint32_t count = 1;
    double at[most] = {};
    double drop[most] = {};   // metres, by which the plane is lower there
    double force[most] = {};  // over the weight of a metre: metres
    Vec3 outwards = Vec3::Zero();
    double height = 0;  // metres, along that
    double away = 0;    // metres: how far the piece was when it was placed
};

struct PieceContacts {
    static constexpr uint32_t most = 8;

    ContactPlane planes[most];
    uint32_t count = 0;
    double margin = 0;        // metres
    bool is_refined = false;  // more places are looked at
};

struct CableContacts {
    CableContacts(const ObstacleSet& solids, Memory* memory) : set(solids), pieces(memory) {}

    const ObstacleSet& set;
    std::pmr::deque<PieceContacts> pieces;  // blocks, which go back one by one
    double reach = 0;                       // metres: so near obstacles have planes
    double length = 0;                      // of a piece, metres
    double turn_share = 0;                  // of their way to a solid that ends may come nearer
};

// The planes of what is near, as the places are. With the forces of those before.
Task<void> place_planes(Pace& pace, CableContacts& contacts, const Buffer<Vec3>& places);

struct Breach {
    uint32_t piece, obstacle;
    double at, depth;  // metres
};

// Where pieces are inside. Beside the ends they may be, by `slack`.
Task<std::pmr::vector<Breach>> find_breaches(Pace& pace, const ObstacleSet& set, const Buffer<Vec3>& places,
                                             double slack);

Task<bool> is_free(Pace& pace, const ObstacleSet& set, const Buffer<Vec3>& places, double slack);

// Whether a straight piece may be so near to an obstacle: a quick bound.
inline bool may_be_below(const ObstacleSet& set, uint32_t obstacle, const Vec3& a, const Vec3& b, double away) {
    const Vec3 middle = 0.5 * (a + b);
    return set.at_least(obstacle, middle.data()) < away + 0.5 * (b - a).norm();
}

struct Clearest {
    double away;  // metres; below 0: inside
    double at;    // of the piece, 0 to 1
};

// The least distance of a straight piece from an obstacle; of one that is far away it may be HUGE_VAL.
Task<Clearest> least_distance(Pace& pace, const ObstacleSet& set, uint32_t obstacle, Vec3 a, Vec3 b);

// What is inside keeps farther away.
Task<void> keep_farther(Pace& pace, CableContacts& contacts, const std::pmr::vector<Breach>& breaches, double rest);

}  // namespace flg
