// SPDX-License-Identifier: MIT
// The triangulation that a part is inflated on. The contour is thinned and divided to even edges, its inside is filled with a
// lattice of equal triangles that keeps off the border, and what is then still badly shaped gets points at the centres of
// circumcircles, or on the border where those fall beyond it (Ruppert: A Delaunay refinement algorithm for quality 2-dimensional
// mesh generation, 1995; Chew: Guaranteed-quality mesh generation for curved surfaces, 1993).
//
// Invariants
// - Each side inside has an end inside (no chord): so that no piece of the part stays flat, and so that two copies
//   with a common border make a closed manifold.
// - Angles are at least 25 degrees, but at corners of the contour that are sharper, next to edges that are at the least length, and
//   where the rule above forbids a flip. On smooth contours: at least 22 degrees, in the mean of triangles 50.
#pragma once

#include <optional>
#include <vector>

#include "inflation/inflated_part.h"
#include "inflation/plane_mesh.h"

namespace flg {

class PartMesh {
public:
    // Reads out.contour, from clean_contour, and fills points, on_border, triangles, spacing and area. All outlive the kernel.
    // Memory is taken as steps begin: about 500 bytes a vertex, and a byte a lattice place of the contour's box (at most a million).
    PartMesh(const InflationOptions& options, InflatedPart& out, Memory* memory);

    // A unit is about 0.3 us; about ten units a vertex. Throws, with a sentence, if the contour is not simple.
    bool run(uint32_t count);

private:
    enum class Pass {
        measure,
        thin,
        triangulate,
        number,
        clear,
        mark,
        choose,
        extract,
        legalize,
        fill,
        search,
        gather,
        refine,
        write,
        done
    };

    void step();
    void measure_end();
    void thin();
    void end_ring();
    void add_edge(uint32_t from, uint32_t to);
    void end_thinning();
    void end_triangulation();
    void end_extraction();
    void begin_lattice();
    void mark(uint32_t vertex);
    void fill();
    void search();
    void insert_at(const PlaneMesh::Place& place);
    void refine();
    void improve(int32_t triangle);
    bool split_chord(int32_t triangle);
    void split_border(int32_t triangle, uint32_t side);
    void legalize_then(Pass pass);
    Point2 lattice_point(uint32_t row, uint32_t column) const;
    void write();
    Point2 scaled(const Point2& p) const;
    void changed(int32_t triangle);

    InflatedPart& out_;
    const Contour& contour_;
    Memory* memory_;
    double wanted_spacing_;
    double spacing_ = 0;  // as scaled
    double perimeter_ = 0, twice_area_ = 0;
    Point2 low_, high_, middle_{};
    int exponent_ = 0;     // scaled = (contour - middle) * 2^-exponent
    bool thinned_ = true;  // points that are nearly on the way between others are dropped; not if that made rings cross
    std::pmr::vector<Point2> border_;  // rings as they are triangulated
    std::pmr::vector<uint32_t> next_;
    std::pmr::vector<uint32_t> owner_;  // the contour's point before or at it
    std::pmr::vector<uint32_t> kept_;   // of the ring that is thinned
    uint32_t ring_ = 0;
    std::optional<ContourTriangulation> triangulation_;
    Buffer<int32_t> number_;  // of triangles inside
    std::optional<PlaneMesh> mesh_;
    uint32_t inside_count_ = 0;
    uint32_t lattice_width_ = 0, lattice_height_ = 0;
    Point2 lattice_origin_{};
    Buffer<uint8_t> lattice_;  // bit 0: the border is crossed before it; bit 1: too near to the border
    bool inside_ = false;
    uint32_t lattice_row_ = UINT32_MAX;
    int32_t last_ = 0, row_first_ = 0;  // vertices added last, and first in the row
    uint32_t border_count_ = 0;
    uint32_t most_vertices_ = 0;  // for the sake of angles
    Buffer<int32_t> waiting_;     // triangles to look at, in a ring
    Buffer<uint8_t> is_waiting_;
    uint32_t first_waiting_ = 0, waiting_count_ = 0;
    uint32_t known_ = 0;  // triangles that is_waiting_ has an entry for
    bool refining_ = false;
    Pass pass_ = Pass::measure, then_ = Pass::clear;
    uint32_t at_ = 0, searched_ = 0;
};

}  // namespace flg
