// SPDX-License-Identifier: MIT
// Lines through the middle of a solid: a tree from a root deep inside to the ends of all limbs.
//
// This work is based on Sato, Bitter, Bender, Kaufman, Nakajima: TEASAR: tree-structure extraction algorithm for
// accurate and robust skeletons, 2000. Again and again the cell that is farthest from the root, by the way within the
// solid, is joined to the tree by the way that keeps farthest from the surface, and what the new branch fills is done.
//
// Departures: the price of a step is a power of the depth there, so ways are in the middle of thin limbs as of thick
// ones. Branches that hardly leave what is there already are none. Of a solid that is its own mirror image one half is
// looked at; what runs along the plane in the middle lies in it, and other branches are there twice.
#pragma once

#include <cstdint>
#include <vector>

#include "solids/solid_grid.h"

namespace flg {

struct CurveNode {
    Vec3 at;
    double radius;    // of the solid around it
    uint32_t parent;  // comes before it; no_curve_node: the root
    bool is_middle;   // in the plane of the mirror; where there is none no node is
};
inline constexpr uint32_t no_curve_node = UINT32_MAX;

struct CurveSkeleton {
    explicit CurveSkeleton(Memory* memory) : nodes(memory) {}

    // The first is the root. On the side that the frame's first axis points to if there is a mirror.
    std::pmr::vector<CurveNode> nodes;
};

// A branch must leave the ball around where it begins by `shortest`. At least one cell is inside, and cells hang
// together (join_solid_pieces). About 3 us a cell inside.
Task<CurveSkeleton> curve_skeleton(Pace& pace, const SolidGrid& grid, const Buffer<float>& depths, double shortest);

}  // namespace flg
