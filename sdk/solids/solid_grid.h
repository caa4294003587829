// SPDX-License-Identifier: MIT
// The inside of a mesh as cells of a lattice.
//
// A cell is inside where the winding number around its middle is above one half: the mean of what rays along the axes
// count, in six directions. On closed meshes all six agree, also where pieces overlap; past holes they vote (a coarse
// form of Jacobson, Kavan, Sorkine-Hornung: Robust inside-outside segmentation using generalized winding numbers,
// 2013). Where a mesh is thinner than a cell, the cells it passes through are inside.
#pragma once

#include <array>
#include <cstdint>

#include "core/memory.h"
#include "core/vec.h"
#include "runtime/task.h"
#include "surfaces/mesh/mesh.h"

namespace flg {

// Axes of a lattice, at right angles, in columns; `middle` is where cells meet.
struct SolidFrame {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    Vec3 middle = Vec3::Zero();
    bool is_mirrored = false;  // what is on either side of the first axis is on the other side too
};

struct SolidGrid {
    SolidFrame frame;
    double cell = 0;                 // length of a side
    std::array<uint32_t, 3> size{};  // cells along the axes, even along the first
    Buffer<uint8_t> inside;          // by cell

    size_t count() const { return inside.size(); }
    uint32_t number(uint32_t x, uint32_t y, uint32_t z) const { return (z * size[1] + y) * size[0] + x; }
    std::array<uint32_t, 3> place(uint32_t number) const {
        return {number % size[0], number / size[0] % size[1], number / (size[0] * size[1])};
    }
    // From the corner, in cells.
    Vec3 local(const Vec3& at) const { return frame.axes.transpose() * (at - frame.middle) / cell + half(); }
    Vec3 middle_of(uint32_t number) const {
        const auto [x, y, z] = place(number);
        return frame.middle + cell * (frame.axes * (Vec3(x + 0.5, y + 0.5, z + 0.5) - half()));
    }
    Vec3 half() const { return {0.5 * size[0], 0.5 * size[1], 0.5 * size[2]}; }
};

// How a mesh lies, from moments of its surface: along its principal axes, or with the plane of its mirror image in the
// middle of the first axis if it has one. So a turned mesh has a turned lattice.
Task<SolidFrame> find_solid_frame(Pace& pace, const Mesh& mesh);

// About `cells` cells, with at least two around the mesh. Takes 10 ns a cell and 0.1 us a triangle, and 4 ns for each
// cell that one covers.
Task<SolidGrid> fill_solid(Pace& pace, const Mesh& mesh, SolidFrame frame, uint32_t cells);

// By cell: how far its middle is from the surface, in cells; 0 outside (Felzenszwalb, Huttenlocher: Distance transforms
// of sampled functions, 2012). About 20 ns a cell.
Task<Buffer<float>> solid_depths(Pace& pace, const SolidGrid& grid);

// The same number for cells that hang together by a side, an edge or a corner; the largest piece has 0.
// Joins all pieces by the shortest straight ways between them, which are inside from then on.
Task<void> join_solid_pieces(Pace& pace, SolidGrid& grid);

}  // namespace flg
