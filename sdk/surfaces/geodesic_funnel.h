// SPDX-License-Identifier: MIT
// The shortest path within a sleeve of triangles: the sleeve is unfolded into the plane and a funnel is drawn through its
// gates (Lee, Preparata: Euclidean shortest paths in the presence of rectilinear barriers, 1984; linear time).
//
// A gate is the edge between two triangles of the sleeve; its right end is the vertex at its corner in the triangle
// before it, its left end the following vertex.
#pragma once

#include "surfaces/geodesic_sleeve.h"

namespace flg {

using Vec2 = Eigen::Vector2d;

inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

struct SleeveGate {
    Corner corner;     // in the triangle before it
    Vec2 right, left;  // metres, in the plane
};

// Where the path turns: at an end of a gate.
struct PathBend {
    uint32_t gate;  // the first that ends there; of the path's end: their count
    bool at_left;
    Vec2 at;
};

class GeodesicFunnel {
public:
    GeodesicFunnel(const Mesh& mesh, Memory* memory)
        : mesh_(mesh), gates_(memory), bends_(memory), left_(memory), right_(memory) {}

    // The sleeve is complete and outlives the run.
    void begin(const GeodesicSleeve& sleeve, const SurfacePlace& from, const SurfacePlace& to);
    // Spends units of about 50 ns, a gate each; true when done.
    bool run(uint32_t& units);

    const ReusedDeque<SleeveGate>& gates() const { return gates_; }
    // The last one is the path's end.
    const ReusedDeque<PathBend>& bends() const { return bends_; }
    const Vec2& start() const { return start_; }
    uint32_t end_vertex(uint32_t gate, bool left) const {
        const Corner corner = gates_[gate].corner;
        return mesh_.vertex_at(left ? next_corner(corner) : corner);
    }
    double length() const;

private:
    void unfold_first(uint32_t triangle, Corner exit);
    Vec2 unfold_apex() const;
    Corner exit_of(uint32_t index) const;
    uint32_t add(bool left, const PathBend& point);

    const Mesh& mesh_;
    const GeodesicSleeve* sleeve_ = nullptr;
    SurfacePlace from_{}, to_{};
    ReusedDeque<SleeveGate> gates_;
    ReusedDeque<PathBend> bends_;
    Vec2 start_{};
    PathBend apex_{};
    std::pmr::deque<PathBend> left_, right_;  // the walls of the funnel, from the apex
};

}  // namespace flg
