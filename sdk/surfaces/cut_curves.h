// SPDX-License-Identifier: MIT
// Embeds curves into the mesh: sec. 4.2 of Nazzaro, Puppo, Pellacini: geoTangle (2021) (all triangles that a polyline
// crosses are split), for any number of curves at once. They may cross, touch and meet, pass through vertices, run along
// edges, begin and end within a triangle.
//
// Invariants
// - Afterwards each curve is a chain of edges. Curves share a vertex where they cross.
// - Points move by no more than cut_tolerance: of an edge's length to its ends and to each other, of a triangle's height
//   to its edges. Segments that pass a vertex so near go through it; where dozens of them crowd in one triangle,
//   a curve may stray by a few tolerances.
// - Each triangle is divided by itself (cut_triangulation.h): edges are given their points first, so neighbours agree.
#pragma once

#include <deque>
#include <optional>

#include "surfaces/cut_places.h"
#include "surfaces/surface_curves.h"

namespace flg {

// Curve c runs through vertices offsets[c] to offsets[c + 1] - 1, joined by edges; a closed one from the last to the
// first, which is not repeated. A curve that was smaller than the tolerance may be a single vertex.
struct EmbeddedCurves {
    explicit EmbeddedCurves(Memory* memory) : vertices(memory), offsets(memory), edges(memory) { offsets.push_back(0); }

    std::pmr::deque<uint32_t> vertices;
    std::pmr::deque<uint32_t> offsets;
    std::pmr::deque<Corner> edges;  // all edges of the curves, each as one of its two corners or as both
};

class CurveCutter {
public:
    // All must outlive the run. `edit` is a new one; if the cutter throws for want of memory, it takes back what was
    // changed. Throws before any change if a point is outside of its triangle, or a stretch not within one triangle.
    // Memory while it runs: 16 bytes for 64 triangles, 36 bytes a point of the curves, about 300 bytes a cut triangle.
    CurveCutter(Mesh& mesh, MeshColumns& columns, const SurfaceCurves& curves, MeshEdit& edit, EmbeddedCurves& out,
                Memory* memory);

    // Spends `count` units of about 0.2 us; true when done. 64 triangles, a point or a cut triangle take one in each of
    // several passes, a segment within a triangle two and more. Where hundreds of segments meet in one triangle, each
    // takes more with their number.
    bool run(uint32_t count);
    // False as long as the mesh is as it was; then it may be destroyed.
    bool is_changing() const { return pass_ >= Pass::grow; }

private:
    enum class Stage { begin, borders, points, segments, improve, ways, pieces, end };
    enum class Pass { clear, mark, sum, collect, gather, number, divide, grow, place, write, chain, done };
    // What else a triangle to divide has. Its points and stretches are lists threaded through the points.
    struct Work {
        uint32_t first_stretch = no_index;
        std::array<uint32_t, 3> edge_points = {no_index, no_index, no_index};
        uint32_t first_inner = 0, inner_count = 0;  // vertices inside
        uint32_t first_piece = 0, piece_count = 0;
    };
    // Where a stretch leads along: its first vertex, then `count` more.
    struct Way {
        uint32_t start, first, count;
    };

    uint32_t size_of(Pass pass) const;
    void enter(Pass pass);
    uint32_t end_of_stretch(uint32_t point);
    void mark(uint32_t point);
    void collect(uint32_t word);
    void gather(uint32_t point);
    void number(uint32_t slot);
    void number_edge(uint32_t first_point, CutTriangle::Edge& edge);
    bool divide(uint32_t slot);
    uint32_t division_cost() const;
    void begin_division(const CutTriangle& cut, const Work& work);
    bool add_borders(const CutTriangle& cut);
    void add_ends(const CutTriangle& cut);
    void follow_way(const CutTriangle& cut, const Work& work);
    void begin_pieces(const CutTriangle& cut, Work& work);
    bool add_pieces(const CutTriangle& cut, const Work& work);
    void end_division(CutTriangle& cut, const Work& work);
    uint32_t local_vertex(const CutTriangle& cut, const CutPlace& place);
    uint32_t vertex_of(const CutTriangle& cut, const Work& work, uint32_t local) const;
    void place(uint32_t slot);
    void write(uint32_t slot);
    void chain(uint32_t point);

    Mesh& mesh_;
    MeshColumns& columns_;
    const SurfaceCurves& curves_;
    MeshEdit& edit_;
    EmbeddedCurves& out_;
    Memory* memory_;
    TriangleSet touched_;
    Buffer<CutTriangle> slots_;
    Buffer<Work> works_;
    Buffer<CutPlace> places_;        // of the points
    Buffer<uint32_t> next_;          // on the same edge
    Buffer<uint32_t> next_stretch_;  // in the same triangle
    Buffer<Way> ways_;
    std::pmr::deque<int32_t> along_;                      // of the new vertices on edges
    std::pmr::deque<CutTriangulation::Point> inner_;      // the new vertices inside
    std::pmr::deque<CutTriangulation::Triangle> pieces_;  // vertices of the mesh
    std::pmr::deque<uint32_t> way_vertices_;
    std::optional<MeshGrowth> growth_;
    PieceWriter writer_;
    CutTriangulation triangulation_;
    Pieces writing_;
    std::pmr::vector<uint32_t> sorted_;  // points of an edge
    std::pmr::vector<uint32_t> paths_;  // of the stretches of a triangle: their ends; then how many vertices, and these
    // The triangle being divided.
    Stage stage_ = Stage::begin;
    std::array<uint32_t, 3> first_local_{};  // vertex of each edge's points
    uint32_t stretch_ = no_index;            // the one that comes next
    size_t path_ = 0;                        // and where its ends, then its path, are in paths_
    size_t ends_ = 0;                        // how much of paths_ are ends
    uint32_t edge_ = 0, edge_point_ = 0;     // whose points are added next
    uint32_t piece_ = 0;                     // to be kept next
    uint32_t filled_ = 0;                    // slots
    uint64_t vertices_, triangles_;          // numbered so far
    uint32_t curve_ = 0;
    Pass pass_ = Pass::clear;
    uint32_t at_ = 0;
};

}  // namespace flg
