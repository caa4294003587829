// SPDX-License-Identifier: MIT
// The cross-section of a brush, and the rows of its vertices that make a cap.
#pragma once

#include <cstdint>

#include "brush/library.h"
#include "filigree/filigree_brush.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

constexpr uint32_t min_sides = 3, max_sides = 64;

// How a mesh is made: what is the same for all points.
struct Style {
    FlgBrushShape shape = FLG_BRUSH_SHAPE_TUBE;
    FlgBrushCap start_cap = FLG_BRUSH_CAP_FLAT, end_cap = FLG_BRUSH_CAP_FLAT;
    FlgBrushJoin join = FLG_BRUSH_JOIN_MITER;
    float cap_length = 2;
    double corner_angle = 0;  // radians
    uint32_t sides = 8;
    bool hard = false;
    bool uv = false;
    bool uv_along_unit = false, uv_around_unit = true;
    bool left_handed = false;

    bool tube() const { return shape == FLG_BRUSH_SHAPE_TUBE; }
};

// The vertices of one row, in the plane of the frame's two normals, and the quads between two rows.
struct CrossSection {
    static constexpr uint32_t most = 2 * max_sides;

    explicit CrossSection(const Style& style);

    // What its number of vertices and quads is, without making it.
    static uint32_t vertex_count(const Style& style);
    static uint32_t quad_count(const Style& style) { return style.tube() ? style.sides : 1; }

    uint32_t vertices, quads;
    float place[2][most];                        // along the first and the second normal, of unit size
    float normal[2][most];                       // likewise
    float around[most];                          // 0 to 1
    uint32_t left[max_sides], right[max_sides];  // of each quad
};

// A cap's row: its size and its distance from the end, in radii, and its normal, outwards and ahead.
struct CapRow {
    float size, ahead;
    float normal_out, normal_ahead;
};

// Rows from the curve's end outwards; the last one shrinks to a tip, with a vertex for each side, or to an apex.
struct CapProfile {
    static constexpr uint32_t max_rows = max_sides / 4 + 1;

    CapProfile(const Style& style, FlgBrushCap cap);

    uint32_t row_count = 0;
    bool apex = false;
    CapRow rows[max_rows];
    float apex_ahead = 0;

    uint32_t vertex_count(uint32_t a_row) const { return row_count * a_row + (apex ? 1 : 0); }
    uint32_t triangle_count(uint32_t quads) const {
        if (row_count == 0) return 0;
        return apex ? (2 * row_count - 1) * quads : quads;
    }
};

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
