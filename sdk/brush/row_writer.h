// SPDX-License-Identifier: MIT
// Rows of vertices, and the triangles between them, into a host's buffers: written from front to back, never read.
#pragma once

#include <cstdint>

#include "brush/cross_section.h"
#include "brush/library.h"

namespace flg::brush {
inline namespace FLG_BRUSH_LIBRARY {

// The columns that vertices have.
enum class Of : uint32_t { position, normal, tangent, color, uv };
constexpr uint32_t column_kinds = 5;

// Where vertices and indices go; checked, with strides and components, at most 4. Null data: not wanted.
struct Output {
    FlgBufferColumn columns[column_kinds] = {};
    void* indices = nullptr;
    bool narrow_indices = false;     // 16 bits
    uint32_t first_index_value = 0;  // the index of the first vertex written

    FlgBufferColumn& operator[](Of kind) { return columns[static_cast<uint32_t>(kind)]; }
    const FlgBufferColumn& operator[](Of kind) const { return columns[static_cast<uint32_t>(kind)]; }
};

// x, y, z, and one more.
using Lanes = float __attribute__((vector_size(16)));

// One row: where it stands, and how its cross-section lies. Of a left-handed mesh z is turned already.
struct Row {
    Lanes center;
    Lanes tangent, normal, binormal;  // unit
    Lanes arm[2];                     // what the section's place is multiplied by, metres
    float normal_out, normal_along;   // of a tube: the parts of its normals across and along the tangent
    float along;                      // first texture coordinate
    float width;                      // second one where `around` is 1
    float color[4];
};

class RowWriter {
public:
    RowWriter(const Style& style, const CrossSection& section, const Output& output);

    // Returns the row's number: that of its first vertex, counted from the first written.
    int64_t write(const Row& row);
    // One vertex at row.center.
    int64_t write_apex(const Row& row, const Lanes& facing);
    // Between two rows, the second ahead of the first along the tangent, or with `back` behind it. Rows written by
    // calls before have negative numbers.
    void strip(int64_t from, int64_t to, bool back);
    // From a row to the one written right after it.
    void strip_ahead(int64_t from);
    // To a row that is a tip, and to an apex.
    void tip(int64_t from, int64_t to, bool back);
    void fan(int64_t from, int64_t apex, bool back);

    uint64_t vertex_count() const { return static_cast<uint64_t>(vertices_); }
    uint64_t index_count() const { return indices_; }

private:
    template <class Index>
    void strip_as(int64_t from, int64_t to, bool back);
    template <class Index>
    void strip_ahead_as(int64_t from);
    void triangle(int64_t a, int64_t b, int64_t c, bool back);
    bool wanted(Of kind) const { return output_[kind].data != nullptr; }
    // value(v): `own` numbers of the row's vertex v; the column's `fill` after them.
    template <uint32_t own, class Value>
    void store(Of kind, uint32_t count, Value value);
    void write_places_and_normals(const Row& row);

    const Style& style_;
    const CrossSection& section_;
    Output output_;
    bool plain_;                     // positions and normals are wanted, as floats
    uint32_t ahead_[6 * max_sides];  // the corners from a row to the next, counted from the row's first vertex
    int64_t vertices_ = 0;
    uint64_t indices_ = 0;
};

}  // namespace FLG_BRUSH_LIBRARY
}  // namespace flg::brush
