// SPDX-License-Identifier: MIT
#include "inflation/surface_extraction.h"

#include <algorithm>

namespace flg {

namespace {

constexpr uint32_t cells = SurfaceGrid::cells, corners = SurfaceGrid::corners;
constexpr std::array<uint32_t, 3> strides = {1, corners, corners* corners};

}  // namespace

SurfaceExtraction::SurfaceExtraction(const SurfaceGrid& grid, std::pmr::vector<Vec3>& positions,
                                     std::pmr::vector<TriangleVertices>& triangles, Memory* memory)
    : grid_(grid), blocks_(grid.blocks()), positions_(positions), triangles_(triangles), middles_(memory) {
    positions.clear();
    triangles.clear();
    positions.reserve(grid.vertex_count());
    triangles.reserve(2 * size_t{grid.crossed_count()});
}

bool SurfaceExtraction::run(uint32_t count) {
    for (; count > 0 && pass_ != Pass::done; --count) {
        if (block_ < blocks_.size()) {
            // Blocks without vertices have no crossed edges of their own.
            if (!blocks_[block_].vertices.empty()) {
                for (uint32_t x = 0; x < cells; ++x) {
                    if (pass_ == Pass::vertices) {
                        place_vertices(x, at_ % cells, at_ / cells);
                    } else {
                        for (uint32_t axis = 0; axis < 3; ++axis) add_polygon(axis, x, at_ % cells, at_ / cells);
                    }
                }
            } else {
                at_ = cells * cells - 1;
            }
            if (++at_ == cells * cells) {
                at_ = 0;
                ++block_;
            }
            continue;
        }
        block_ = 0;
        pass_ = pass_ == Pass::vertices ? Pass::polygons : Pass::done;
    }
    return pass_ == Pass::done;
}

void SurfaceExtraction::place_vertices(uint32_t x, uint32_t y, uint32_t z) {
    const SurfaceGrid::Block& here = blocks_[block_];
    const uint32_t inside = SurfaceGrid::inside_corners(here, x, y, z);
    if (inside == 0 || inside == 255) return;
    const DualCase& sheets = dual_cases[inside];
    Vec3 sums[4] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    uint32_t counts[4] = {};
    const float* values = &here.values[(z * corners + y) * corners + x];
    const auto value = [&](uint32_t corner) -> double {
        return values[(corner & 1) + (corner >> 1 & 1) * strides[1] + (corner >> 2) * strides[2]];
    };
    for (uint32_t edge = 0; edge < 12; ++edge) {
        const uint32_t axis = edge / 4, s = edge & 1, t = edge >> 1 & 1;
        const uint32_t a = cube_corner(axis, 0, s, t), b = cube_corner(axis, 1, s, t);
        if ((inside >> a & 1) == (inside >> b & 1)) continue;
        Vec3 crossing(a & 1, a >> 1 & 1, a >> 2);
        crossing[axis] += std::clamp(value(a) / (value(a) - value(b)), 0.0, 1.0);
        sums[sheets.patch[edge]] += crossing;
        ++counts[sheets.patch[edge]];
    }
    const Vec3 corner = grid_.place(cells * here.at[0] + x, cells * here.at[1] + y, cells * here.at[2] + z);
    for (uint32_t k = 0; k < sheets.count; ++k) positions_.push_back(corner + grid_.spacing() * (sums[k] / counts[k]));
}

SurfaceExtraction::Cell SurfaceExtraction::cell_at(std::array<uint32_t, 3> at) const {
    Cell cell;
    cell.block = grid_.block_at(at[0] / cells, at[1] / cells, at[2] / cells);
    for (uint32_t k = 0; k < 3; ++k) cell.at[k] = at[k] % cells;
    cell.inside = SurfaceGrid::inside_corners(blocks_[cell.block], cell.at[0], cell.at[1], cell.at[2]);
    return cell;
}

uint32_t SurfaceExtraction::vertex_of(const Cell& cell, uint32_t edge) const {
    return blocks_[cell.block].vertices[(cell.at[2] * cells + cell.at[1]) * cells + cell.at[0]] +
           dual_cases[cell.inside].patch[edge];
}

// Around the edge along `axis` from a corner of the block.
void SurfaceExtraction::add_polygon(uint32_t axis, uint32_t x, uint32_t y, uint32_t z) {
    const SurfaceGrid::Block& here = blocks_[block_];
    const float* values = &here.values[(z * corners + y) * corners + x];
    const bool from_inside = values[0] >= 0;
    if (from_inside == (values[strides[axis]] >= 0)) return;
    const uint32_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const std::array<uint32_t, 3> corner = {cells * here.at[0] + x, cells * here.at[1] + y, cells * here.at[2] + z};
    // Cells around it, counter-clockwise seen from the end of the edge; the edge is at (s, t) of each.
    constexpr uint32_t around[4][2] = {{1, 1}, {0, 1}, {0, 0}, {1, 0}};
    Cell cell[4];
    uint32_t vertex[8];  // of cells, and in between of middles
    uint32_t count = 0;
    for (uint32_t k = 0; k < 4; ++k) {
        std::array<uint32_t, 3> at = corner;
        at[u] -= around[k][0];
        at[v] -= around[k][1];
        cell[k] = cell_at(at);
    }
    const auto edge_of = [&](uint32_t k) { return 4 * axis + around[k][0] + 2 * around[k][1]; };
    std::array<uint32_t, 3> outside = corner;  // the end of the edge that is not inside
    if (from_inside) ++outside[axis];
    for (uint32_t k = 0; k < 4; ++k) {
        const uint32_t next = (k + 1) % 4;
        const uint32_t own = vertex_of(cell[k], edge_of(k)), other = vertex_of(cell[next], edge_of(next));
        vertex[count++] = own;
        // The face between this cell and the next: across u or v, at the side where the edge is not the same.
        const bool across_u = around[k][0] != around[next][0];
        const uint32_t face_axis = across_u ? u : v;
        const auto edges = face_edges(face_axis, around[k][across_u ? 0 : 1]),
                   next_edges = face_edges(face_axis, around[next][across_u ? 0 : 1]);
        const auto crossed = [&](uint32_t edge) {
            const uint32_t a = cube_corner(edge / 4, 0, edge & 1, edge >> 1 & 1),
                           b = cube_corner(edge / 4, 1, edge & 1, edge >> 1 & 1);
            return (cell[k].inside >> a & 1) != (cell[k].inside >> b & 1);
        };
        bool doubled = true;
        for (uint32_t e = 0; e < 4 && doubled; ++e)
            doubled = crossed(edges[e]) && vertex_of(cell[k], edges[e]) == own &&
                      vertex_of(cell[next], next_edges[e]) == other;
        if (!doubled) continue;
        // The face, by its lowest corner.
        std::array<uint32_t, 3> low = corner;
        const uint32_t other_axis = across_u ? v : u;
        low[other_axis] -= around[k][across_u ? 1 : 0];
        const uint32_t cut_off = ((outside[0] - low[0]) | (outside[1] - low[1]) << 1 | (outside[2] - low[2]) << 2);
        const auto [entry, added] = middles_.try_emplace({low[0], low[1], low[2], face_axis, cut_off},
                                                         static_cast<uint32_t>(positions_.size()));
        if (added) positions_.push_back((positions_[own] + positions_[other]) / 2);
        vertex[count++] = entry->second;
    }
    if (!from_inside) std::reverse(vertex, vertex + count);
    const auto add = [&](uint32_t a, uint32_t b, uint32_t c) { triangles_.push_back({a, b, c}); };
    if (count > 4) {
        Vec3 centre = Vec3::Zero();
        for (uint32_t k = 0; k < count; ++k) centre += positions_[vertex[k]] / count;
        const auto number = static_cast<uint32_t>(positions_.size());
        positions_.push_back(centre);
        for (uint32_t k = 0; k < count; ++k) add(vertex[k], vertex[(k + 1) % count], number);
        return;
    }
    const bool first = (positions_[vertex[0]] - positions_[vertex[2]]).squaredNorm() <=
                       (positions_[vertex[1]] - positions_[vertex[3]]).squaredNorm();
    const uint32_t s = first ? 0 : 1;
    add(vertex[s], vertex[s + 1], vertex[s + 2]);
    add(vertex[s], vertex[s + 2], vertex[(s + 3) % 4]);
}

}  // namespace flg
