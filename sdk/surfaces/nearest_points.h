// SPDX-License-Identifier: MIT
// The points of a mesh that are nearest to given ones. Triangles are sorted into a grid by their middles; the search widens
// ring by ring of cells, until no triangle farther out could be nearer, however far it reaches from its middle.
//
// Of equally near triangles the one with the lowest number is taken.
#pragma once

#include "surfaces/surface_point.h"

namespace flg {

class NearestPoints {
public:
    // The mesh must not change while this lives, and has one triangle at least. Memory: 8 bytes a triangle.
    NearestPoints(const Mesh& mesh, Memory* memory) : mesh_(mesh), memory_(memory) {}

    // Sorts the triangles; true when done. A unit is a triangle or a cell: about 20 ns in each of five passes.
    bool build(uint32_t count);

    // After build() returned true: begins a search, for find() to go on with. The place is finite.
    void begin(const Position& place);
    // A unit is a cell or a triangle: about 50 ns; true when done.
    bool find(uint32_t count);
    // After find() returned true.
    const SurfacePoint& found() const { return found_; }

private:
    using Cell = std::array<int32_t, 3>;
    enum class Pass { measure, clear, count, sum, place, done };

    void enter(Pass pass);
    void measure();
    void choose_cells();
    Vec3 middle(uint32_t triangle) const;
    Cell cell_of(const Vec3& place) const;
    uint32_t index_of(const Cell& cell) const;
    void enter_ring();
    bool next_cell();
    void try_triangle(uint32_t triangle);

    const Mesh& mesh_;
    Memory* memory_;
    Pass pass_ = Pass::measure;
    uint32_t at_ = 0;
    Vec3 lower_, upper_;
    double reach_ = 0;       // metres: the farthest that a triangle reaches from its middle
    double size_ = 1;        // metres, of a cell
    Cell cells_{};           // so many along each axis
    Buffer<uint32_t> ends_;  // the triangles of cell c are those of the list from ends[c - 1] to ends[c] - 1
    Buffer<uint32_t> list_;

    Vec3 place_;
    Cell centre_{};
    int32_t ring_ = 0, last_ring_ = 0;  // cells that are so many away along some axis, and no more along the others
    Cell first_{}, last_{}, cell_{};    // of the ring, where there are cells; the one that comes next
    bool in_ring_ = false;
    uint32_t next_ = 0, end_ = 0;  // of the list
    double square_ = 0;            // of the distance of what was found
    SurfacePoint found_{};
};

}  // namespace flg
