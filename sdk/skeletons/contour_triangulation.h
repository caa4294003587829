// SPDX-License-Identifier: MIT
// The triangulation of what is inside of a contour. Its points come in one by one, those near each other one after
// the other in each of a few rounds (Amenta, Choi, Rote: Incremental constructions con BRIO, 2003), and stay
// Delaunay; then each edge of the contour is made one of the triangulation by flipping what crosses it (Sloan: A fast
// algorithm for generating constrained Delaunay triangulations, 1993).
//
// Invariants
// - Orientations are exact: all triangles turn counter-clockwise at all times. So the contour is simple if and only
//   if all of its edges can be made, and what keeps one from it is the fault that is reported.
// - Circles are not exact, and after flips for the contour triangles are not made Delaunay again: nothing depends on
//   it but time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/memory.h"
#include "skeletons/contour_fault.h"
#include "skeletons/point2.h"

namespace flg {

// Where a number stands among three, one of which it is.
inline uint32_t place_in(const std::array<int32_t, 3>& three, int32_t number) {
    return three[0] == number ? 0 : three[1] == number ? 1 : 2;
}

class ContourTriangulation {
public:
    // neighbours[k] and is_edge[k] belong to the side across from vertices[k]. At the border of all the neighbour is
    // -1.
    struct Triangle {
        std::array<int32_t, 3> vertices, neighbours;
        std::array<bool, 3> is_edge;
    };

    // Rings follow each other: next[i] is the point after i on its ring; what is inside lies on the left. Coordinates
    // are within [-2, 2] and differ somewhere. Both outlive the kernel.
    ContourTriangulation(std::span<const Point2> points, std::span<const uint32_t> next, Memory* memory);

    // A unit is at most 0.5 us on the whole; true at the end, or at the first fault.
    bool run(uint32_t count) {
        for (; count > 0 && pass_ != Pass::done; --count) step();
        return pass_ == Pass::done;
    }
    const ContourFault& fault() const { return fault_; }
    uint32_t triangle_count() const { return count_; }
    const Triangle& triangle(uint32_t index) const { return triangles_[index]; }
    bool is_inside(uint32_t index) const { return inside_[index] != 0; }

private:
    enum class Pass {
        copy,
        zero,
        key,
        sum,
        sort,
        locate,
        legalize,
        join,
        aim,
        cross,
        clear,
        mark,
        seed,
        flood,
        check,
        done
    };
    struct Side {
        int32_t triangle;
        uint32_t k;  // no side: the triangle is -1
    };
    static constexpr uint32_t hops_a_unit = 16;
    static constexpr uint32_t batch = 32;  // points that are one unit where little is done with each

    static uint32_t after(uint32_t k) { return k == 2 ? 0 : k + 1; }
    static uint32_t before(uint32_t k) { return k == 0 ? 2 : k - 1; }
    void step();
    void enter(Pass pass) {
        pass_ = pass;
        at_ = 0;
    }
    void begin();
    void stop(ContourFault::Kind kind, int32_t first, int32_t second);
    uint32_t order_key(uint32_t point) const;
    void locate();
    void insert(int32_t vertex);
    void legalize();
    bool in_circle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) const;
    void flip(int32_t triangle, uint32_t k);
    uint32_t corner(int32_t triangle, int32_t vertex) const { return place_in(triangles_[triangle].vertices, vertex); }
    uint32_t side_to(int32_t triangle, int32_t neighbour) const {
        return place_in(triangles_[triangle].neighbours, neighbour);
    }
    int turn(int32_t a, int32_t b, int32_t c) const { return orientation(points_[a], points_[b], points_[c]); }
    Side find(int32_t a, int32_t b) const;
    void join();
    void aim();
    void cross();
    void clear();
    void mark(const Side& side);
    int32_t edge_between(int32_t a, int32_t b) const;
    void seed();
    void flood();
    void check();

    std::span<const uint32_t> next_;
    int32_t size_;
    Buffer<Point2> points_;  // the contour's and three around them
    Buffer<Triangle> triangles_;
    Buffer<int32_t> triangle_of_;  // by vertex, one of its triangles
    Buffer<uint32_t> order_, first_of_key_;
    Buffer<uint8_t> inside_;
    std::pmr::vector<int32_t> stack_;
    std::pmr::vector<std::array<int32_t, 2>> crossed_;  // sides that cross the edge that is being joined
    size_t crossed_at_ = 0, flips_left_ = 0;
    uint32_t count_ = 0;
    uint32_t levels_ = 0;  // rounds; each but the first has four times the cells of the one before
    std::span<const Point2> input_;
    Point2 low_{}, high_{};
    double extent_ = 0;
    Pass pass_ = Pass::copy;
    uint32_t at_ = 0;
    int32_t here_ = 0;   // where the search for the next point, or along the edge, is
    uint32_t side_ = 0;  // the side of that triangle through which the edge leaves, and its ends
    int32_t right_ = 0, left_ = 0;
    uint32_t search_ = 0;   // steps of it
    int32_t inserted_ = 0;  // the vertex whose triangles are on the stack
    int32_t ring_edge_ = 0;
    ContourFault fault_;
};

}  // namespace flg
