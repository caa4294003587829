// SPDX-License-Identifier: MIT
// The points of a mesh that are nearest to given ones. Triangles are sorted into a grid by their middles; the search
// widens ring by ring of cells, until no triangle farther out could be nearer, however far it reaches from its middle.
//
// Of equally near triangles the one with the lowest number is taken.
#pragma once

#include <memory>

#include "runtime/each.h"
#include "surfaces/mesh/surface_point.h"

namespace flg {

// Copies share what was built, and search side by side.
class NearestPoints {
public:
    // The mesh must not change while this lives, and has one triangle at least. To be built before a search.
    explicit NearestPoints(const Mesh& mesh) : mesh_(mesh) {}
    friend Task<void> build(Pace& pace, NearestPoints& nearest);

    // Begins a search, for find() to go on with. The place is finite.
    void begin(const Vec3& place);
    void begin(const Position& place) { begin(load_vec3(place.data())); }
    // A unit is a cell or a triangle: about 50 ns; true when done. (A kernel: how far it has to go is not known before,
    // and searches are too many and too short for a task each.)
    bool find(uint32_t count);
    // After find() returned true.
    const SurfacePoint& found() const { return found_; }
    // The same to all digits.
    const Vec3& found_place() const { return found_place_; }

private:
    using Cell = std::array<int32_t, 3>;

    void measure(uint32_t triangle);
    void choose_cells();
    Vec3 middle(uint32_t triangle) const;
    Cell cell_of(const Vec3& place) const;
    uint32_t index_of(const Cell& cell) const;
    void enter_ring();
    bool next_cell();
    void try_triangle(uint32_t triangle);

    const Mesh& mesh_;
    Vec3 lower_ = Vec3::Zero(), upper_ = Vec3::Zero();
    double reach_ = 0;                       // metres: the farthest that a triangle reaches from its middle
    double size_ = 1;                        // metres, of a cell
    Cell cells_{};                           // so many along each axis
    std::shared_ptr<const Groups> of_cell_;  // triangles, by the cell of their middle

    Vec3 place_ = Vec3::Zero();
    Cell centre_{};
    int32_t ring_ = 0, last_ring_ = 0;  // cells that are so many away along some axis, and no more along the others
    Cell first_{}, last_{}, cell_{};    // of the ring, where there are cells; the one that comes next
    bool in_ring_ = false;
    uint32_t next_ = 0, end_ = 0;  // of the list
    double square_ = 0;            // of the distance of what was found
    SurfacePoint found_{};
    Vec3 found_place_ = Vec3::Zero();
};

// Sorts the triangles. About 100 ns a triangle. Memory, kept: 12 bytes a triangle.
Task<void> build(Pace& pace, NearestPoints& nearest);

}  // namespace flg
