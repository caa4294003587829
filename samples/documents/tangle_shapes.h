// SPDX-License-Identifier: MIT
// Shapes placed in cells: outlines of a drawing, one instance a cell, in its tangent plane.
#pragma once

#include <span>

#include "documents/mesh_surface.h"
#include "documents/space_lines.h"

namespace flg::cli {

// Where a cell has the most room.
struct CellMiddle {
    uint32_t vertex = FLG_NO_INDEX;  // no vertex of the cell is off its borders
    float radius = 0;                // metres, along the surface, to the nearest border
    Vector normal = {};
};

// One a cell. Cells are labels of the surface as it is. Throws InputError.
std::vector<CellMiddle> find_middles(Session& session, const MeshSurface& surface, std::span<const uint32_t> cells,
                                     const std::string& subject, Report& report);

// Turns closed lines of a drawing in the plane z = 0 so that what they enclose, by the even-odd rule, is to their left;
// moves all so that the middle of their box is the origin and the farthest point 1 away.
void prepare_shape(SpaceLines& shape);

// Adds the shape at a place: `radius` metres large, its y axis along the world's, as far as it is in the tangent plane,
// turned counter-clockwise.
void place_shape(const SpaceLines& shape, const Vector& at, const Vector& normal, double radius, double turn_rad,
                 SpaceLines& out);

}  // namespace flg::cli
