// SPDX-License-Identifier: MIT
// Meshes whose answers are known, as text files.
#pragma once

#include <array>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

namespace flg::test {

// Without picking only vertices can be named.
#if defined(FLG_WITH_PICK)
constexpr bool kHasPicking = true;
constexpr const char* kPlace = "0.3,-0.4,0.5";
#else
constexpr bool kHasPicking = false;
constexpr const char* kPlace = "40";
#endif

using Point = std::array<double, 3>;

struct TestMesh {
    std::vector<Point> points;
    std::vector<std::array<size_t, 3>> triangles;

    std::string off() const {
        std::ostringstream text;
        text.precision(17);
        text << "OFF\n" << points.size() << " " << triangles.size() << " 0\n";
        for (const Point& p : points) text << p[0] << " " << p[1] << " " << p[2] << "\n";
        for (const auto& t : triangles) text << "3 " << t[0] << " " << t[1] << " " << t[2] << "\n";
        return text.str();
    }

    // Adds n x n squares, each halved: (u, v) in [0, 1] x [0, 1] goes to `place`. Vertices are row by row, from the
    // next number on.
    template <class Place>
    void add_grid(size_t n, Place place) {
        const size_t first = points.size();
        for (size_t j = 0; j <= n; ++j) {
            for (size_t i = 0; i <= n; ++i) {
                points.push_back(place(static_cast<double>(i) / static_cast<double>(n),
                                       static_cast<double>(j) / static_cast<double>(n)));
            }
        }
        for (size_t j = 0; j < n; ++j) {
            for (size_t i = 0; i < n; ++i) {
                const size_t a = first + j * (n + 1) + i, b = a + 1, d = a + n + 1, c = d + 1;
                triangles.push_back({a, b, c});
                triangles.push_back({a, c, d});
            }
        }
    }
};

// The unit square, z = 0.
inline TestMesh square(size_t n) {
    TestMesh mesh;
    mesh.add_grid(n, [](double u, double v) { return Point{u, v, 0.0}; });
    return mesh;
}

// The unit cube's six sides, in the order -x, +x, -y, +y, -z, +z, each with vertices of its own at the same places.
inline TestMesh cube(size_t n) {
    TestMesh mesh;
    for (size_t axis = 0; axis < 3; ++axis) {
        for (const double side : {0.0, 1.0}) {
            mesh.add_grid(n, [=](double u, double v) {
                Point p;
                p[axis] = side;
                p[(axis + 1) % 3] = side > 0.0 ? u : v;
                p[(axis + 2) % 3] = side > 0.0 ? v : u;
                return p;
            });
        }
    }
    return mesh;
}

// The sphere of radius 1 about the origin: a cube blown up.
inline TestMesh sphere(size_t n) {
    TestMesh mesh = cube(n);
    for (Point& p : mesh.points) {
        // Even steps of the angle along the edges of the cube.
        for (double& x : p) x = std::tan((x - 0.5) * std::acos(-1.0) / 2);
        const double length = std::hypot(p[0], p[1], p[2]);
        for (double& x : p) x /= length;
    }
    return mesh;
}

inline double distance(const Point& a, const Point& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

}  // namespace flg::test
