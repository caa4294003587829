// SPDX-License-Identifier: MIT
// A triangulation of what is inside of a contour, that takes more points: in its triangles, on its edges, on its border. After
// each point flips make it Delaunay again (Lawson: Software for C1 surface interpolation, 1977).
//
// Invariants
// - All triangles turn counter-clockwise, by exact signs; what would turn one is refused.
// - Sides without a neighbour are the border; flips never touch it.
// - Flips make no chord: no side inside gets both ends on the border that had not. It is Delaunay but for that.
#pragma once

#include <array>
#include <vector>

#include "core/memory.h"
#include "skeletons/contour_triangulation.h"
#include "skeletons/point2.h"

namespace flg {

class PlaneMesh {
public:
    struct Triangle {
        std::array<int32_t, 3> vertices, neighbours;  // neighbours[k] is across from vertices[k]; -1: none
    };
    struct Place {
        int32_t triangle;
        int32_t side;  // -1: inside; else the point is on this side, or beyond this side of the border
        bool beyond;
    };

    // Room for so many of each.
    PlaneMesh(size_t vertices, size_t triangles, Memory* memory);

    uint32_t vertex_count() const { return vertex_count_; }
    uint32_t triangle_count() const { return triangle_count_; }
    size_t vertex_capacity() const { return points_.size(); }
    const Point2& point(int32_t vertex) const { return points_[vertex]; }
    bool on_border(int32_t vertex) const { return border_[vertex] != 0; }
    const Triangle& triangle(int32_t index) const { return triangles_[index]; }
    int32_t triangle_of(int32_t vertex) const { return triangle_of_[vertex]; }

    // While it is filled.
    void add_vertex(const Point2& point, bool border);
    void add_triangle(const Triangle& triangle);
    // Has a triangle looked at by legalize().
    void check(int32_t triangle) { stack_.push_back(triangle); }

    // Walks at most `steps` triangles towards a point; a place without triangle (-1) if that was not enough.
    Place locate(int32_t from, const Point2& point, uint32_t steps) const;
    // Adds a point at a place that locate found, or a border point within rounding of side `side`. False, and nothing changed, if a triangle would
    // not turn counter-clockwise. Needs room for one vertex and two triangles.
    bool insert(int32_t triangle, int32_t side, const Point2& point);
    // Looks at one triangle that changed; true if none was left. Those that flips change are called for.
    template <class Changed>
    bool legalize(const Changed& changed) {
        if (stack_.empty()) return true;
        const int32_t t = stack_.back();
        stack_.pop_back();
        changed(t);
        for (uint32_t k = 0; k < 3; ++k) {
            if (!flips(t, k)) continue;
            const int32_t other = triangles_[t].neighbours[k];
            flip(t, k);
            stack_.push_back(t);
            stack_.push_back(other);
            break;
        }
        return stack_.empty();
    }
    bool is_chord(int32_t triangle, uint32_t side) const;

private:
    static uint32_t after(uint32_t k) { return k == 2 ? 0 : k + 1; }
    static uint32_t before(uint32_t k) { return k == 0 ? 2 : k - 1; }
    bool flips(int32_t triangle, uint32_t k) const;
    void flip(int32_t triangle, uint32_t k);
    void replace_neighbour(int32_t of, int32_t old, int32_t now);
    int turn(int32_t a, int32_t b, int32_t c) const { return orientation(points_[a], points_[b], points_[c]); }

    Buffer<Point2> points_;
    Buffer<uint8_t> border_;
    Buffer<int32_t> triangle_of_;
    Buffer<Triangle> triangles_;
    std::pmr::vector<int32_t> stack_;
    uint32_t vertex_count_ = 0, triangle_count_ = 0;
};

}  // namespace flg
