// SPDX-License-Identifier: MIT
// One path over a mesh with its lengths, and parts of it: what curves on surfaces are built from.
//
// Invariants
// - The stretch from point i to point i + 1 lies in the triangle that point i names; the last point names that of the
//   stretch before it. Stretches follow each other across edges or at a vertex.
// - A point at the same length of the same path has the same bits.
#pragma once

#include <vector>

#include "surfaces/mesh/surface_curves.h"

namespace flg {

struct SurfacePath {
    explicit SurfacePath(Memory* memory) : points(memory), lengths(memory) {}

    double length() const { return lengths.back(); }
    void clear() {
        points.clear();
        lengths.clear();
    }
    // `triangle`: where the next stretch lies; the point is seen from there.
    void add(const Mesh& mesh, const SurfacePoint& point);

    std::pmr::vector<SurfacePoint> points;
    std::pmr::vector<double> lengths;  // metres, from the first point on
};

// A little within its triangle, so that it lies on no edge for any step of tracing (snap_weight).
SurfacePoint moved_inside(uint32_t triangle, double u, double v);

// The point at a length, within its triangle: what begins or ends the part of a path.
SurfacePoint point_at(const Mesh& mesh, const SurfacePath& path, double length);

// The vector of a path's first stretch that has a length; zero if none has. `triangle`: where it lies.
Vec3 first_way(const Mesh& mesh, const SurfacePath& path, uint32_t& triangle);

// A path with its ends exchanged.
void reverse_path(const Mesh& mesh, const SurfacePath& path, SurfacePath& out);

// Part of a path, by lengths.
struct PathPart {
    const SurfacePath* path = nullptr;
    double begin = 0, end = 0;

    double length() const { return end - begin; }
    PathPart half(bool second) const {
        const double middle = 0.5 * (begin + end);
        return second ? PathPart{path, middle, end} : PathPart{path, begin, middle};
    }
};
inline PathPart whole(const SurfacePath& path) {
    return {&path, 0, path.length()};
}

// The ends of a part; those of a whole path are its own.
SurfacePoint first_point(const Mesh& mesh, const PathPart& part);
SurfacePoint last_point(const Mesh& mesh, const PathPart& part);

// Appends a part to a way whose last point, if it has one, is the part's first.
void append_part(const Mesh& mesh, const PathPart& part, SurfaceCurves& way);

}  // namespace flg
